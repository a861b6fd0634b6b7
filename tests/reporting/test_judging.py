import dataclasses

import numpy as np
import pandas as pd
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from made_accuracies import measured, results

from placecat.evaluation.verdict import FAILS, HOLDS, UNDECIDED, Range
from placecat.reporting.claims import Comparison, Side
from placecat.reporting.judging import judge_comparison
from placecat.reporting.published import Published
from placecat.reporting.rules import Rules

RULES = Rules(level=0.95, resamples=2000, minimum_units=4, few_homes=2, about=0.5, margin=2.0, noticeable=1.0)
INFINITE = float("inf")
NUMBERS = pd.DataFrame(
    [("points", "", "", 3.0), ("best", "", "", 40.0), ("worst", "", "", 30.0)],
    columns=["name", "quantity", "home", "value"],
)
PUBLISHED = Published(pd.DataFrame(columns=["table", "group", "row", "column", "value"]), NUMBERS)
HOMES = np.array([30.0, 45.0, 38.0, 51.0, 27.0, 42.0])


def shifted(gains):
    return HOMES + np.array(gains)


def compare(left, right=None, kind="better", number=None, rules=RULES, **options):
    named = {"left": left} if right is None else {"left": left, "right": right}
    sides = [Side(name, (name,)) for name in named]
    comparison = Comparison(sides[0], sides[1] if right is not None else None, (kind, number), **options)
    return judge_comparison("finding_01", comparison, rules, results(**named), PUBLISHED)


def test_what_is_better_in_every_home_alike_holds():
    judged = compare(measured(shifted([3, 4, 5, 3, 4, 5])), measured(HOMES))
    assert judged.verdict == HOLDS
    assert judged.reason == "the whole interval is above 0"
    assert judged.measurement.units == "6 homes"
    assert judged.measurement.interval.estimate == 4.0
    assert 2.5 < judged.measurement.interval.low < 4.0 < judged.measurement.interval.high < 5.5


def test_pairing_cancels_what_homes_share():
    """Homes differ by 24 points, the sides by 1 in each."""
    judged = compare(measured(HOMES + 1), measured(HOMES))
    interval = judged.measurement.interval
    assert (interval.low, interval.estimate, interval.high) == (1.0, 1.0, 1.0)
    assert judged.verdict == HOLDS


def test_swapped_sides_turn_holds_into_does_not_hold():
    left, right = measured(shifted([3, 4, 5, 3, 4, 5])), measured(HOMES)
    assert compare(right, left).verdict == FAILS
    assert compare(right, left, "worse").verdict == HOLDS


def test_what_differs_between_homes_is_undecided():
    judged = compare(measured(shifted([9, -8, 7, -6, 5, -2])), measured(HOMES))
    assert judged.verdict == UNDECIDED
    assert judged.reason == "only a part of the interval is above 0"


def test_two_homes_are_judged_by_their_seeds():
    judged = compare(measured([[35, 40], [36, 41]]), measured([[30, 36], [31, 35]]))
    assert judged.measurement.units == "2 homes x 2 seeds"
    assert judged.verdict == HOLDS
    assert judged.reason.endswith(", in these homes")


def test_too_few_units_are_undecided_whatever_they_say():
    judged = compare(measured([90, 90]), measured([10, 10]))
    assert (judged.verdict, judged.reason) == (UNDECIDED, "2 homes are too few for a verdict")
    judged = compare(measured([90]), measured([10]))
    assert judged.verdict == UNDECIDED
    assert judged.measurement.interval.estimate == 80.0
    assert np.isnan(judged.measurement.interval.low)


def test_a_result_that_is_missing_is_undecided_with_its_reason():
    comparison = Comparison(Side("left", ("a",)), Side("right", ("b",)), ("better", None))
    found = results({("b", "home_1"): "too few frames"}, a=measured(HOMES))
    judged = judge_comparison("finding_01", comparison, RULES, found, PUBLISHED)
    assert (judged.verdict, judged.reason, judged.measurement) == (UNDECIDED, "b: too few frames", None)


def test_a_side_can_be_compared_with_a_number():
    judged = compare(measured([99.5, 99.6, 99.7, 99.6]), kind="above", number=99.0)
    assert (judged.verdict, judged.measurement.interval.estimate) == (HOLDS, 0.6)
    assert judged.measurement.numbers == pytest.approx([99.6])
    assert compare(measured([98.5, 98.6, 98.7, 98.6]), kind="above", number=99.0).verdict == FAILS


def test_a_ratio():
    left, right = measured([[30.0], [33.0], [27.0], [30.0]]), measured([[10.0], [11.0], [9.0], [10.0]])
    judged = compare(left, right, "about", compare="ratio", published={"text": "points"})
    assert judged.measurement.units == "1 home x 4 seeds"
    assert (judged.thesis.difference, judged.claimed) == (3.0, Range(1.5, 4.5))
    assert judged.measurement.interval.estimate == 3.0
    assert judged.verdict == HOLDS


def test_nothing_is_divided_by_zero():
    judged = compare(measured([1, 2, 3]), measured([0, 0, 0]), compare="ratio")
    assert (judged.verdict, judged.reason) == (UNDECIDED, "right can be 0: it has no ratio")


def test_best_is_compared_with_the_best():
    named = {"a": measured(HOMES), "b": measured(HOMES + 5), "c": measured(HOMES + 4)}
    left = Side("best", ("a", "b"), combine="best", published=({"text": "worst"}, {"text": "best"}))
    comparison = Comparison(left, Side("c", ("c",), published=({"text": "worst"},)), ("better", None))
    judged = judge_comparison("finding_01", comparison, RULES, results(**named), PUBLISHED)
    assert judged.measurement.results == (("b",), ("c",))
    assert judged.measurement.interval.estimate == 1.0
    assert judged.thesis.numbers == (40.0, 30.0)
    assert judged.thesis.difference == 10.0


@pytest.mark.parametrize(
    ("gains", "counts", "verdict"),
    [
        ([3, 2, 4, 1, 5, -2], (1, 5), HOLDS),
        ([3, 2, 4, 1, 5, -0.5], (0, 5), UNDECIDED),
        ([-3, -2, -4, -1, -5, -2], (6, 0), UNDECIDED),
    ],
)
def test_both_signs_takes_one_home_each(gains, counts, verdict):
    judged = compare(measured(shifted(gains)), measured(HOMES), "both_signs")
    assert (judged.measurement.worse, judged.measurement.better) == counts
    assert judged.verdict == verdict


def test_both_signs_takes_every_seed():
    """Worse with one seed and better with the other is neither."""
    left = measured([shifted([-2, 2, 0, 0, 0, 0]), shifted([2, 2, 0, 0, 0, 0])])
    judged = compare(left, measured([HOMES, HOMES]), "both_signs")
    assert (judged.measurement.worse, judged.measurement.better) == (0, 1)


@settings(deadline=None, max_examples=30)
@given(
    st.lists(st.floats(-20, 20), min_size=6, max_size=6), st.floats(0, 10), st.floats(0, 10), st.booleans()
)
def test_a_wider_margin_never_makes_a_verdict_worse(gains, margin, more, one_sided):
    order, kind = [FAILS, UNDECIDED, HOLDS], "no_better" if one_sided else "little"
    verdicts = [
        compare(
            measured(shifted(gains)), measured(HOMES), kind, rules=dataclasses.replace(RULES, margin=points)
        ).verdict
        for points in (margin, margin + more)
    ]
    assert order.index(verdicts[0]) <= order.index(verdicts[1])
