"""Loops over homes and folds in parallel processes, in an order and with results that never depend on it."""

import os
from collections.abc import Callable, Sequence
from typing import Any

from joblib import Parallel, cpu_count, delayed
from threadpoolctl import threadpool_limits
from tqdm import tqdm


def workers() -> int:
    """Number of worker processes: the environment variable PLACECAT_WORKERS, else the cores of the machine.

    It is no setting in params.yaml, since no result depends on it.
    """
    value = os.environ.get("PLACECAT_WORKERS", "")
    return max(1, int(value)) if value.isdigit() else cpu_count()


def in_parallel(
    function: Callable[..., Any],
    tasks: Sequence[tuple[Any, ...]],
    description: str,
    *,
    n_jobs: int | None = None,
) -> list[Any]:
    """Call ``function(*task)`` for every task in parallel processes, with a progress bar.

    Every call is limited to one thread in BLAS, OpenMP and OpenCV, because the number of threads can change
    the last bits of a sum.

    Returns
    -------
    list
        The results in the order of `tasks`.
    """
    jobs = min(n_jobs or workers(), max(len(tasks), 1))
    calls = (delayed(single_threaded)(function, task) for task in tasks)
    results = Parallel(n_jobs=jobs, return_as="generator")(calls)
    return list(tqdm(results, total=len(tasks), desc=description, unit="task", mininterval=1.0))


def single_threaded(function: Callable[..., Any], task: tuple[Any, ...]) -> Any:
    """Call ``function(*task)`` with one thread in BLAS, OpenMP and OpenCV."""
    import cv2

    cv2.setNumThreads(1)
    with threadpool_limits(limits=1):
        return function(*task)
