"""From intervals to verdicts on what was claimed."""

from collections.abc import Collection
from dataclasses import dataclass

from placecat.evaluation.bootstrap import Interval

HOLDS = "holds"
FAILS = "does not hold"
UNDECIDED = "undecided"


@dataclass(frozen=True)
class Range:
    """Where a claim puts a difference: strictly between `low` and `high`, which may be infinite."""

    low: float
    high: float

    def __str__(self) -> str:
        if self.high == float("inf"):
            return f"above {self.low:g}"
        if self.low == float("-inf"):
            return f"below {self.high:g}"
        return f"between {self.low:g} and {self.high:g}"

    def margin(self, interval: Interval) -> float:
        """How far the interval stays from the nearer end; negative where it reaches beyond."""
        return min(interval.low - self.low, self.high - interval.high)


def judge(interval: Interval, claimed: Range) -> str:
    """`HOLDS` if the whole interval is in the range, `FAILS` if none of it is, else `UNDECIDED`."""
    if claimed.low < interval.low and interval.high < claimed.high:
        return HOLDS
    if interval.high <= claimed.low or claimed.high <= interval.low:
        return FAILS
    return UNDECIDED


def combine(verdicts: Collection[str]) -> str:
    """Verdict on a claim that makes several comparisons: all have to hold, and one that fails is enough.

    That all hold takes no correction for their number. That one fails by chance, of k that are barely true,
    is up to k times as likely as for a single one.
    """
    if FAILS in verdicts:
        return FAILS
    return HOLDS if verdicts and set(verdicts) == {HOLDS} else UNDECIDED
