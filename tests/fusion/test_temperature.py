import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from sklearn.metrics import log_loss

from number_of_examples import examples
from placecat.fusion.temperature import fit_temperature, temper


def drawn(temperature, n=4000, seed=0):
    """Draw labels from distributions, and then change the temperature of the distributions."""
    rng = np.random.default_rng(seed)
    true = rng.dirichlet(np.ones(4), n)
    truth = np.array([rng.choice(4, p=p) for p in true])
    return temper(true, 1.0 / temperature), truth


@pytest.mark.parametrize("temperature", [0.2, 1.0, 5.0])
def test_fit_recovers_the_applied_temperature(temperature):
    proba, truth = drawn(temperature)
    assert fit_temperature(proba, truth) == pytest.approx(temperature, rel=0.1)


def balanced(truth, proba):
    return log_loss(truth, proba, sample_weight=1.0 / np.bincount(truth)[truth])


def test_no_other_temperature_has_a_lower_log_loss():
    proba, truth = drawn(3.0, n=300, seed=1)
    keep = (truth > 0) | (np.arange(300) % 5 == 0)
    proba, truth = proba[keep], truth[keep]
    best = balanced(truth, temper(proba, fit_temperature(proba, truth)))
    for other in np.geomspace(0.01, 100, 200):
        assert best <= balanced(truth, temper(proba, other)) + 1e-9


@settings(max_examples=examples(50), deadline=None)
@given(seed=st.integers(0, 999), temperature=st.floats(0.01, 100))
def test_tempered_distributions_keep_their_order_and_sum_to_one(seed, temperature):
    proba = np.random.default_rng(seed).dirichlet(np.full(5, 0.3), (7, 3))
    tempered = temper(proba, temperature)
    np.testing.assert_allclose(tempered.sum(axis=-1), 1.0)
    assert (np.take_along_axis(tempered, proba.argmax(-1)[..., None], -1)[..., 0] == tempered.max(-1)).all()
    np.testing.assert_allclose(temper(tempered, 1.0), tempered, atol=1e-12)


def test_each_cue_has_its_own_temperature():
    proba = np.broadcast_to([0.8, 0.2], (2, 3, 2))
    tempered = temper(proba, np.array([1.0, 2.0, 0.5]))
    for cue, temperature in enumerate((1.0, 2.0, 0.5)):
        np.testing.assert_allclose(tempered[:, cue], temper(proba[:, cue], temperature))


def test_a_wrong_distribution_with_full_confidence_stays_finite():
    proba, truth = np.array([[1.0, 0.0], [1.0, 0.0]]), np.array([0, 1])
    assert 1.0 < fit_temperature(proba, truth) <= 100.0
    assert np.isfinite(temper(proba, 2.0)).all()
