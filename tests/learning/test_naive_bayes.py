import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from sklearn.base import clone
from sklearn.exceptions import NotFittedError
from sklearn.naive_bayes import BernoulliNB, CategoricalNB

from number_of_examples import examples
from placecat.errors import PlacecatError
from placecat.learning import naive_bayes as module
from placecat.learning.naive_bayes import NaiveBayes


def samples(n_values: int, seed: int = 0) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    rng = np.random.default_rng(seed)
    X = rng.integers(0, n_values, (80, 6))
    y = np.array(["kitchen", "bathroom", "bedroom"])[rng.choice(3, 80, p=[0.6, 0.3, 0.1])]
    return X, y, rng.integers(0, n_values, (40, 6))


def test_by_hand():
    X = np.array([[0, 2], [1, 2], [1, 0]])
    model = NaiveBayes(alpha=1, n_values=3).fit(X, ["a", "a", "b"])
    # a: p(1) = 2/5, p(2) = 3/5; b: p(1) = 2/4, p(2) = 1/4.
    a, b = 2 / 5 * 3 / 5, 2 / 4 * 1 / 4
    np.testing.assert_allclose(model.predict_proba([[1, 2]]), [[a / (a + b), b / (a + b)]])
    np.testing.assert_allclose(
        model.predict_joint_log_likelihood([[1, 2]]), np.log([[a / 2, b / 2]]), rtol=1e-12
    )


@pytest.mark.parametrize("prior", ["uniform", "frequency"])
@pytest.mark.parametrize("alpha", [0.1, 1.0, 3.0])
def test_against_categorical_nb(prior, alpha):
    X, y, other = samples(5)
    peer = CategoricalNB(alpha=alpha, fit_prior=prior == "frequency", min_categories=5).fit(X, y)
    model = NaiveBayes(alpha=alpha, n_values=5, prior=prior).fit(X, y)
    np.testing.assert_allclose(model.predict_log_proba(other), peer.predict_log_proba(other), atol=1e-12)
    np.testing.assert_array_equal(model.predict(other), peer.predict(other))
    np.testing.assert_allclose(
        model.predict_joint_log_likelihood(other), peer.predict_joint_log_proba(other), atol=1e-12
    )


@pytest.mark.parametrize("prior", ["uniform", "frequency"])
def test_against_bernoulli_nb(prior):
    X, y, other = samples(2)
    peer = BernoulliNB(alpha=0.5, fit_prior=prior == "frequency").fit(X, y)
    model = NaiveBayes(alpha=0.5, prior=prior).fit(X.astype(np.uint8), y)
    np.testing.assert_allclose(model.predict_log_proba(other), peer.predict_log_proba(other), atol=1e-12)
    np.testing.assert_allclose(model.predict_proba(other).sum(axis=1), 1)


def test_two_values_and_more_agree():
    X, y, _ = samples(2)
    two = NaiveBayes(n_values=2).fit(X, y).feature_log_prob_
    three = NaiveBayes(n_values=3).fit(X, y).feature_log_prob_
    # A third value only adds alpha to every total.
    np.testing.assert_allclose(two, three[..., :2] - np.logaddexp(three[..., :1], three[..., 1:2]))


def test_blocks_do_not_matter(monkeypatch):
    X, y, other = samples(5)
    model = NaiveBayes().fit(X, y)
    whole = model.predict_joint_log_likelihood(other)
    monkeypatch.setattr(module, "_BLOCK", 20)
    np.testing.assert_array_equal(model.predict_joint_log_likelihood(other), whole)


@given(st.integers(0, 1000), st.integers(2, 4), st.permutations(range(30)))
@settings(max_examples=examples(30), deadline=None)
def test_order_of_samples_and_sums(seed, n_values, order):
    rng = np.random.default_rng(seed)
    X, y = rng.integers(0, n_values, (30, 4)), rng.integers(0, 3, 30)
    model = NaiveBayes(n_values=n_values).fit(X, y)
    shuffled = NaiveBayes(n_values=n_values).fit(X[order], y[order])
    np.testing.assert_array_equal(model.predict_proba(X), shuffled.predict_proba(X))
    np.testing.assert_allclose(model.predict_proba(X).sum(axis=1), 1, rtol=1e-12)
    np.testing.assert_allclose(np.exp(model.feature_log_prob_).sum(axis=2), 1, rtol=1e-12)


def test_many_variables_do_not_underflow():
    rng = np.random.default_rng(0)
    X, y = rng.integers(0, 2, (20, 5000)), np.repeat([0, 1], 10)
    probabilities = NaiveBayes().fit(X, y).predict_proba(X)
    assert np.isfinite(probabilities).all()
    np.testing.assert_array_equal(probabilities.argmax(axis=1), y)


@pytest.mark.parametrize(
    ("settings_", "message"),
    [
        ({"alpha": 0}, "alpha=0"),
        ({"alpha": -1.0}, "alpha=-1"),
        ({"prior": "learned"}, "'uniform' or 'frequency'"),
        ({"n_values": 1}, "n_values=1"),
        ({"n_values": 4}, r"code 4 of sample 1, variable 0 is outside \[0, 4\)"),
    ],
)
def test_invalid_settings(settings_, message):
    with pytest.raises(PlacecatError, match=message):
        NaiveBayes(**settings_).fit([[0, 1], [4, 0]], ["a", "b"])


def test_wrong_codes():
    model = NaiveBayes(n_values=3).fit([[0, 1], [2, 0]], ["a", "b"])
    with pytest.raises(PlacecatError, match="code 3 of sample 0, variable 1"):
        model.predict([[0, 3]])
    with pytest.raises(PlacecatError, match="code -1"):
        model.predict([[-1, 0]])
    with pytest.raises(PlacecatError, match="3 features, but NaiveBayes is expecting 2"):
        model.predict([[0, 0, 0]])
    with pytest.raises(PlacecatError, match="non-negative integers"):
        model.predict([[0.5, 0.0]])
    with pytest.raises(PlacecatError, match=r"y has shape \(1,\) for 2 samples"):
        NaiveBayes().fit([[0], [1]], ["a"])


def test_conventions():
    model = NaiveBayes(alpha=2.0, prior="frequency")
    assert clone(model).get_params() == {"alpha": 2.0, "n_values": None, "prior": "frequency"}
    assert repr(model) == "NaiveBayes(alpha=2.0, prior='frequency')"
    with pytest.raises(NotFittedError):
        model.predict([[0]])
    X, y, _ = samples(4)
    assert model.set_params(prior="uniform").fit(X.astype(float), y) is model
    assert model.classes_.tolist() == ["bathroom", "bedroom", "kitchen"]
    assert model.n_features_in_ == 6
    assert 0 <= model.score(X, y) <= 1
