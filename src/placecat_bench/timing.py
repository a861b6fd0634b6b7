"""Wall times of alternating calls."""

import gc
import statistics
import time
from collections.abc import Callable
from functools import partial
from typing import Any


def time_in_turn(
    ours: Callable[[], Any], theirs: Callable[[], Any], *, repeats: int, warm_up: bool = True
) -> tuple[list[float], list[float]]:
    """Time pairs of calls A B, B A, A B, ..., so a temporary slowdown of the machine affects both.

    `warm_up` first calls each once, untimed. Returns `repeats` seconds of ours and of theirs.
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
    """Wall time of one call, after garbage collection."""
    gc.collect()
    start = time.perf_counter()
    call()
    return time.perf_counter() - start


def median_seconds(call: Callable[[], Any], repeats: int) -> float:
    """Median wall time of several calls."""
    return statistics.median(seconds(call) for _ in range(repeats))


class Latest:
    """Calls of ours and theirs that keep the last result, since it is compared too and may take minutes."""

    def __init__(self, ours: Callable[[], Any], theirs: Callable[[], Any]) -> None:
        self._calls = {"ours": ours, "theirs": theirs}
        self._results: dict[str, Any] = {}
        self.calls = partial(self.call, "ours"), partial(self.call, "theirs")

    def call(self, name: str) -> None:
        """Make the call of this name."""
        self._results[name] = self._calls[name]()

    def result(self, name: str) -> Any:
        """Result of the last call; make one if there was none."""
        if name not in self._results:
            self.call(name)
        return self._results[name]
