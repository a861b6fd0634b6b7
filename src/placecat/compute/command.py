"""``placecat worker``: start worker processes of a Dask cluster that give the same bits as this machine."""

import importlib.util
import os
import sys
from collections.abc import Sequence
from typing import NoReturn

from placecat import compute
from placecat.errors import PlacecatError

# Dask has workers return freed memory to the system at once, and describing a frame then takes twice as long:
# see placecat.vision.memory, whose way glibc does not heed where these are set.
_MEMORY = {"MALLOC_TRIM_THRESHOLD_": str(64 << 20), "MALLOC_MMAP_THRESHOLD_": str(32 << 20)}


def worker_command(scheduler: str, options: Sequence[str]) -> NoReturn:
    """Become distributed's ``dask worker`` with processes of one thread each.

    The kernels of OpenBLAS were chosen on the import of placecat.stages, in the environment.

    Parameters
    ----------
    scheduler
        Its address.
    options
        Further ones of ``dask worker``, e.g. ``["--nworkers", "4"]``; by default there are as many as cores.

    Raises
    ------
    PlacecatError
        If Dask is not installed.
    """
    if importlib.util.find_spec("distributed") is None:
        raise PlacecatError(
            "placecat worker needs the optional extra (distributed is missing): pip install -e '.[dask]'"
        )
    usual = ["--nthreads", "1", "--nworkers", str(compute.local_workers()), "--no-dashboard"]
    command = [sys.executable, "-m", "distributed.cli.dask_worker", scheduler, *usual, *options]
    os.execve(sys.executable, command, _MEMORY | os.environ)
