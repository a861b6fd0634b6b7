import logging

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from sklearn.base import clone
from sklearn.svm import NuSVC

from number_of_examples import examples
from placecat.errors import PlacecatError
from placecat.learning.nu_svm import NuSVM, accepted_nu, largest_feasible_nu


def blobs(n=120, seed=0, share=0.4):
    rng = np.random.default_rng(seed)
    y = np.arange(n) < share * n
    return (rng.normal(size=(n, 3)) + 1.2 * y[:, None]).astype(np.float32), y


def test_against_nusvc():
    X, y = blobs()
    ours = NuSVM(gamma=0.5, nu=0.3, tol=1e-6).fit(X, y)
    theirs = NuSVC(gamma=0.5, nu=0.3, tol=1e-6).fit(X.astype(float), y)
    np.testing.assert_allclose(
        ours.decision_function(X), theirs.decision_function(X.astype(float)), atol=1e-4
    )
    assert np.array_equal(ours.predict(X), theirs.predict(X.astype(float)))


def test_rows_equal_a_fit_on_these_rows_alone():
    X, y = blobs()
    rows = np.flatnonzero(np.random.default_rng(1).random(len(X)) < 0.7)
    base = NuSVM(gamma=0.5, nu=0.3)
    shared = base.prepare(X)
    part = clone(base).fit_rows(shared, y, rows)
    assert set(part.support_) <= set(rows)
    alone = NuSVC(kernel="precomputed", nu=0.3).fit(shared[np.ix_(rows, rows)], y[rows])
    np.testing.assert_allclose(
        part.decide_rows(shared, np.arange(len(X))), alone.decision_function(shared[:, rows]), atol=1e-9
    )
    # Consecutive rows are not copied.
    np.testing.assert_allclose(
        part.decide_rows(shared, np.arange(10, 30)), alone.decision_function(shared[10:30, rows]), atol=1e-9
    )


def test_infeasible_nu_is_lowered_and_logged(caplog):
    X, y = blobs(share=0.05)
    with caplog.at_level(logging.INFO):
        model = NuSVM(gamma=0.5, nu=0.2).fit(X, y)
    assert model.nu_ == pytest.approx(0.1)
    assert "nu lowered from 0.2 to 0.1 for class True (6 of 120 samples positive)" in caplog.text
    assert np.isfinite(model.decision_function(X)).all()


def test_infeasible_nu_is_rejected():
    X, y = blobs(share=0.05)
    with pytest.raises(
        PlacecatError, match=r"nu = 0.2 is infeasible for class True .* largest feasible value is 0.1"
    ):
        NuSVM(gamma=0.5, nu=0.2, nu_policy="refuse").fit(X, y)


@settings(max_examples=examples(200), deadline=None)
@given(st.integers(1, 3000), st.integers(1, 3000), st.floats(1e-3, 1.0))
def test_accepted_nu_passes_libsvms_check(n_positive, n_negative, nu):
    value = accepted_nu(nu, n_positive, n_negative)
    assert value * (n_positive + n_negative) / 2 <= min(n_positive, n_negative)
    assert value == pytest.approx(min(nu, largest_feasible_nu(n_positive, n_negative)), rel=1e-6)


@settings(max_examples=examples(15), deadline=None)
@given(n_positive=st.integers(1, 12), seed=st.integers(0, 99))
def test_largest_feasible_nu_yields_a_finite_machine(n_positive, seed):
    rng = np.random.default_rng(seed)
    X = rng.normal(size=(40, 2))
    model = NuSVM(gamma=1.0, nu=1.0).fit(X, np.arange(40) < n_positive)
    assert model.nu_ == 2 * n_positive / 40
    assert np.isfinite(model.decision_function(X)).all()


@pytest.mark.parametrize("nu", [0.0, -0.1, 1.5, float("nan")])
@pytest.mark.parametrize("policy", ["lower", "refuse"])
def test_nu_outside_its_range_is_rejected(nu, policy):
    X, y = blobs()
    with pytest.raises(PlacecatError, match=f"^nu={nu}: it must be"):
        NuSVM(nu=nu, nu_policy=policy).fit(X, y)


def test_other_messages():
    X, y = blobs()
    with pytest.raises(PlacecatError, match="the labels must have 2 classes, not 1 class"):
        NuSVM().fit(X, np.ones(len(X)))
    with pytest.raises(PlacecatError, match="nu_policy=raise: it must be 'lower' or 'refuse'"):
        NuSVM(nu_policy="raise").fit(X, y)
    with pytest.raises(PlacecatError, match="X has 1 features, but NuSVM is expecting 3"):
        NuSVM().fit(X, y).predict([[1.0]])


def test_nu_without_margin_is_raised_or_rejected():
    """Three quarters of both classes coincide. A small nu leaves a margin of 0, and libsvm divides by it."""
    X = np.array([[0.0, 0.0]] * 6 + [[1.0, 1.0]] * 2 + [[0.0, 0.0]] * 6 + [[-1.0, 1.0]] * 2)
    y = np.repeat([0, 1], 8)
    model = NuSVM(gamma=1.0, nu=0.2).fit(X, y)
    assert model.nu_ == pytest.approx(0.8)
    assert np.isfinite(model.dual_coef_).all()
    assert model.predict([[1.0, 1.0], [-1.0, 1.0]]).tolist() == [0, 1]
    with pytest.raises(PlacecatError, match=r"nu = 0\.2 leaves no margin.*use a nu closer to 1"):
        NuSVM(gamma=1.0, nu=0.2, nu_policy="refuse").fit(X, y)


def test_coinciding_classes_are_rejected():
    with pytest.raises(PlacecatError, match="both classes have identical descriptors"):
        NuSVM(gamma=1.0, nu=0.5).fit(np.zeros((8, 2)), np.repeat([0, 1], 4))
