"""Wall times of calls in turn."""

import gc
import statistics
import time
from collections.abc import Callable
from functools import partial
from typing import Any


def time_in_turn(
    ours: Callable[[], Any], theirs: Callable[[], Any], *, repeats: int, warm_up: bool = True
) -> tuple[list[float], list[float]]:
    """Time pairs of calls A B, B A, A B, ...: a temporary slowdown of the machine slows both.

    `warm_up` calls each once before, untimed. Returns the seconds of ours and of theirs, `repeats` each.
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
    """Wall time of one call, without the collection of garbage that others left."""
    gc.collect()
    start = time.perf_counter()
    call()
    return time.perf_counter() - start


def median_seconds(call: Callable[[], Any], repeats: int) -> float:
    """Median wall time of several calls."""
    return statistics.median(seconds(call) for _ in range(repeats))


class Latest:
    """Calls of ours and theirs whose last results are kept, since some take minutes and are compared too."""

    def __init__(self, ours: Callable[[], Any], theirs: Callable[[], Any]) -> None:
        self._calls = {"ours": ours, "theirs": theirs}
        self._results: dict[str, Any] = {}
        self.calls = partial(self.call, "ours"), partial(self.call, "theirs")

    def call(self, name: str) -> None:
        """Make a call by its name."""
        self._results[name] = self._calls[name]()

    def result(self, name: str) -> Any:
        """Result of the last call, which is made if there was none."""
        if name not in self._results:
            self.call(name)
        return self._results[name]
