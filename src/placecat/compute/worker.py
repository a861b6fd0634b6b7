"""Start the workers of a cluster, and run tasks on workers whose results match this machine's bit for bit."""

import contextlib
import importlib.util
import os
import pickle
import sys
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, NoReturn

from placecat import compute
from placecat.compute.fingerprint import fingerprint
from placecat.errors import PlacecatError

# By default, Dask workers return freed memory immediately, which doubles the time it takes to describe a
# frame. These variables override placecat.vision.memory.
_MEMORY = {"MALLOC_TRIM_THRESHOLD_": str(64 << 20), "MALLOC_MMAP_THRESHOLD_": str(32 << 20)}
# Marks (files in the project folder) that this worker has already seen.
_seen: set[str] = set()


def worker_command(scheduler: str, options: Sequence[str]) -> NoReturn:
    """Replace this process with ``dask worker`` and its single-threaded processes, by default one per core.

    Importing placecat.stages has already chosen the OpenBLAS kernels through the environment. `scheduler` is
    an address; `options` are additional options for ``dask worker``, such as ``["--nworkers", "4"]``. Raises
    PlacecatError if Dask is not installed.
    """
    if importlib.util.find_spec("distributed") is None:
        raise PlacecatError(
            "placecat worker needs the optional extra (distributed is missing): pip install -e '.[dask]'"
        )
    usual = ["--nthreads", "1", "--nworkers", str(compute.local_workers()), "--no-dashboard"]
    command = [sys.executable, "-m", "distributed.cli.dask_worker", scheduler, *usual, *options]
    os.execve(sys.executable, command, _MEMORY | os.environ)


@dataclass(frozen=True)
class Expected:
    """The requirements for a worker.

    `folder` is the absolute path of the project folder. `mark` is the path, relative to it, of a file that
    exists while the stage runs. `items` come from :func:`placecat.compute.fingerprint.fingerprint`; those in
    `may_differ` may differ. `scheduler` is the address of the scheduler, for messages.
    """

    scheduler: str
    folder: str
    mark: str
    items: Mapping[str, str]
    may_differ: tuple[str, ...] = ()


def objection(expected: Expected, dask_worker: Any = None) -> str | None:
    """Return why this Dask worker is unfit and how to fix that, or None if it is fit."""
    if dask_worker is None:
        from distributed import get_worker

        dask_worker = get_worker()
    name = f"worker {dask_worker.address}"
    start = f"`placecat worker {expected.scheduler}`"
    threads = dask_worker.state.nthreads
    if threads != 1:
        # All threads of a process share its working directory and its number of BLAS threads.
        return f"{name} has {threads} threads, but must have one: start it with {start}"
    here = fingerprint()
    different = [
        f"{item} ({here.get(item)} there, {value} here)"
        for item, value in expected.items.items()
        if here.get(item) != value and item not in expected.may_differ
    ]
    if different:
        return (
            f"{name} differs from this machine in {'; '.join(different)}, which can change results: restart "
            f"it with {start} in the same environment, or list what may differ in compute.may_differ"
        )
    if expected.mark not in _seen:
        if not (Path(expected.folder) / expected.mark).exists():
            return (
                f"{name} cannot see the project folder {expected.folder}: it must be at the same path, "
                "on a file system that both share"
            )
        _seen.add(expected.mark)
    return None


def perform(expected: Expected, call: bytes) -> bytes:
    """Run one task, a pickled pair of a function and its argument tuple, in the project folder.

    Every task checks its worker, since workers may join while a stage runs. Raises PlacecatError if the
    worker is unfit. The result is pickled, because unpickled arrays are writable, unlike arrays that Dask
    transfers.
    """
    import cloudpickle
    from joblib import parallel_config

    problem = objection(expected)
    if problem is not None:
        raise PlacecatError(problem)
    function, arguments = pickle.loads(call)
    # Loops within a task stay in its process.
    with contextlib.chdir(expected.folder), parallel_config(backend="threading", n_jobs=1):
        return bytes(cloudpickle.dumps(function(*arguments)))
