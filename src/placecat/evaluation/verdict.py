"""From intervals to verdicts on claims."""

from collections.abc import Collection
from dataclasses import dataclass

from placecat.evaluation.bootstrap import Interval

HOLDS = "holds"
FAILS = "does not hold"
UNDECIDED = "undecided"


@dataclass(frozen=True)
class Range:
    """The range that a claim allows for a difference: strictly between `low` and `high` (or infinite)."""

    low: float
    high: float

    def __str__(self) -> str:
        if self.high == float("inf"):
            return f"above {self.low:g}"
        if self.low == float("-inf"):
            return f"below {self.high:g}"
        return f"between {self.low:g} and {self.high:g}"

    def margin(self, interval: Interval) -> float:
        """Distance of the interval from the nearer end; negative if it reaches beyond."""
        return min(interval.low - self.low, self.high - interval.high)


def corrected_level(level: float, comparisons: int) -> float:
    """Level of each of several intervals so that all of them cover with probability `level` (Bonferroni).

    Holm's procedure starts with the same level, so it finds a failing comparison exactly where this does.
    With intervals of four or six units, each exactly on the edge of failing, one of 2, 5 or 14 independent
    comparisons fails in 3 to 5 % of 12000 simulations if units are normal, in 2 to 4 % if they are Student's
    with 3 degrees of freedom, but in 15 to 36 % if they are exponential with the long tail on the side of the
    claim, since intervals of so few skewed units are too short there.
    """
    return 1.0 - (1.0 - level) / comparisons


def judge(interval: Interval, claimed: Range, corrected: Interval | None = None) -> str:
    """Judge one comparison: `HOLDS`, `FAILS` or `UNDECIDED`.

    It holds if all of the interval is in the range. It fails if nothing of `corrected` is: the wider interval
    of a claim with several comparisons (:func:`corrected_level`), None for the same one.
    """
    if claimed.low < interval.low and interval.high < claimed.high:
        return HOLDS
    wide = corrected or interval
    if wide.high <= claimed.low or claimed.high <= wide.low:
        return FAILS
    return UNDECIDED


def combine(verdicts: Collection[str]) -> str:
    """Verdict on a claim with several comparisons: all must hold, and a single failure is enough.

    "All hold" needs no correction for their number: if one is false, that one alone must hold by chance (an
    intersection-union test). "One fails" does: each of k true ones may fail by chance, so `judge` uses the
    corrected interval for it.
    """
    if FAILS in verdicts:
        return FAILS
    return HOLDS if verdicts and set(verdicts) == {HOLDS} else UNDECIDED


def judge_shares(worse: Interval, better: Interval, rare: float) -> str:
    """Judge whether something hurts as well as helps.

    `worse` and `better` are the shares of the cases, 0 to 1, that it makes worse and better; `rare` is the
    largest share that counts as an exception. `HOLDS` if both whole intervals are above `rare`, `FAILS` if
    one of them is below it, else `UNDECIDED`. Two intervals of 95 % make a false `FAILS` in at most 5 %,
    since each errs in 2.5 % on its lower side.
    """
    if worse.low > rare and better.low > rare:
        return HOLDS
    return FAILS if min(worse.high, better.high) < rare else UNDECIDED
