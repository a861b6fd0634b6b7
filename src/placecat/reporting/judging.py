"""Judging one comparison of the thesis on what was measured."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from placecat import seeds
from placecat.errors import NotComputable
from placecat.evaluation.bootstrap import Interval, paired_bootstrap
from placecat.evaluation.verdict import FAILS, HOLDS, UNDECIDED, Range, judge
from placecat.reporting.claims import Comparison, Side
from placecat.reporting.pairing import Paired, pair
from placecat.reporting.published import AVERAGE, Published
from placecat.reporting.results import Results
from placecat.reporting.rules import Rules, claimed_range

_WHERE = {
    HOLDS: "the whole interval is {}",
    FAILS: "none of the interval is {}",
    UNDECIDED: "only a part of the interval is {}",
}


@dataclass(frozen=True)
class Thesis:
    """What the thesis has: a number of each side and their difference (or ratio), NaN for none."""

    numbers: tuple[float, ...]
    difference: float


@dataclass(frozen=True)
class Measurement:
    """What this run has.

    Attributes
    ----------
    numbers
        Of each side, percent.
    results
        Those that each side was made of in the end.
    interval
        Of the difference (or ratio), rounded to 2 decimals; NaN ends if there is a single unit.
    n_units, units
        Their number, and what they are.
    by_seed
        Whether they are seeds of a few homes.
    worse, better, cases
        A case is a result in a home; in how many the left was noticeably worse and better than the right,
        whatever the seed, and their number.
    note
        What was left out, "" for nothing.
    """

    numbers: tuple[float, ...]
    results: tuple[tuple[str, ...], ...]
    interval: Interval
    n_units: int
    units: str
    by_seed: bool
    worse: int
    better: int
    cases: int
    note: str


@dataclass(frozen=True)
class Judged:
    """One comparison, what the thesis and this run have of it, and the verdict.

    Attributes
    ----------
    claimed
        Where the claim puts the difference; None for ``both_signs``.
    measurement
        None if this run does not have all results; the reason says why.
    """

    comparison: Comparison
    thesis: Thesis
    claimed: Range | None
    measurement: Measurement | None
    verdict: str
    reason: str


def judge_comparison(
    finding: str, comparison: Comparison, rules: Rules, results: Results, published: Published
) -> Judged:
    """Judge one comparison.

    Parameters
    ----------
    finding
        Name of the finding that makes it; the bootstrap's seed is derived from it.

    Raises
    ------
    PlacecatError
        For settings that are wrong. What was not measured only makes the verdict undecided.
    """
    thesis = look_up(comparison, published)
    claimed = claimed_range(comparison.range, thesis.difference, rules)
    try:
        measured = measure(finding, comparison, rules, results)
    except NotComputable as error:
        return Judged(comparison, thesis, claimed, None, UNDECIDED, str(error))
    if claimed is None:
        verdict = HOLDS if measured.worse and measured.better else UNDECIDED
        reason = f"worse in {measured.worse}, better in {measured.better} of {measured.cases} cases"
    elif measured.n_units < rules.minimum_units:
        verdict, reason = UNDECIDED, f"{measured.units} are too few for a verdict"
    else:
        verdict = judge(measured.interval, claimed)
        reason = _WHERE[verdict].format(claimed) + (", in these homes" if measured.by_seed else "")
    if measured.note:
        reason += f"; {measured.note}"
    return Judged(comparison, thesis, claimed, measured, verdict, reason)


def look_up(comparison: Comparison, published: Published) -> Thesis:
    """Find the published numbers of a comparison."""
    home = comparison.published_home or AVERAGE
    numbers = [_combine(side, _published(side, published, home)[:, None]) for side in comparison.sides]
    difference = _compare(comparison, numbers)[0]
    if comparison.published is not None:
        difference = published.number(comparison.published)
    return Thesis(tuple(float(number[0]) for number in numbers), float(difference))


def measure(finding: str, comparison: Comparison, rules: Rules, results: Results) -> Measurement:
    """Measure a comparison, with the interval from a paired bootstrap over its units.

    Raises
    ------
    NotComputable
        If this run does not have all results on one home.
    """
    paired = pair(results, comparison.sides, rules.few_homes)
    by_unit = paired.by_unit()
    n_units = by_unit[0].shape[1]

    def sides_at(weights: NDArray[np.float64]) -> list[NDArray[np.float64]]:
        return [
            _combine(side, values @ weights.T) for side, values in zip(paired.sides, by_unit, strict=True)
        ]

    numbers = [float(one[0]) for one in sides_at(np.full((1, n_units), 1.0 / n_units))]
    if n_units > 1:
        interval = paired_bootstrap(
            lambda weights: _compare(comparison, sides_at(weights)),
            n_units,
            seeds.derive("finding", finding, *(side.label for side in comparison.sides)),
            level=rules.level,
            resamples=rules.resamples,
        )
    else:
        estimate = float(_compare(comparison, [np.array([one]) for one in numbers])[0])
        interval = Interval(estimate, float("nan"), float("nan"))
    gains = _gains(paired)
    return Measurement(
        numbers=tuple(numbers),
        results=tuple(_used(side, values) for side, values in zip(paired.sides, by_unit, strict=True)),
        interval=interval.rounded(),
        n_units=n_units,
        units=paired.units,
        by_seed=paired.by_seed,
        worse=int((gains <= -rules.noticeable).all(axis=2).sum()),
        better=int((gains >= rules.noticeable).all(axis=2).sum()),
        cases=gains[:, :, 0].size,
        note=paired.note,
    )


def _combine(side: Side, values: NDArray[np.float64]) -> NDArray[np.float64]:
    """(results, n) to (n,)."""
    return values.max(axis=0) if side.combine == "best" else values.mean(axis=0)


def _compare(comparison: Comparison, sides: Sequence[NDArray[np.float64]]) -> NDArray[np.float64]:
    """One or two (n,) to (n,)."""
    if len(sides) == 1:
        return sides[0] - (comparison.range[1] or 0.0)
    if comparison.compare == "difference":
        return sides[0] - sides[1]
    if (sides[1] == 0.0).any():
        raise NotComputable(f"{comparison.right.label if comparison.right else ''} can be 0: it has no ratio")
    return sides[0] / sides[1]


def _gains(paired: Paired) -> NDArray[np.float64]:
    """(results, homes, seeds): left minus right, result by result; empty if the sides have no such pairs."""
    if len(paired.values) == 2 and len(paired.values[0]) == len(paired.values[1]):
        return paired.values[0] - paired.values[1]
    return np.empty((0, len(paired.homes), 1))


def _used(side: Side, by_unit: NDArray[np.float64]) -> tuple[str, ...]:
    if side.combine == "best":
        return (side.results[int(by_unit.mean(axis=1).argmax())],)
    return side.results


def _published(side: Side, published: Published, home: str) -> NDArray[np.float64]:
    if side.published is not None:
        numbers = [published.number(one) for one in side.published]
    elif side.place is not None or side.error:
        numbers = [float("nan")]
    else:
        numbers = [published.of_trial(name, home) for name in side.results]
    return np.array(numbers[-1:] if side.combine == "last" else numbers)
