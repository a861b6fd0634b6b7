"""Measure the wall times of alternating calls."""

import gc
import statistics
import time
from collections.abc import Callable
from functools import partial
from typing import Any


def time_in_turn(
    ours: Callable[[], Any], theirs: Callable[[], Any], *, repeats: int, warm_up: bool = True
) -> tuple[list[float], list[float]]:
    """Time pairs of calls in the order A B, B A, A B, ..., so that a temporary slowdown affects both.

    `warm_up` first makes each call once, untimed. Returns the seconds of our and of their `repeats` calls.
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
    """Return the median wall time of several calls in seconds."""
    return statistics.median(seconds(call) for _ in range(repeats))


class Latest:
    """Our and their calls, with their last results, which are compared too and may take minutes."""

    def __init__(self, ours: Callable[[], Any], theirs: Callable[[], Any]) -> None:
        self._calls = {"ours": ours, "theirs": theirs}
        self._results: dict[str, Any] = {}
        self.calls = partial(self.call, "ours"), partial(self.call, "theirs")

    def call(self, name: str) -> None:
        """Make the call "ours" or "theirs", and keep its result."""
        self._results[name] = self._calls[name]()

    def result(self, name: str) -> Any:
        """Return the last call's result; make the call first if there was none."""
        if name not in self._results:
            self.call(name)
        return self._results[name]
