"""``placecat worker``: worker processes of a Dask cluster that give the same bits as this machine."""

import importlib.util
import os
import sys
from collections.abc import Sequence
from typing import NoReturn

from placecat import compute
from placecat.errors import PlacecatError

# By default Dask's workers return freed memory at once, and describing a frame takes twice as long. See
# placecat.vision.memory, whose method has no effect if these are set.
_MEMORY = {"MALLOC_TRIM_THRESHOLD_": str(64 << 20), "MALLOC_MMAP_THRESHOLD_": str(32 << 20)}


def worker_command(scheduler: str, options: Sequence[str]) -> NoReturn:
    """Become distributed's ``dask worker`` with processes of one thread each, by default one per core.

    The import of placecat.stages has chosen the kernels of OpenBLAS, in the environment. `scheduler` is its
    address; `options` are further ones of ``dask worker``, e.g. ``["--nworkers", "4"]``. Raises PlacecatError
    if Dask is not installed.
    """
    if importlib.util.find_spec("distributed") is None:
        raise PlacecatError(
            "placecat worker needs the optional extra (distributed is missing): pip install -e '.[dask]'"
        )
    usual = ["--nthreads", "1", "--nworkers", str(compute.local_workers()), "--no-dashboard"]
    command = [sys.executable, "-m", "distributed.cli.dask_worker", scheduler, *usual, *options]
    os.execve(sys.executable, command, _MEMORY | os.environ)
