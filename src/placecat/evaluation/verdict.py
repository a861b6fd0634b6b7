"""Verdicts on claims, based on intervals."""

from collections.abc import Collection
from dataclasses import dataclass

from placecat.evaluation.bootstrap import Interval

HOLDS = "holds"
FAILS = "does not hold"
UNDECIDED = "undecided"
VERDICTS = (HOLDS, FAILS, UNDECIDED)


@dataclass(frozen=True)
class Range:
    """The open range of differences that a claim allows; its ends `low` and `high` may be infinite."""

    low: float
    high: float

    def __str__(self) -> str:
        if self.high == float("inf"):
            return f"above {self.low:g}"
        if self.low == float("-inf"):
            return f"below {self.high:g}"
        return f"between {self.low:g} and {self.high:g}"

    def margin(self, interval: Interval) -> float:
        """Return how far inside the range the interval lies. Negative if it extends past an end."""
        return min(interval.low - self.low, self.high - interval.high)


def corrected_level(level: float, comparisons: int) -> float:
    """Return the level that each interval needs for a joint level of `level` (Bonferroni).

    Holm's procedure starts at the same level, so it finds a failing comparison exactly when this level does.
    The level was checked in 12000 simulations, with intervals over four or six units and every comparison
    exactly on the edge of failing. At least one of 2, 5 or 14 independent comparisons fails in 3 to 5% of
    the simulations if units are normal, and in 2 to 4% if they follow Student's t with 3 degrees of freedom.
    The figure is 15 to 36% if units are exponential with the long tail on the side of the claim, because
    intervals over so few skewed units are too short.
    """
    return 1.0 - (1.0 - level) / comparisons


def judge(interval: Interval, claimed: Range, corrected: Interval | None = None) -> str:
    """Judge one comparison as `HOLDS`, `FAILS` or `UNDECIDED`.

    The comparison holds if `interval` lies entirely inside the range, and fails if `corrected` lies entirely
    outside it. `corrected` is the wider interval that a claim with several comparisons needs
    (:func:`corrected_level`). If it is None, `interval` is used.
    """
    if claimed.low < interval.low and interval.high < claimed.high:
        return HOLDS
    wide = corrected or interval
    if wide.high <= claimed.low or claimed.high <= wide.low:
        return FAILS
    return UNDECIDED


def combine(verdicts: Collection[str]) -> str:
    """Combine the verdicts on the comparisons of a claim. It holds if all hold, and fails if any fails.

    "All hold" needs no correction for the number of comparisons. The conclusion is wrong only if a false
    comparison holds by chance (an intersection-union test). "Any fails" does need a correction, because each
    of k true comparisons may fail by chance. So `judge` uses the corrected interval.
    """
    if FAILS in verdicts:
        return FAILS
    return HOLDS if verdicts and set(verdicts) == {HOLDS} else UNDECIDED


def judge_shares(worse: Interval, better: Interval, rare: float) -> str:
    """Judge whether a change hurts in some cases and helps in others.

    `worse` is the interval for the share of cases, from 0 to 1, that the change makes worse, and `better` is
    the interval for the share that it makes better. `rare` is the largest share that still counts as an
    exception. The verdict is `HOLDS` if both intervals lie entirely above `rare`, `FAILS` if either lies
    entirely below it, and `UNDECIDED` otherwise. With two 95% intervals, a false `FAILS` occurs at most 5%
    of the time, because each interval is too low 2.5% of the time.
    """
    if worse.low > rare and better.low > rare:
        return HOLDS
    return FAILS if min(worse.high, better.high) < rare else UNDECIDED
