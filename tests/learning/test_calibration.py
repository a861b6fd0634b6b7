import logging

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from number_of_examples import examples
from placecat.errors import PlacecatError
from placecat.learning.calibration import (
    CALIBRATIONS,
    Calibration,
    Problem,
    centre,
    fit_problems,
    make_folds,
)
from placecat.learning.nu_svm import NuSVM
from placecat.learning.one_against_all import OneAgainstAll


class Known:
    """A machine with known decision values, plus a shift that depends on the home it has not seen."""

    own_sigmoid = None

    def __init__(self, values=(), homes=(), shifts=()):
        self.values, self.homes, self.shifts = values, homes, shifts

    def get_params(self, deep=False):
        return {"values": self.values, "homes": self.homes, "shifts": self.shifts}

    def fit_rows(self, shared, positive, rows=None, context=""):
        seen = self.homes if rows is None else self.homes[rows]
        left_out = np.setdiff1d(np.unique(self.homes), np.unique(seen))
        self.shift = self.shifts[left_out].sum()
        return self

    def decide_rows(self, shared, rows):
        return self.values[rows] + self.shift


def shifted(shifts, n=300, seed=0):
    """Return a machine whose values rise with the label within each home, the labels, and the homes."""
    rng = np.random.default_rng(seed)
    homes = np.repeat(np.arange(len(shifts)), n // len(shifts))
    positive = rng.random(n) < np.linspace(0.1, 0.9, len(shifts))[homes]
    values = rng.normal(size=n) + 1.0 * positive
    return Known(values, homes, np.asarray(shifts, float)), positive, homes


def fit_known(base, positive, homes, kind):
    problem = Problem("it", positive, np.ones(len(positive), bool))
    folds = make_folds(positive.astype(int), homes, kind, 5)
    (fitted,) = fit_problems(base, None, [problem], folds, Calibration(kind), 1)
    return fitted


def test_no_calibration_reverses_the_sign_as_pooling_would():
    """A machine that leaves out a home with many positives sees few, so its values for that home are low."""
    base, positive, homes = shifted([0.0, -2.0, -4.0, -6.0, -8.0])
    pooled = base.values + base.shifts[homes]
    assert np.corrcoef(pooled, positive)[0, 1] < -0.3
    for kind in CALIBRATIONS:
        fitted = fit_known(base, positive, homes, kind)
        assert fitted.flat == 0, kind
        assert (fitted.sigmoids[:, 0] < -0.3).all(), kind


@settings(max_examples=examples(20), deadline=None)
@given(
    constant=st.floats(-50, 50),
    home=st.integers(0, 4),
    kind=st.sampled_from(CALIBRATIONS),
    seed=st.integers(0, 99),
)
def test_a_constant_shift_of_one_home_does_not_change_slopes(constant, home, kind, seed):
    base, positive, homes = shifted([0.0, 1.0, 2.0, 3.0, 4.0], seed=seed)
    before = fit_known(base, positive, homes, kind).sigmoids[:, 0]
    base.shifts[home] += constant
    after = fit_known(base, positive, homes, kind).sigmoids[:, 0]
    np.testing.assert_allclose(after, before, rtol=1e-4, atol=1e-6)


def test_reversed_decisions_yield_flat_sigmoids_and_one_log_message(caplog):
    base, positive, homes = shifted([0.0] * 5)
    base.values = -base.values
    for kind in CALIBRATIONS:
        caplog.clear()
        with caplog.at_level(logging.INFO):
            fitted = fit_known(base, positive, homes, kind)
        assert (fitted.sigmoids[:, 0] == 0.0).all()
        assert fitted.flat == len(fitted.sigmoids)
        assert [(record.levelname, record.message) for record in caplog.records] == [
            (
                "INFO",
                "the held-out decision values of it are uninformative or reversed, so the sigmoid is flat",
            )
        ]


@given(st.lists(st.lists(st.floats(-1e3, 1e3), min_size=1, max_size=8), min_size=1, max_size=5))
def test_centred_homes_have_one_mean(values):
    arrays = [np.array(one) for one in values]
    centred = centre(arrays)
    overall = np.mean([one.mean() for one in arrays])
    for one, original in zip(centred, arrays, strict=True):
        assert one.mean() == pytest.approx(overall, abs=1e-9)
        np.testing.assert_allclose(np.diff(one), np.diff(original), atol=1e-9)


def test_folds():
    y = np.repeat([0, 1], 10)
    groups = np.tile([7, 8, 9, 9, 9], 4)
    for kind in ("homes_centred", "homes_averaged"):
        held_out = [set(groups[test]) for _, test in make_folds(y, groups, kind, 5)]
        assert held_out == [{7}, {8}, {9}]
        assert len(make_folds(y, np.zeros(20), kind, 4)) == 4
    # The parts are consecutive samples of each class, or random samples that are the same in every call.
    assert make_folds(y, None, "consecutive", 5)[0][1].tolist() == [0, 1, 10, 11]
    drawn = [test.tolist() for _, test in make_folds(y, groups, "samples", 5)]
    assert drawn == [test.tolist() for _, test in make_folds(y, None, "samples", 5)]
    assert sorted(np.concatenate(drawn)) == list(range(20))
    assert all(sum(y[test]) == 2 for test in drawn)
    assert drawn[0] != [0, 1, 10, 11]
    with pytest.raises(PlacecatError, match="needs the home of each sample"):
        make_folds(y, None, "homes_centred", 5)
    with pytest.raises(PlacecatError, match=r"groups has shape \(3,\) for 20 samples"):
        make_folds(y, [1, 2, 3], "homes_averaged", 5)


def test_class_missing_from_a_folds_training_part(caplog):
    """Only home 0 has class 2, so consecutive samples are held out for this class instead of homes."""
    rng = np.random.default_rng(0)
    y = np.arange(150) % 3
    X = 2.0 * np.eye(3)[y] + rng.normal(size=(150, 3))
    groups = np.where(y == 2, 0, np.arange(150) * 3 // 150)
    for kind, machines in (("homes_centred", [0, 1, 2]), ("homes_averaged", [0, 0, 0, 1, 1, 1, 2])):
        caplog.clear()
        with caplog.at_level(logging.INFO):
            model = OneAgainstAll(NuSVM(gamma=0.5), kind).fit(X, y, groups=groups)
        assert "class '2': homes cannot be held out" in caplog.text
        assert np.isfinite(model.cv_outputs_).all()
        assert model.reliability_[2, 2] > model.reliability_[:2, 2].max()
        assert model.machine_class_.tolist() == machines
        proba = model.predict_proba(X)
        np.testing.assert_allclose(proba.sum(axis=1), 1.0)
        assert (model.predict(X) == y).mean() > 0.8
