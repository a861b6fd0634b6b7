"""The command ``placecat worker``: Dask workers that compute the same bits as this machine."""

import importlib.util
import os
import sys
from collections.abc import Sequence
from typing import NoReturn

from placecat import compute
from placecat.errors import PlacecatError

# By default, Dask workers return freed memory at once, which doubles the time to describe a frame. These
# variables override placecat.vision.memory.
_MEMORY = {"MALLOC_TRIM_THRESHOLD_": str(64 << 20), "MALLOC_MMAP_THRESHOLD_": str(32 << 20)}


def worker_command(scheduler: str, options: Sequence[str]) -> NoReturn:
    """Replace this process with ``dask worker``, with single-threaded processes, by default one per core.

    Importing placecat.stages has already chosen the OpenBLAS kernels through the environment. `scheduler` is
    an address; `options` are additional options of ``dask worker``, e.g. ``["--nworkers", "4"]``. Raises
    PlacecatError if Dask is not installed.
    """
    if importlib.util.find_spec("distributed") is None:
        raise PlacecatError(
            "placecat worker needs the optional extra (distributed is missing): pip install -e '.[dask]'"
        )
    usual = ["--nthreads", "1", "--nworkers", str(compute.local_workers()), "--no-dashboard"]
    command = [sys.executable, "-m", "distributed.cli.dask_worker", scheduler, *usual, *options]
    os.execve(sys.executable, command, _MEMORY | os.environ)
