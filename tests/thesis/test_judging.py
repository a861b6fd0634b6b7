import dataclasses

import numpy as np
import pandas as pd
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from made_accuracies import measured, results

from number_of_examples import examples
from placecat.evaluation.verdict import FAILS, HOLDS, UNDECIDED, Range
from placecat.thesis.claims import Comparison, Side
from placecat.thesis.judging import judge_comparison
from placecat.thesis.published import Published
from placecat.thesis.rules import Rules

RULES = Rules(
    level=0.95, resamples=2000, minimum_units=4, few_homes=2, about=0.5, margin=2.0, noticeable=1.0, rare=0.05
)
INFINITE = float("inf")
NUMBERS = pd.DataFrame(
    [("points", "", "", 3.0), ("best", "", "", 40.0), ("worst", "", "", 30.0)],
    columns=["name", "quantity", "home", "value"],
)
PUBLISHED = Published(pd.DataFrame(columns=["table", "group", "row", "column", "value"]), NUMBERS)
HOMES = np.array([30.0, 45.0, 38.0, 51.0, 27.0, 42.0])


def shifted(gains):
    return HOMES + np.array(gains)


def compare(left, right=None, kind="better", number=None, rules=RULES, comparisons=1, **options):
    named = {"left": left} if right is None else {"left": left, "right": right}
    sides = [Side(name, (name,)) for name in named]
    comparison = Comparison(sides[0], (kind, number), *sides[1:], **options)
    return judge_comparison("finding_01", comparison, rules, results(**named), PUBLISHED, comparisons)


def test_an_equal_gain_in_every_home_holds():
    judged = compare(measured(shifted([3, 4, 5, 3, 4, 5])), measured(HOMES))
    assert judged.verdict == HOLDS
    assert judged.reason == "the whole interval is above 0"
    assert judged.measurement.paired.units == "6 homes"
    assert judged.measurement.interval.estimate == 4.0
    assert 2.5 < judged.measurement.interval.low < 4.0 < judged.measurement.interval.high < 5.5


def test_pairing_cancels_effects_of_homes():
    """Homes differ by 24 points, but in each home the sides differ by only 1 point."""
    judged = compare(measured(HOMES + 1), measured(HOMES))
    interval = judged.measurement.interval
    assert (interval.low, interval.estimate, interval.high) == (1.0, 1.0, 1.0)
    assert judged.verdict == HOLDS


def test_swapping_the_sides_reverses_the_verdict():
    left, right = measured(shifted([3, 4, 5, 3, 4, 5])), measured(HOMES)
    assert compare(right, left).verdict == FAILS
    assert compare(right, left, "worse").verdict == HOLDS


def test_gains_with_mixed_signs_are_undecided():
    judged = compare(measured(shifted([9, -8, 7, -6, 5, -2])), measured(HOMES))
    assert judged.verdict == UNDECIDED
    assert judged.reason == "only part of the interval is above 0"


def test_two_homes_are_judged_by_their_seeds():
    judged = compare(measured([[35, 40], [36, 41]]), measured([[30, 36], [31, 35]]))
    assert judged.measurement.paired.units == "2 homes x 2 seeds"
    assert judged.verdict == HOLDS
    assert judged.reason.endswith(", in these homes")


def test_too_few_units_are_always_undecided():
    judged = compare(measured([90, 90]), measured([10, 10]))
    assert (judged.verdict, judged.reason) == (UNDECIDED, "2 homes are too few for a verdict")
    judged = compare(measured([90]), measured([10]))
    assert (judged.verdict, judged.reason) == (UNDECIDED, "1 home is too few for a verdict")
    assert judged.measurement.interval.estimate == 80.0
    assert np.isnan(judged.measurement.interval.low)


def test_a_missing_result_is_undecided_with_its_reason():
    comparison = Comparison(Side("left", ("a",)), ("better", None), Side("right", ("b",)))
    found = results({("b", "home_1"): "too few frames"}, a=measured(HOMES))
    judged = judge_comparison("finding_01", comparison, RULES, found, PUBLISHED)
    assert (judged.verdict, judged.reason, judged.measurement) == (UNDECIDED, "b: too few frames", None)


def test_a_side_can_be_compared_with_a_number():
    judged = compare(measured([99.5, 99.6, 99.7, 99.6]), kind="above", number=99.0)
    assert (judged.verdict, judged.measurement.interval.estimate) == (HOLDS, 0.6)
    assert judged.measurement.numbers == pytest.approx([99.6])
    assert compare(measured([98.5, 98.6, 98.7, 98.6]), kind="above", number=99.0).verdict == FAILS


def test_ratios_are_judged():
    left, right = measured([[30.0], [33.0], [27.0], [30.0]]), measured([[10.0], [11.0], [9.0], [10.0]])
    judged = compare(left, right, "about", compare="ratio", published={"text": "points"})
    assert judged.measurement.paired.units == "1 home x 4 seeds"
    assert (judged.thesis.difference, judged.claimed) == (3.0, Range(1.5, 4.5))
    assert judged.measurement.interval.estimate == 3.0
    assert judged.verdict == HOLDS


