"""Judge the thesis's comparisons against this run's measurements."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from placecat import seeds
from placecat.errors import NotComputable
from placecat.evaluation.bootstrap import Interval
from placecat.evaluation.tail import share_below
from placecat.evaluation.verdict import FAILS, HOLDS, UNDECIDED, Range, corrected_level, judge, judge_shares
from placecat.results.measured import Results
from placecat.thesis.claims import Comparison, Side
from placecat.thesis.number import AVERAGE
from placecat.thesis.pairing import Paired, counted, pair, too_few
from placecat.thesis.pooling import Pooled, pool
from placecat.thesis.published import Published
from placecat.thesis.rules import Rules, claimed_range

_WHERE = {
    HOLDS: "the whole interval is {}",
    FAILS: "none of the interval is {}",
    UNDECIDED: "only part of the interval is {}",
}


class Thesis(NamedTuple):
    """The thesis's numbers: one per side, and their difference or ratio. Missing numbers are NaN."""

    numbers: tuple[float, ...]
    difference: float


@dataclass(frozen=True)
class Measurement:
    """This run's numbers for a comparison.

    Attributes
    ----------
    paired
        The measurements of the sides.
    numbers
        Each side's number, in percent.
    results
        The results used for each side.
    interval
        Interval for the difference or ratio, rounded to two decimals; its ends are NaN if there is only one
        unit.
    corrected
        The same interval at a level that allows for the number of comparisons in the finding.
    """

    paired: Paired | Pooled
    numbers: tuple[float, ...]
    results: tuple[tuple[str, ...], ...]
    interval: Interval
    corrected: Interval


@dataclass(frozen=True)
class Judged:
    """A comparison with its published and measured numbers and its verdict.

    `claimed` is None for ``both_signs``; `measurement` is None if a result is missing from this run.
    """

    comparison: Comparison
    thesis: Thesis
    claimed: Range | None
    measurement: Measurement | None
    verdict: str
    reason: str


def judge_comparison(
    finding: str,
    comparison: Comparison,
    rules: Rules,
    results: Results,
    published: Published,
    comparisons: int = 1,
) -> Judged:
    """Judge one comparison, which is undecided if measurements are missing.

    `finding` is the finding's name, from which the bootstrap's seed is derived. `comparisons` is the number
    of comparisons in the finding, all of which must hold. Raises PlacecatError for invalid settings.
    """
    measured, missing = None, ""
    try:
        paired = (
            pool(results, comparison.sides)
            if comparison.pooled
            else pair(results, comparison.sides, rules.few_homes)
        )
        measured = _measure(finding, comparison, rules, paired, comparisons)
    except NotComputable as error:
        missing = str(error)
    thesis = look_up(comparison, published, measured.paired.sides if measured else comparison.sides)
    claimed = claimed_range(comparison.range, thesis.difference, rules)
    if measured is None:
        return Judged(comparison, thesis, claimed, None, UNDECIDED, missing)
    if claimed is None:
        verdict, reason = judge_cases([measured], rules)
    elif reason := paired.too_few(rules.minimum_units):
        verdict = UNDECIDED
    else:
        verdict = judge(measured.interval, claimed, measured.corrected)
        reason = _reason(verdict, measured, claimed, corrected_level(rules.level, comparisons))
        reason += ", in these homes" if paired.at_hand else ""
    reason = "; ".join(filter(None, (reason, paired.note)))
    return Judged(comparison, thesis, claimed, measured, verdict, reason)


def judge_cases(measured: Sequence[Measurement], rules: Rules) -> tuple[str, str]:
    """Judge whether a change hurts in some cases and helps in others; return a verdict and its reason.

    A case is a pair of results in one home, or in all sequences if they are pooled. The homes may differ
    between comparisons. A case counts as worse or better only if the difference is noticeable with every
    seed. The shares of worse and better cases, however, are estimated from means over seeds. The verdict
    comes from :func:`placecat.evaluation.verdict.judge_shares`.
    """
    cases = [_gains(one.paired) for one in measured]
    worse = sum(int((one <= -rules.noticeable).all(axis=2).sum()) for one in cases)
    better = sum(int((one >= rules.noticeable).all(axis=2).sum()) for one in cases)
    gains = [of_home for one in cases for of_home in one.mean(axis=2).T]
    counts = f"worse in {worse}, better in {better} of {sum(map(len, gains))} cases"
    if len(gains) < rules.minimum_units:
        return UNDECIDED, f"{counts}; {too_few(counted(len(gains), 'home'))}"
    shares = [
        share_below([sign * gain for gain in gains], -rules.noticeable, level=rules.level)
        for sign in (1.0, -1.0)
    ]
    verdict = judge_shares(shares[0], shares[1], rules.rare)
    texts = [f"{100 * one.estimate:.0f}% ({100 * one.low:.0f} to {100 * one.high:.0f})" for one in shares]
    return verdict, (
        f"{counts}; worse by at least {rules.noticeable:g} points in {texts[0]}, better in {texts[1]} of all "
        f"cases; both must be above {100 * rules.rare:g}%"
    )


