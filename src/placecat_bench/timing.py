"""Measure wall times, alternating between two calls."""

import gc
import statistics
import time
from collections.abc import Callable
from functools import partial
from typing import Any


def time_in_turn(
    ours: Callable[[], Any], theirs: Callable[[], Any], *, repeats: int, warm_up: bool = True
) -> tuple[list[float], list[float]]:
    """Time pairs of calls in the order A B, B A, A B, ..., so that temporary slowdowns affect both equally.

    With `warm_up`, each call is made once beforehand without being timed. Returns two lists of `repeats`
    times in seconds, ours and theirs.
    """
    if warm_up:
        ours()
        theirs()
    times: tuple[list[float], list[float]] = ([], [])
    for pair in range(repeats):
        for which in (0, 1) if pair % 2 == 0 else (1, 0):
            times[which].append(seconds((ours, theirs)[which]))
    return times


def seconds(call: Callable[[], Any]) -> float:
    """Return the wall time of one call in seconds, after garbage collection."""
    gc.collect()
    start = time.perf_counter()
    call()
    return time.perf_counter() - start


def median_seconds(call: Callable[[], Any], repeats: int) -> float:
    """Return the median wall time of several calls, in seconds."""
    return statistics.median(seconds(call) for _ in range(repeats))


class Latest:
    """A call that keeps its latest result, so that results can be compared without calling again."""

    def __init__(self, call: Callable[..., Any], *args: Any) -> None:
        self._call = partial(call, *args)

    def __call__(self) -> Any:
        """Make the call and return its result."""
        self._result = self._call()
        return self._result

    def result(self) -> Any:
        """Return the latest result. Make the call first if there is none yet."""
        return self._result if hasattr(self, "_result") else self()
