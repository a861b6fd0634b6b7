"""Parallel loops, here or on a cluster. The number of processes does not affect results or their order."""

import os
import signal
import sys
import warnings
from collections.abc import Callable, Generator, Iterator, Sequence
from contextlib import contextmanager
from functools import lru_cache
from multiprocessing import resource_tracker
from typing import Any

from joblib import Parallel, delayed
from threadpoolctl import ThreadpoolController

from placecat import compute
from placecat.compute import lifeline
from placecat.errors import PlacecatError
from placecat.progress import Progress


def workers() -> int:
    """Return the number of worker processes on the cluster, or on this machine if there is no cluster."""
    cluster = compute.cluster()
    return compute.local_workers() if cluster is None else cluster.workers()


def in_parallel(
    function: Callable[..., Any], tasks: Sequence[tuple[Any, ...]], description: str, **options: Any
) -> list[Any]:
    """Return all results of :func:`stream` as a list. The parameters and the order are the same."""
    return list(stream(function, tasks, description, **options))


def stream(
    function: Callable[..., Any],
    tasks: Sequence[tuple[Any, ...]],
    description: str,
    *,
    unit: str = "tasks",
    n_jobs: int | None = None,
    locally: bool = False,
) -> Iterator[Any]:
    """Call ``function(*task)`` for every task in parallel processes, with a progress line.

    Every call uses one thread in BLAS, OpenMP and OpenCV, since the number of threads can change the last
    bits of a sum. Yields the results in the order of `tasks`, each as soon as possible. Raises PlacecatError
    if a process on this machine was killed or memory ran out. Exceptions raised by `function` are re-raised
    here.

    Parameters
    ----------
    function
        A function that may read files but must not write any, since its process may run on another machine,
        or be killed and replaced.
    description, unit
        Text of the progress line, and a plural noun for the tasks.
    n_jobs
        Number of processes on this machine, by default :func:`placecat.compute.local_workers`.
    locally
        Never use a cluster; `function` may then write files.
    """
    cluster = None if locally else compute.cluster()
    if cluster is not None:
        results = cluster.run(single_threaded, [(function, task) for task in tasks])
    else:
        jobs = min(n_jobs or compute.local_workers(), max(len(tasks), 1))
        calls = (delayed(_in_worker)(os.getpid(), function, task) for task in tasks)
        with _without_ctrl_c():
            done = Parallel(n_jobs=jobs, return_as="generator")(calls)
        results = _explained(done, description, jobs)
    return iter(Progress(results, description=description, total=len(tasks), unit=unit))


@contextmanager
def _without_ctrl_c() -> Iterator[None]:
    """Delay Ctrl-C until the end of a block; worker processes started in the block ignore Ctrl-C.

    Threads and processes inherit the blocked signals of the thread that starts them.
    """
    # Start the joblib resource tracker now, because starting it later would unblock the signal.
    resource_tracker.ensure_running()
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


def _explained(results: Generator[Any], description: str, jobs: int) -> Iterator[Any]:
    from joblib.externals.loky.process_executor import TerminatedWorkerError

    fewer = f"run again with fewer than {jobs} workers: PLACECAT_WORKERS={max(1, jobs // 2)}"
    if jobs == 1:
        fewer = "run again with more memory"
    try:
        # `yield from` would close `results` before the block below.
        for result in results:  # noqa: UP028
            yield result
    except GeneratorExit:
        # A caller that stops early knows that results go unused, so silence joblib's warning.
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            results.close()
        raise
    except TerminatedWorkerError:
        raise PlacecatError(
            f"{description}: a worker process was killed, probably because memory ran out; {fewer}"
        ) from None
    except MemoryError:
        raise PlacecatError(f"{description}: memory ran out; {fewer}") from None


def _in_worker(parent: int, function: Callable[..., Any], task: tuple[Any, ...]) -> Any:
    if os.getpid() != parent:
        lifeline.end_with(parent)
    return single_threaded(function, task)


def single_threaded(function: Callable[..., Any], task: tuple[Any, ...]) -> Any:
    """Call ``function(*task)`` with one thread in BLAS, OpenMP and OpenCV."""
    import cv2

    cv2.setNumThreads(1)
    with _libraries(len(sys.modules)).limit(limits=1):
        return function(*task)


@lru_cache(maxsize=1)
def _libraries(modules: int) -> ThreadpoolController:
    """Find the loaded libraries that use threads; search again only after new imports."""
    return ThreadpoolController()