def look_up(comparison: Comparison, published: Published, sides: Sequence[Side]) -> Thesis:
    """Look up a comparison's published numbers.

    `sides` contains the comparison's sides, possibly without some of their results.
    """
    home = comparison.published_home or AVERAGE
    numbers = [_combine(side, _published(side, published, home)[:, None]) for side in sides]
    difference = _compare(comparison, numbers)[0]
    if comparison.published is not None:
        difference = published.number(comparison.published)
    return Thesis(tuple(float(number[0]) for number in numbers), float(difference))


def _measure(
    finding: str, comparison: Comparison, rules: Rules, paired: Paired | Pooled, comparisons: int
) -> Measurement:
    """Measure a comparison, with a bootstrap over its units; raise NotComputable if a ratio divides by 0."""

    def sides_of(values: Sequence[NDArray[np.float64]]) -> list[NDArray[np.float64]]:
        return [_combine(side, of_side) for side, of_side in zip(paired.sides, values, strict=True)]

    overall = paired.overall()
    numbers = sides_of(overall)
    estimate = float(_compare(comparison, numbers)[0])
    interval = corrected = Interval(estimate, float("nan"), float("nan"))
    if paired.n_units > 1:
        interval, corrected = (
            paired.interval(
                lambda values: _compare(comparison, sides_of(values)),
                seeds.derive("finding", finding, *(side.label for side in comparison.sides)),
                level,
                rules.resamples,
            )
            for level in (rules.level, corrected_level(rules.level, comparisons))
        )
    return Measurement(
        paired,
        numbers=tuple(float(one[0]) for one in numbers),
        results=tuple(_used(side, of_side) for side, of_side in zip(paired.sides, overall, strict=True)),
        interval=interval.rounded(),
        corrected=corrected.rounded(),
    )


def in_each_home(comparison: Comparison, paired: Paired) -> NDArray[np.float64]:
    """Return the (homes,) differences or ratios between the sides, computed from their means over seeds.

    Raises NotComputable if a ratio divides by 0.
    """
    sides = [
        _combine(side, values.mean(axis=2)) for side, values in zip(paired.sides, paired.values, strict=True)
    ]
    return _compare(comparison, sides)


def _reason(verdict: str, measured: Measurement, claimed: Range, level: float) -> str:
    if verdict == FAILS and measured.corrected != measured.interval:
        return f"none of the {percent(level)} interval is {claimed}"
    if verdict == UNDECIDED and judge(measured.interval, claimed) == FAILS:
        return f"none of the interval is {claimed}, but part of the {percent(level)} interval is"
    return _WHERE[verdict].format(claimed)


def percent(level: float) -> str:
    """Format a level as text, e.g. "95%" or "99.64%"."""
    return f"{100 * level:.4g}%"


def _combine(side: Side, values: NDArray[np.float64]) -> NDArray[np.float64]:
    """Combine a side's (results, n) values into (n,) values."""
    return values.max(axis=0) if side.combine == "best" else values.mean(axis=0)


def _compare(comparison: Comparison, sides: Sequence[NDArray[np.float64]]) -> NDArray[np.float64]:
    """Return the (n,) differences or ratios between two sides of (n,) values.

    A single side is compared with the number given for its range.
    """
    if len(sides) == 1:
        return sides[0] - (comparison.range[1] or 0.0)
    if comparison.compare == "difference":
        return sides[0] - sides[1]
    if (sides[1] == 0.0).any():
        raise NotComputable(
            f"{comparison.right.label if comparison.right else ''} can be 0, so there is no ratio"
        )
    return sides[0] / sides[1]


def _gains(paired: Paired | Pooled) -> NDArray[np.float64]:
    """Return the (results, homes, seeds) differences, left minus right, between the paired results.

    The array is empty if the sides cannot be paired.
    """
    if len(paired.values) == 2 and len(paired.values[0]) == len(paired.values[1]):
        return paired.values[0] - paired.values[1]
    return np.empty((0, *paired.values[0].shape[1:]))


def _used(side: Side, overall: NDArray[np.float64]) -> tuple[str, ...]:
    if side.combine == "best":
        return (side.results[int(overall[:, 0].argmax())],)
    return side.results


def _published(side: Side, published: Published, home: str) -> NDArray[np.float64]:
    if side.published is not None:
        numbers = [published.number(one, home) for one in side.published]
    elif side.place is not None or side.error:
        numbers = [float("nan")]
    else:
        numbers = [published.of_trial(name, home) for name in side.results]
    return np.array(numbers[-1:] if side.combine == "last" else numbers)
