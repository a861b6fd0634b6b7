import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy import stats

from placecat.evaluation.tail import share_below

VALUES = st.lists(st.floats(-20, 20), min_size=3, max_size=8)


def of_one_case(values, threshold, **options):
    return share_below([np.array([value]) for value in values], threshold, **options)


def test_limits_come_from_the_noncentral_t_distribution():
    values, threshold = np.array([3.0, 5.0, 1.0, 4.0, 6.0, 2.0]), -1.0
    interval = of_one_case(values, threshold)
    t = (threshold - values.mean()) / values.std(ddof=1) * np.sqrt(6)
    assert interval.estimate == pytest.approx(stats.norm.cdf(t / np.sqrt(6)))
    for end, below in ((interval.low, 0.975), (interval.high, 0.025)):
        assert stats.nct.cdf(t, 5, stats.norm.ppf(end) * np.sqrt(6)) == pytest.approx(below, abs=1e-4)


@given(VALUES, st.floats(-20, 20), st.floats(0, 10))
def test_share_increases_with_the_threshold(values, threshold, more):
    low, high = of_one_case(values, threshold), of_one_case(values, threshold + more)
    assert 0 <= low.low <= low.estimate <= low.high <= 1
    assert low.estimate <= high.estimate + 1e-12
    assert low.high <= high.high + 1e-9


@given(VALUES, st.floats(-20, 20))
def test_negated_values_mirror_the_interval(values, threshold):
    below, above = of_one_case(values, threshold), of_one_case(-np.array(values), -threshold)
    if np.std(values) > 1e-3:
        assert below.high == pytest.approx(1 - above.low, abs=1e-6)


def test_variance_within_units_increases_the_share():
    alike = share_below([np.full(2, 2.0), np.full(2, 4.0), np.full(2, 3.0)], 0.0)
    mixed = share_below([np.array([-3.0, 7.0]), np.array([-1.0, 9.0]), np.array([-2.0, 8.0])], 0.0)
    assert mixed.estimate > alike.estimate + 0.1


def test_identical_values_give_a_point():
    assert of_one_case([5.0] * 4, -1.0).high == 0.0
    assert of_one_case([-5.0] * 4, -1.0).low == 1.0


@pytest.mark.parametrize("between", [1.0, 0.5])
def test_coverage_of_six_homes_with_five_results(between):
    """Each end should err in at most 2.5% of the simulations. One case in 15 is below the threshold."""
    rng = np.random.default_rng(5)
    truth, wrong = stats.norm.cdf(-1.5), [0, 0]
    for _ in range(300):
        units = [
            np.sqrt(between) * rng.normal() + np.sqrt(1 - between) * rng.normal(size=5) for _ in range(6)
        ]
        interval = share_below(units, -1.5)
        wrong[0] += interval.low > truth
        wrong[1] += interval.high < truth
    assert max(wrong) <= 0.045 * 300


def test_one_unit_has_no_interval():
    with pytest.raises(ValueError, match="at least 2 units, not 1"):
        of_one_case([1.0], 0.0)
