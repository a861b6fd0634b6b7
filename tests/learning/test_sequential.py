import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from number_of_examples import examples
from placecat.errors import PlacecatError
from placecat.learning.gentle_adaboost import GentleAdaBoost
from placecat.learning.nu_svm import NuSVM
from placecat.learning.one_against_all import OneAgainstAll
from placecat.learning.sequential import Sequential

BASE = NuSVM(gamma=0.5, nu=0.2)


def homes(n=150, seed=0, spread=1.0):
    rng = np.random.default_rng(seed)
    y = np.arange(n) % 3
    return 2.0 * np.eye(3)[y] + spread * rng.normal(size=(n, 3)), y, np.arange(n) * 3 // n


def listed(order, **settings_):
    model = Sequential(**settings_)
    model.order_ = np.array(order)
    model.sigmoid_ = np.array([[-1.0, 0.0]] * len(order))
    model.machine_class_ = np.arange(len(order))
    return model


def test_literal_product():
    model = listed([2, 0, 1], output="product")
    np.testing.assert_allclose(model.combine(np.array([[0.5, 0.9, 0.2]])), [[0.4, 0.4, 0.2]])


def test_literal_decisions():
    outputs = np.array([[0.9, 0.1, 0.6], [0.7, 0.9, 0.4], [0.4, 0.1, 0.45]])
    assert listed([2, 0, 1]).decide(outputs).tolist() == [2, 0, 1]
    # In the last row, the products are 0.45 and 0.55 * 0.4, and the remainder is 0.33.
    assert listed([2, 0, 1], decision="product").decide(outputs).tolist() == [2, 0, 2]
    one_hot = listed([2, 0, 1], output="decision").combine(outputs)
    assert one_hot.tolist() == [[0, 0, 1], [1, 0, 0], [0, 1, 0]]


def test_sign_and_probability_differ_by_the_sigmoids_offset():
    outputs = np.array([[0.3, 0.0]])
    sign, probability = listed([0, 1]), listed([0, 1], decision="probability")
    for model in (sign, probability):
        # At a decision value of 0, p is 1 / (1 + e^2) = 0.12, so p = 0.3 means a positive decision value.
        model.sigmoid_[0] = [-1.0, 2.0]
    assert sign.decide(outputs).tolist() == [0]
    assert probability.decide(outputs).tolist() == [1]


@pytest.mark.parametrize("decision", ["sign", "probability"])
def test_a_node_with_a_flat_sigmoid_accepts_nothing(decision):
    """A constant output carries no information, so the node must not accept any sample."""
    model = listed([0, 1], decision=decision)
    model.sigmoid_[0] = [0.0, 0.0]
    assert model.decide(np.array([[0.5, 0.1]])).tolist() == [1]


@settings(max_examples=examples(50), deadline=None)
@given(outputs=arrays(float, (4, 5), elements=st.floats(0, 1)), order=st.permutations(range(5)))
def test_rows_sum_to_one_and_follow_the_definition(outputs, order):
    proba = listed(order, output="product").combine(outputs)
    np.testing.assert_allclose(proba.sum(axis=1), 1.0)
    for row, p in zip(outputs, proba, strict=True):
        left = 1.0
        for k in order[:-1]:
            assert p[k] == pytest.approx(row[k] * left, abs=1e-12)
            left *= 1.0 - row[k]
        assert p[order[-1]] == pytest.approx(left, abs=1e-12)


def test_shares_the_classifiers_of_the_parallel_scheme():
    X, y, groups = homes()
    parallel, sequential = OneAgainstAll(BASE).fit(X, y, groups), Sequential(BASE).fit(X, y, groups)
    assert np.array_equal(parallel.outputs(X), sequential.outputs(X))
    assert np.array_equal(parallel.cv_outputs_, sequential.cv_outputs_)


@pytest.mark.parametrize("order", ["balanced_accuracy", "error"])
def test_strongest_first(order):
    rng = np.random.default_rng(1)
    y = np.arange(180) % 3
    # Class 2 is separate, but classes 0 and 1 overlap.
    X = np.array([[0.0, 0.0], [1.0, 0.0], [9.0, 9.0]])[y] + rng.normal(size=(180, 2))
    model = Sequential(BASE, order=order, decision="probability").fit(X, y, groups=np.arange(180) // 60)
    assert model.order_[0] == 2
    yes = model.cv_outputs_ > 0.5
    for k in range(3):
        truth = y == k
        right = yes[:, k] == truth
        expected = right.mean() if order == "error" else (right[truth].mean() + right[~truth].mean()) / 2
        assert model.strength_[k] == pytest.approx(expected)


def test_nodes_on_remaining_classes_equal_a_fit_without_the_earlier_ones():
    X, y, groups = homes()
    model = Sequential(BASE, training="remaining").fit(X, y, groups)
    first, second, last = model.order_
    kept = y != first
    alone = OneAgainstAll(BASE).fit(X[kept], y[kept], groups[kept])
    column = list(alone.classes_).index(second)
    np.testing.assert_allclose(model.outputs(X)[:, second], alone.outputs(X)[:, column], atol=1e-3)
    whole = OneAgainstAll(BASE).fit(X, y, groups)
    np.testing.assert_allclose(model.outputs(X)[:, first], whole.outputs(X)[:, first], atol=1e-4)
    assert np.isfinite(model.cv_outputs_).all()
    assert (model.predict(X) == y).mean() > 0.8
    assert last not in (first, second)


@pytest.mark.parametrize("training", ["all", "remaining"])
def test_results_do_not_depend_on_the_number_of_threads(training):
    X, y, groups = homes()
    labels = np.array(["bath", "hall", "bed"])[y]
    one = Sequential(GentleAdaBoost(5), training=training, n_jobs=1).fit(X, labels, groups)
    three = Sequential(GentleAdaBoost(5), training=training, n_jobs=3).fit(X, labels, groups)
    assert one.cv_outputs_.tobytes() == three.cv_outputs_.tobytes()
    assert np.array_equal(three.predict_proba(X), one.predict_proba(X))
    assert np.array_equal(three.predict(X), one.predict(X))


def test_two_classes_need_one_node():
    X, y, groups = homes()
    two = y < 2
    model = Sequential(BASE).fit(X[two], y[two], groups[two])
    assert (model.predict(X[two]) == y[two]).mean() > 0.85
    np.testing.assert_allclose(model.predict_proba(X).sum(axis=1), 1.0)


@pytest.mark.parametrize("name", ["order", "training", "decision", "output"])
def test_messages(name):
    X, y, _ = homes(30)
    with pytest.raises(PlacecatError, match=f"{name}=x: it must be '"):
        Sequential(BASE, **{name: "x"}).fit(X, y)
