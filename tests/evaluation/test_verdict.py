import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from placecat.evaluation.bootstrap import Interval, paired_bootstrap
from placecat.evaluation.verdict import (
    FAILS,
    HOLDS,
    UNDECIDED,
    Range,
    combine,
    corrected_level,
    judge,
    judge_shares,
)

INFINITE = float("inf")
NUMBER = st.floats(-100, 100)
PAIR = st.tuples(NUMBER, NUMBER).map(sorted)


def interval(low, high):
    return Interval((low + high) / 2, low, high)


@pytest.mark.parametrize(
    ("low", "high", "claimed", "verdict"),
    [
        (0.1, 3.0, Range(0.0, INFINITE), HOLDS),
        (0.0, 3.0, Range(0.0, INFINITE), UNDECIDED),
        (-1.0, 3.0, Range(0.0, INFINITE), UNDECIDED),
        (-3.0, -1.0, Range(0.0, INFINITE), FAILS),
        (0.0, 0.0, Range(0.0, INFINITE), FAILS),
        (-1.9, 1.9, Range(-2.0, 2.0), HOLDS),
        (-1.9, 2.1, Range(-2.0, 2.0), UNDECIDED),
        (-9.0, 9.0, Range(-2.0, 2.0), UNDECIDED),
        (2.5, 9.0, Range(-2.0, 2.0), FAILS),
        (-9.0, 1.0, Range(-INFINITE, 2.0), HOLDS),
    ],
)
def test_judge(low, high, claimed, verdict):
    assert judge(interval(low, high), claimed) == verdict


@given(PAIR, PAIR, st.floats(0, 50), st.floats(0, 50))
def test_a_wider_range_never_makes_a_verdict_worse(found, claimed, more_left, more_right):
    (low, high), (start, end) = found, claimed
    assume(start < end)
    order = [FAILS, UNDECIDED, HOLDS]
    narrow = judge(interval(low, high), Range(start, end))
    wide = judge(interval(low, high), Range(start - more_left, end + more_right))
    assert order.index(wide) >= order.index(narrow)


@given(PAIR, PAIR)
def test_margin_is_positive_exactly_if_a_claim_holds(of_found, of_claimed):
    assume(of_claimed[0] < of_claimed[1])
    claimed, found = Range(*of_claimed), interval(*of_found)
    assert (claimed.margin(found) > 0) == (judge(found, claimed) == HOLDS)


@given(st.lists(st.sampled_from([HOLDS, FAILS, UNDECIDED]), min_size=1, max_size=6))
def test_combine(verdicts):
    combined = combine(verdicts)
    assert (combined == HOLDS) == all(one == HOLDS for one in verdicts)
    assert (combined == FAILS) == any(one == FAILS for one in verdicts)
    assert combine(verdicts[::-1]) == combined


def test_corrected_interval_is_used_only_for_failing():
    better = Range(0.0, INFINITE)
    assert judge(interval(-3, -1), better, interval(-4, 1)) == UNDECIDED
    assert judge(interval(-3, -1), better, interval(-4, -0.5)) == FAILS
    assert judge(interval(1, 3), better, interval(-1, 4)) == HOLDS


def test_corrected_level_follows_bonferroni():
    assert corrected_level(0.95, 1) == 0.95
    assert corrected_level(0.95, 14) == pytest.approx(0.9964, abs=5e-5)


@pytest.mark.parametrize("comparisons", [2, 14])
def test_family_wise_error_rate_is_at_most_5_percent(comparisons):
    """Every difference is exactly 0, the worst case. Without correction, 14 comparisons fail more often."""
    rng = np.random.default_rng(comparisons)
    better, runs, level = Range(0.0, INFINITE), 120, corrected_level(0.95, comparisons)
    wrong = {0.95: 0, level: 0}
    for run in range(runs):
        units = rng.normal(size=(comparisons, 6))
        for each in wrong:
            found = [
                paired_bootstrap(lambda weights, own=own: weights @ own, 6, run, level=each, resamples=500)
                for own in units
            ]
            wrong[each] += combine([judge(one, better) for one in found]) == FAILS
    assert wrong[level] <= 0.05 * runs
    assert comparisons < 14 or wrong[0.95] > 0.15 * runs


@pytest.mark.parametrize(
    ("worse", "better", "verdict"),
    [
        ((0.1, 0.4), (0.2, 0.6), HOLDS),
        ((0.0, 0.03), (0.7, 1.0), FAILS),
        ((0.3, 0.9), (0.0, 0.04), FAILS),
        ((0.04, 0.4), (0.2, 0.6), UNDECIDED),
        ((0.01, 0.9), (0.0, 0.5), UNDECIDED),
    ],
)
def test_judge_shares(worse, better, verdict):
    assert judge_shares(interval(*worse), interval(*better), 0.05) == verdict


def test_range_as_text():
    assert str(Range(0.0, INFINITE)) == "above 0"
    assert str(Range(-INFINITE, 2.0)) == "below 2"
    assert str(Range(1.63, 4.89)) == "between 1.63 and 4.89"
