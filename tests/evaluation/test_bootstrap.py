import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from placecat.evaluation.bootstrap import Interval, paired_bootstrap, stratified_bootstrap, stretch

UNITS = st.lists(st.floats(-50, 50), min_size=3, max_size=9).map(np.array)


def mean_of(units, seed=0, **options):
    return paired_bootstrap(
        lambda weights: weights @ units, len(units), seed, **({"resamples": 500} | options)
    )


@given(UNITS, st.integers(0, 2**32 - 1))
def test_interval_brackets_the_mean(units, seed):
    interval = mean_of(units, seed)
    assert interval.estimate == pytest.approx(units.mean(), abs=1e-9)
    assert interval.low <= interval.estimate + 1e-9
    assert interval.estimate - 1e-9 <= interval.high


@given(UNITS, UNITS, st.integers(0, 2**32 - 1))
def test_swapped_sides_mirror_the_interval(left, right, seed):
    n = min(len(left), len(right))
    one, other = mean_of(left[:n] - right[:n], seed), mean_of(right[:n] - left[:n], seed)
    assert (one.estimate, one.low, one.high) == pytest.approx(
        (-other.estimate, -other.high, -other.low), abs=1e-9
    )


@given(UNITS, st.floats(-50, 50))
def test_common_effects_cancel_and_constant_differences_give_a_point(home, difference):
    interval = mean_of((home + difference) - home).rounded()
    assert interval.low == interval.estimate == interval.high == pytest.approx(difference, abs=0.006)


@given(UNITS, st.floats(0.1, 10), st.floats(-20, 20))
def test_interval_shifts_and_scales_with_its_units(units, scale, shift):
    one, other = mean_of(units), mean_of(scale * units + shift)
    expected = [scale * number + shift for number in (one.estimate, one.low, one.high)]
    assert [other.estimate, other.low, other.high] == pytest.approx(expected, abs=1e-6)


def test_interval_widens_with_the_level_and_is_reproducible():
    units = np.array([1.0, 4.0, 2.0, 8.0, 5.0, 7.0])
    narrow, wide = mean_of(units, level=0.8), mean_of(units, level=0.95)
    assert wide.low < narrow.low < narrow.high < wide.high
    assert mean_of(units, level=0.95) == wide
    assert mean_of(units, seed=1, level=0.95) != wide


def test_stretch_uses_student_t_and_approaches_1():
    assert stretch(6, 0.95) == pytest.approx(np.sqrt(6 / 5) * 2.5706 / 1.9600, abs=1e-4)
    assert stretch(100000, 0.95) == pytest.approx(1.0, abs=1e-4)


@pytest.mark.parametrize("n", [4, 6])
def test_coverage_of_few_normal_units(n):
    """Check the coverage stated in the docstring. A plain percentile interval covers only 0.81 and 0.85."""
    rng = np.random.default_rng(0)
    covered = 0
    for seed in range(600):
        interval = mean_of(rng.normal(size=n), seed, resamples=1000)
        covered += interval.low <= 0.0 <= interval.high
    assert 0.92 <= covered / 600 <= 0.975


def test_maximum_is_recomputed_in_every_resample():
    """The two results are equal on average but better in different homes, so the best result is uncertain."""
    results = np.array([[0.0, 0.0, 0.0, 6.0, 6.0, 6.0], [6.0, 6.0, 6.0, 0.0, 0.0, 0.0]])
    best = paired_bootstrap(lambda weights: (results @ weights.T).max(axis=0), 6, 0, resamples=2000)
    assert best.estimate == 3.0
    assert best.low == pytest.approx(3.0)
    assert best.high > 5.0


def test_one_unit_has_no_interval():
    with pytest.raises(ValueError, match="at least 2 units, not 1"):
        mean_of(np.array([1.0]))


def test_rounded_has_no_negative_zero():
    assert str(Interval(-0.001, -0.004, 0.004).rounded()) == "Interval(estimate=0.0, low=0.0, high=0.0)"


def strata_of(*sizes):
    return np.repeat(np.arange(len(sizes)), sizes)


def test_strata_keep_their_weight_and_single_blocks_add_no_variance():
    strata, values = strata_of(1, 4), np.array([100.0, 1.0, 2.0, 3.0, 4.0])
    seen = []

    def mean(weights):
        seen.append(weights)
        return weights @ values / 2

    interval = stratified_bootstrap(mean, strata, 0, resamples=500)
    assert interval.estimate == pytest.approx(51.25)
    assert 50.0 < interval.low < interval.estimate < interval.high < 52.5
    for weights in seen:
        np.testing.assert_allclose(weights[:, :1].sum(axis=1), 1.0)
        np.testing.assert_allclose(weights[:, 1:].sum(axis=1), 1.0)


@pytest.mark.parametrize("sizes", [(2, 2, 2, 2, 2), (8, 8, 8, 8, 8)])
def test_coverage_of_a_mean_over_places(sizes):
    """Check the coverage stated in the docstring."""
    rng, strata, covered = np.random.default_rng(0), strata_of(*sizes), 0
    for seed in range(400):
        values = rng.normal(size=len(strata))
        interval = stratified_bootstrap(
            lambda weights, own=values: weights @ own, strata, seed, resamples=500
        )
        covered += interval.low <= 0.0 <= interval.high
    assert 0.88 <= covered / 400 <= 0.985


def test_strata_of_single_blocks_have_no_interval():
    with pytest.raises(ValueError, match="two or more blocks"):
        stratified_bootstrap(lambda weights: weights.sum(axis=1), strata_of(1, 1), 0)
