"""Wall times of calls in turn."""

import gc
import statistics
import time
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True)
class Pairs:
    """Seconds of two calls made in turn, a pair after the other.

    Attributes
    ----------
    ours, theirs
        Seconds, of the same length.
    """

    ours: tuple[float, ...]
    theirs: tuple[float, ...]


def time_in_turn(
    ours: Callable[[], Any], theirs: Callable[[], Any], *, repeats: int, warm_up: bool = True
) -> Pairs:
    """Time two calls A B, B A, A B, ...: what slows the machine for a while slows both.

    Parameters
    ----------
    repeats
        Pairs.
    warm_up
        Whether to call each once before, untimed.
    """
    if warm_up:
        ours()
        theirs()
    times: dict[int, list[float]] = {0: [], 1: []}
    for pair in range(repeats):
        for which in (0, 1) if pair % 2 == 0 else (1, 0):
            times[which].append(seconds((ours, theirs)[which]))
    return Pairs(tuple(times[0]), tuple(times[1]))


def seconds(call: Callable[[], Any]) -> float:
    """Wall time of one call, without the collection of garbage that others left."""
    gc.collect()
    start = time.perf_counter()
    call()
    return time.perf_counter() - start


def median_seconds(call: Callable[[], Any], repeats: int) -> float:
    """Median wall time of several calls."""
    return statistics.median(seconds(call) for _ in range(repeats))
