import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.optimize import minimize
from sklearn.calibration import _SigmoidCalibration
from sklearn.linear_model import LogisticRegression

from number_of_examples import examples
from placecat.errors import PlacecatError
from placecat.learning.platt import apply_sigmoid, fit_sigmoid


def draw(n, seed, scale=1.0, shift=0.0):
    rng = np.random.default_rng(seed)
    d = rng.normal(size=n)
    return scale * d + shift, rng.random(n) < 1 / (1 + np.exp(-2 * d + 1))


@pytest.mark.parametrize(("scale", "shift"), [(1.0, 0.0), (20.0, 5.0), (1e-3, 2e-3)])
def test_against_scikit_learn(scale, shift):
    d, positive = draw(300, 0, scale, shift)
    a, b = fit_sigmoid(d, positive)
    theirs = _SigmoidCalibration().fit(d, positive.astype(int)).predict(d)
    np.testing.assert_allclose(apply_sigmoid(d, a, b), theirs, atol=2e-4)


@settings(max_examples=examples(30), deadline=None)
@given(
    n=st.integers(2, 60),
    seed=st.integers(0, 9999),
    scale=st.floats(-1e3, 1e3).filter(lambda s: abs(s) > 1e-3),
)
def test_no_general_optimiser_finds_a_better_nondecreasing_sigmoid(n, seed, scale):
    d, positive = draw(n, seed, scale)
    target = np.where(positive, (positive.sum() + 1) / (positive.sum() + 2), 1 / ((~positive).sum() + 2))

    def loss(v):
        f = v[0] * d / scale + v[1]
        return float((np.logaddexp(0, f) - (1 - target) * f).sum())

    a, b = fit_sigmoid(d, positive)
    assert a <= 0
    bounds = [(None, 0.0) if scale > 0 else (0.0, None), (None, None)]
    assert loss([a * scale, b]) <= minimize(loss, [0.0, 0.0], bounds=bounds).fun + 1e-6


def test_balanced_is_the_weighted_logistic_regression():
    d, positive = draw(4000, 1)
    a, b = fit_sigmoid(d, positive, balanced=True)
    model = LogisticRegression(C=1e9, class_weight="balanced").fit(d[:, None], positive)
    # The smoothed targets differ from 0 and 1 by less than 1/1000.
    assert [-a, -b] == pytest.approx([model.coef_[0, 0], model.intercept_[0]], abs=0.02)


def test_one_class_only_and_equal_decisions():
    a, b = fit_sigmoid([1.0, 1.0, 1.0], [False, False, False])
    assert (a, apply_sigmoid(np.array([5.0]), a, b)[0]) == (0.0, pytest.approx(1 / 5))
    a, b = fit_sigmoid([1.0, 2.0, 3.0], [False, False, False])
    np.testing.assert_allclose(apply_sigmoid(np.array([1.0, 9.0]), a, b), 1 / 5, atol=1e-6)


def test_reversed_decisions_yield_a_flat_sigmoid():
    d, positive = draw(300, 0)
    a, b = fit_sigmoid(-d, positive)
    assert a == 0.0
    # The mean of the smoothed targets.
    n = positive.sum()
    rate = (n * (n + 1) / (n + 2) + (300 - n) / (302 - n)) / 300
    assert apply_sigmoid(np.array([3.0]), a, b)[0] == pytest.approx(rate)


def test_literal_sigmoid():
    assert apply_sigmoid(np.array([0.0, 1e9, -1e9]), -1.0, 0.0).tolist() == [0.5, 1.0, 0.0]


def test_messages():
    with pytest.raises(PlacecatError, match="held-out decision values, and all must be finite"):
        fit_sigmoid([], [])
    with pytest.raises(PlacecatError, match="held-out decision values, and all must be finite"):
        fit_sigmoid([np.nan], [True])
