import numpy as np
import pytest
from scipy.special import log_softmax, softmax
from sklearn.linear_model import LogisticRegression
from sklearn.metrics import log_loss

from placecat.fusion.integrate import fit
from placecat.fusion.log_pool import fit_weights, pool
from placecat.fusion.temperature import fit_temperature, temper

CLASSES = ["bath", "hall", "kitchen"]


def drawn(weights, n=6000, seed=0):
    """Draw distributions for cues, and labels from their pool with the given weights."""
    rng = np.random.default_rng(seed)
    proba = rng.dirichlet(np.ones(3), (n, len(weights)))
    scores = np.tensordot(np.log(proba), weights, axes=(1, 0))
    truth = np.array([rng.choice(3, p=p) for p in softmax(scores, axis=1)], np.int16)
    return proba, truth, np.repeat(["a", "b", "c"], n // 3)


def weighed(truth, homes):
    """Compute (n,) frame weights by hand, with equal weight for homes and for the classes in each home."""
    weights = np.zeros(len(truth))
    for home in set(homes):
        classes = set(truth[homes == home])
        for one in classes:
            there = (homes == home) & (truth == one)
            weights[there] = 1.0 / (len(set(homes)) * len(classes) * there.sum())
    return weights


def loss(proba, truth, homes):
    return log_loss(truth, proba, sample_weight=weighed(truth, homes), labels=range(3))


def test_the_pool_is_the_softmax_of_weighted_logarithms():
    proba, weights = np.random.default_rng(1).dirichlet(np.ones(4), (7, 3)), np.array([0.5, 0.0, 2.0])
    expected = softmax(np.einsum("ncq,c->nq", np.log(proba), weights), axis=1)
    np.testing.assert_allclose(pool(proba, weights), expected, rtol=1e-10)
    for row, alone in zip(proba, pool(proba, weights), strict=True):
        np.testing.assert_array_equal(pool(row[None], weights)[0], alone)
    np.testing.assert_allclose(pool(proba, np.zeros(3)), 0.25)


def test_a_probability_of_zero_does_not_rule_out_a_place():
    sure_and_wrong = np.array([[[1.0, 0.0], [0.1, 0.9]]])
    assert pool(sure_and_wrong, np.array([0.1, 1.0])).argmax() == 1
    assert np.isfinite(pool(np.array([[[1.0, 0.0], [0.0, 1.0]]]), np.array([9.0, 9.0]))).all()


def test_smallest_probability_is_a_setting_with_default_1e_6():
    rng = np.random.default_rng(2)
    proba = {home: rng.dirichlet(np.full(3, 0.05), (90, 2)) for home in "abc"}
    truth = {home: rng.integers(3, size=90).astype(np.int16) for home in "abc"}
    usual, same, high = (
        fit(proba, truth, CLASSES, method="log_pool", shrinkage=0.1, **own).integrator
        for own in ({}, {"smallest": 1e-6}, {"smallest": 0.2})
    )
    np.testing.assert_array_equal(usual.predict_proba(proba["a"]), same.predict_proba(proba["a"]))
    by_hand = pool(np.maximum(proba["a"], 0.2), high.weights)
    np.testing.assert_array_equal(high.predict_proba(proba["a"]), by_hand)
    assert not np.allclose(by_hand, usual.predict_proba(proba["a"]))


@pytest.mark.parametrize("weights", [[1.0, 0.5, 0.0], [0.3, 2.0, 0.7]])
def test_fit_recovers_the_weights_used_to_draw_labels(weights):
    found = fit_weights(*drawn(weights), shrinkage=0.0)
    np.testing.assert_allclose(found, weights, atol=0.12)


def test_two_classes_equal_a_logistic_regression():
    """For two classes, the weights are the coefficients of a logistic regression on the log odds."""
    rng = np.random.default_rng(5)
    proba = rng.dirichlet([1, 1], (900, 2))
    odds = np.log(proba[..., 1] / proba[..., 0])
    truth = (rng.random(900) < 1 / (1 + np.exp(-odds @ [0.8, 0.4]))).astype(np.int16)
    homes = np.repeat(["a", "b"], [300, 600])
    model = LogisticRegression(C=np.inf, fit_intercept=False, tol=1e-10)
    expected = model.fit(odds, truth, sample_weight=weighed(truth, homes)).coef_[0]
    np.testing.assert_allclose(fit_weights(proba, truth, homes, shrinkage=0.0), expected, rtol=1e-3)


def test_fitted_pool_beats_every_cue_and_all_other_weights():
    proba, truth, homes = drawn([0.7, 0.2], n=600, seed=3)
    # One home is larger, and one lacks a class.
    keep = (homes != "b") | (np.arange(600) % 3 == 0)
    keep &= (homes != "c") | (truth > 0)
    proba, truth, homes = proba[keep], truth[keep], homes[keep]
    best = loss(pool(proba, fit_weights(proba, truth, homes, shrinkage=0.0)), truth, homes)
    for cue in range(2):
        for own in (1.0, fit_temperature(proba[:, cue], truth)):
            assert best <= loss(temper(proba[:, cue], own), truth, homes) + 1e-9
    for one in np.linspace(0, 2, 9):
        for other in np.linspace(0, 2, 9):
            assert best <= loss(pool(proba, np.array([one, other])), truth, homes) + 1e-9


def test_an_inverted_cue_gets_no_weight_and_shrinkage_reduces_weights():
    proba, truth, homes = drawn([1.0, 0.0])
    proba[:, 1] = softmax(-2 * log_softmax(np.log(proba[:, 0]), axis=1), axis=1)
    assert fit_weights(proba[:, 1:], truth, homes, shrinkage=0.0)[0] == 0.0
    sums = [fit_weights(proba, truth, homes, shrinkage=one).sum() for one in (0.0, 0.1, 1.0, 100.0)]
    assert sums == sorted(sums, reverse=True) and sums[-1] < 0.02


def test_each_home_is_cross_validated_with_weights_from_the_others():
    proba, truth, homes = drawn([1.0, 0.3], n=300, seed=9)
    of_homes = {home: proba[homes == home] for home in ("a", "b", "c")}
    labels = {home: truth[homes == home] for home in of_homes}
    trained = fit(of_homes, labels, CLASSES, method="log_pool", shrinkage=0.01)
    weights = fit_weights(proba, truth, homes, shrinkage=0.01)
    assert trained.facts == {"weights": weights.tolist()}
    np.testing.assert_array_equal(trained.integrator.predict_proba(proba), pool(proba, weights))
    np.testing.assert_array_equal(trained.truth, truth)
    others = homes != "b"
    of_others = fit_weights(proba[others], truth[others], homes[others], shrinkage=0.01)
    np.testing.assert_array_equal(trained.cross_validated[~others], pool(of_homes["b"], of_others))