def test_a_zero_denominator_is_undecided():
    judged = compare(measured([1, 2, 3]), measured([0, 0, 0]), compare="ratio")
    assert (judged.verdict, judged.reason) == (UNDECIDED, "right can be 0, so there is no ratio")


def test_best_selects_the_best_result():
    named = {"a": measured(HOMES), "b": measured(HOMES + 5), "c": measured(HOMES + 4)}
    left = Side("best", ("a", "b"), combine="best", published=({"text": "worst"}, {"text": "best"}))
    comparison = Comparison(left, ("better", None), Side("c", ("c",), published=({"text": "worst"},)))
    judged = judge_comparison("finding_01", comparison, RULES, results(**named), PUBLISHED)
    assert judged.measurement.results == (("b",), ("c",))
    assert judged.measurement.interval.estimate == 1.0
    assert judged.thesis.numbers == (40.0, 30.0)
    assert judged.thesis.difference == 10.0


@pytest.mark.parametrize(
    ("gains", "counts", "verdict"),
    [
        # It hurts as often as it helps.
        ([8, -7, 9, -8, 6, -6], (3, 3), HOLDS),
        # It helps equally in every home, so it cannot hurt in one of twenty.
        ([5, 5.5, 4.8, 5.2, 5.1, 4.9], (0, 6), FAILS),
        ([-5, -5.5, -4.8, -5.2, -5.1, -4.9], (6, 0), FAILS),
        # It changes nothing.
        ([0.1, -0.1, 0.2, 0, -0.2, 0.1], (0, 0), FAILS),
        # It hurts in one home; the number of others is unknown.
        ([3, 2, 4, 1, 5, -2], (1, 5), UNDECIDED),
    ],
)
def test_both_signs_needs_enough_cases_of_each_sign(gains, counts, verdict):
    judged = compare(measured(shifted(gains)), measured(HOMES), "both_signs")
    assert judged.verdict == verdict
    assert judged.reason.startswith(
        f"worse in {counts[0]}, better in {counts[1]} of 6 cases; worse by at least 1 points"
    )


def test_both_signs_needs_enough_homes():
    judged = compare(measured([40, 50, 30]), measured([45, 45, 35]), "both_signs")
    assert judged.verdict == UNDECIDED
    assert judged.reason.endswith("3 homes are too few for a verdict")


def test_both_signs_requires_agreement_of_all_seeds():
    """A case that is worse with one seed and better with the other counts as neither."""
    left = measured([shifted([-2, 2, 0, 0, 0, 0]), shifted([2, 2, 0, 0, 0, 0])])
    judged = compare(left, measured([HOMES, HOMES]), "both_signs")
    assert judged.reason.startswith("worse in 0, better in 1 of 6 cases")


@settings(deadline=None, max_examples=examples(30))
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


def test_a_comparison_that_fails_alone_need_not_fail_among_many():
    """Its 95% interval is below 0, but the interval that allows for 14 comparisons is not."""
    left, right = measured(shifted([-3, -4, -1, -2.5, -0.5, -3.5])), measured(HOMES)
    alone = compare(left, right)
    assert (alone.verdict, alone.reason) == (FAILS, "none of the interval is above 0")
    assert alone.measurement.corrected == alone.measurement.interval
    among = compare(left, right, comparisons=14)
    assert among.verdict == UNDECIDED
    assert among.reason == "none of the interval is above 0, but part of the 99.64% interval is"
    assert among.measurement.interval == alone.measurement.interval
    assert among.measurement.corrected.low < among.measurement.interval.low
    clear = compare(measured(HOMES - 4), right, comparisons=14)
    assert (clear.verdict, clear.measurement.results) == (FAILS, (("left",), ("right",)))
    # A claim that holds needs no correction.
    assert compare(right, left, comparisons=14).verdict == HOLDS


def test_the_published_number_follows_the_measured_result():
    """``last`` and ``best`` choose among the measured results, and the published numbers follow."""
    cells = ({"text": "points"}, {"text": "best"}, {"text": "worst"})
    found = results({("c", "home_1"): "too few frames"}, a=measured(HOMES), b=measured(HOMES + 1))
    for combine, published, used in (("last", 40.0, "b"), ("best", 40.0, "b"), ("mean", 21.5, "a")):
        left = Side("left", ("a", "b", "c"), combine=combine, published=cells)
        right = Side("right", ("a", "b", "c"), published=cells)
        comparison = Comparison(left, ("better", None), right)
        judged = judge_comparison("finding_01", comparison, RULES, found, PUBLISHED)
        assert judged.thesis.numbers == (published, 21.5)
        assert used in judged.measurement.results[0]
