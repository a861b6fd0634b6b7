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


def corrected_level(level: float, comparisons: int) -> float:
    """Level of each of several intervals so that, with probability `level`, all of them cover (Bonferroni).

    Holm's procedure starts with the same level, so that it finds one comparison failing exactly where this
    does. With intervals of four or six units, of which each is exactly on the edge of failing, one of 2, 5
    or 14 independent comparisons fails in 3 to 5 % of 12000 simulations where units are normal, in 2 to 4 %
    where they are Student's with 3 degrees of freedom; but in 15 to 36 % where they are exponential with the
    long tail on the side of the claim, since intervals of so few skewed units are too short there.

    Parameters
    ----------
    level
        Between 0 and 1.
    comparisons
        How many, at least 1.
    """
    return 1.0 - (1.0 - level) / comparisons


def judge(interval: Interval, claimed: Range, corrected: Interval | None = None) -> str:
    """Judge one comparison.

    Parameters
    ----------
    interval
        `HOLDS` if the whole of it is in the range.
    corrected
        `FAILS` if none of it is in the range: the wider interval of a claim that makes several comparisons
        (:func:`corrected_level`); None for the same interval.
    """
    if claimed.low < interval.low and interval.high < claimed.high:
        return HOLDS
    wide = corrected or interval
    if wide.high <= claimed.low or claimed.high <= wide.low:
        return FAILS
    return UNDECIDED


def combine(verdicts: Collection[str]) -> str:
    """Verdict on a claim that makes several comparisons: all have to hold, and one that fails is enough.

    That all hold takes no correction for their number: if one of them is false, it alone has to hold by
    chance (an intersection-union test). That one fails does: of k that are true, each may fail by chance, so
    `judge` takes the corrected interval for that.
    """
    if FAILS in verdicts:
        return FAILS
    return HOLDS if verdicts and set(verdicts) == {HOLDS} else UNDECIDED


def judge_shares(worse: Interval, better: Interval, rare: float) -> str:
    """Judge that something can hurt as well as help.

    Parameters
    ----------
    worse, better
        Shares of the cases that it makes worse and better, from 0 to 1.
    rare
        Share up to which a case is an exception.

    Returns
    -------
    `HOLDS` if both shares are above `rare` with their whole interval, `FAILS` if one of them is below it with
    its whole interval, else `UNDECIDED`. Two intervals of 95 % make a false `FAILS` in at most 5 %, since
    each errs in 2.5 % to its lower side.
    """
    if worse.low > rare and better.low > rare:
        return HOLDS
    return FAILS if min(worse.high, better.high) < rare else UNDECIDED
