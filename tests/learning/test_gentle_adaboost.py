import cv2
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from number_of_examples import examples
from placecat.errors import PlacecatError
from placecat.learning.gentle_adaboost import GentleAdaBoost
from placecat.learning.memory import remembering
from placecat.learning.stumps import bin_features

RAW_SUM = 256


def grid(n=400, seed=0, levels=30):
    rng = np.random.default_rng(seed)
    X = rng.integers(0, levels, (n, 5)).astype(np.float32)
    return X, X[:, 0] + X[:, 1] + 0.2 * levels * rng.normal(size=n) > levels


def opencv(X, y, rounds, trim, test):
    boost = cv2.ml.Boost_create()
    boost.setBoostType(cv2.ml.BOOST_GENTLE)
    boost.setWeakCount(rounds)
    boost.setMaxDepth(1)
    boost.setWeightTrimRate(trim)
    boost.train(X, cv2.ml.ROW_SAMPLE, y.astype(np.int32))
    return boost.predict(test, flags=RAW_SUM)[1][:, 0]


def smallest_error(X, target, weight):
    """Return the smallest weighted squared error of a stump, trying every midpoint of every feature."""
    errors = []
    for column in X.T:
        values = np.unique(column)
        for cut in (values[:-1] + values[1:]) / 2:
            sides = column > cut, column <= cut
            means = [np.average(target[side], weights=weight[side]) for side in sides]
            errors.append(sum(weight[s] @ (target[s] - m) ** 2 for s, m in zip(sides, means, strict=True)))
    return min(errors)


def test_equals_opencv_if_every_value_has_a_bin():
    X, y = grid()
    ours = GentleAdaBoost(30, weight_trim=1.0).fit(X, y).decision_function(X)
    np.testing.assert_allclose(ours, opencv(X, y, 30, 1.0, X), atol=1e-4)


def test_trimmed_weights_stay_close_to_opencv():
    X, y = grid()
    ours, theirs = GentleAdaBoost(30).fit(X, y).decision_function(X), opencv(X, y, 30, 0.95, X)
    assert np.corrcoef(ours, theirs)[0, 1] > 0.99
    assert abs(((ours > 0) == y).mean() - ((theirs > 0) == y).mean()) < 0.02


def test_quantile_bins_follow_opencv_on_continuous_features():
    rng = np.random.default_rng(3)
    X = rng.normal(size=(1500, 6)).astype(np.float32)
    y = X[:, 0] + X[:, 1] ** 2 > 0.7
    ours, theirs = GentleAdaBoost(20, max_bins=64).fit(X, y).decision_function(X), opencv(X, y, 20, 0.95, X)
    assert np.corrcoef(ours, theirs)[0, 1] > 0.98
    assert abs(((ours > 0) == y).mean() - ((theirs > 0) == y).mean()) < 0.02


@settings(max_examples=examples(10), deadline=None)
@given(seed=st.integers(0, 500))
def test_each_round_takes_the_best_stump(seed):
    rng = np.random.default_rng(seed)
    X = rng.normal(size=(25, 3)).astype(np.float32)
    y = X[:, 0] + rng.normal(size=25) > 0
    y[:2] = [True, False]
    model = GentleAdaBoost(5, weight_trim=1.0).fit(X, y)
    target, weight, total = np.where(y, 1.0, -1.0), np.full(25, 0.04), np.zeros(25)
    for t in range(5):
        f = np.where(X[:, model.feature_[t]] > model.threshold_[t], model.high_[t], model.low_[t])
        assert weight @ (target - f) ** 2 == pytest.approx(smallest_error(X, target, weight), abs=1e-9)
        total += f
        weight = weight * np.exp(-target * f)
        weight /= weight.sum()
    np.testing.assert_allclose(model.decision_function(X), total, atol=1e-12)


def test_bins_and_histograms():
    X = np.array([[0.0, 5], [1, 5], [1, 5], [4, 5]], dtype=np.float32)
    binned = bin_features(X, 256)
    assert [t.tolist() for t in binned.thresholds] == [[0.5, 2.5], []]
    assert binned.bins.tolist() == [[0, 1, 1, 2], [0, 0, 0, 0]]
    (sums,) = binned.blocks
    histograms = (sums @ np.array([1.0, 2.0, 4.0, 8.0])).reshape(256, 2)
    assert histograms[:3, 0].tolist() == [1.0, 6.0, 8.0]
    assert histograms[0, 1] == 15.0


def test_machines_fitted_together_equal_those_fitted_alone():
    """This is also true inside `remembering`, after fits with other numbers of rounds."""
    rng = np.random.default_rng(5)
    X = rng.normal(size=(150, 70)).astype(np.float32)
    tasks = [
        (X[:, k] + rng.normal(size=150) > 0.3, rows, "it")
        for k in range(5)
        for rows in (None, np.flatnonzero(rng.random(150) < 0.7))
    ]
    shared = GentleAdaBoost().prepare(X)
    alone = {rounds: [GentleAdaBoost(rounds).fit_rows(shared, *task) for task in tasks] for rounds in (3, 6)}
    with remembering():
        for rounds in (3, 6, 3):
            for one, other in zip(
                GentleAdaBoost(rounds).fit_together(shared, tasks), alone[rounds], strict=True
            ):
                assert len(one.feature_) == rounds
                for name in ("feature_", "threshold_", "cut_", "low_", "high_"):
                    np.testing.assert_array_equal(getattr(one, name), getattr(other, name))


def test_decisions_for_shared_rows_equal_those_for_samples():
    X, y = grid()
    model = GentleAdaBoost(10)
    shared = model.prepare(X)
    rows = np.arange(0, 400, 3)
    model.fit_rows(shared, y, rows)
    model.classes_ = np.array([False, True])
    np.testing.assert_allclose(
        model.decide_rows(shared, np.arange(400)), model.decision_function(X), atol=1e-12
    )


def test_probability_is_equation_8():
    X, y = grid()
    model = GentleAdaBoost(5).fit(X, y)
    f = model.decision_function(X)
    np.testing.assert_allclose(model.predict_proba(X)[:, 1], np.exp(f) / (np.exp(-f) + np.exp(f)), atol=1e-12)


def test_constant_features_yield_the_base_rate():
    model = GentleAdaBoost(3, weight_trim=1.0).fit(np.zeros((4, 2)), [0, 0, 0, 1])
    assert model.decision_function([[9.0, 9.0]]).tolist() == [-0.5]


@pytest.mark.parametrize(
    ("model", "message"),
    [
        (GentleAdaBoost(0), "n_rounds=0: it must be greater than or equal to 1"),
        (GentleAdaBoost(max_bins=1), "max_bins=1: it must be greater than or equal to 2"),
        (GentleAdaBoost(weight_trim=0.0), "weight_trim=0.0: it must be greater than 0"),
    ],
)
def test_messages(model, message):
    X, y = grid()
    with pytest.raises(PlacecatError, match=message):
        model.fit(X, y)
