import numpy as np
import pytest

from placecat.fusion.integrate import fit
from placecat.fusion.votes import vote_distribution

RNG = np.random.default_rng(3)
CLASSES = ["bath", "hall"]
SVM = {
    "model": "one_against_all",
    "base": {"name": "nu_svm", "gamma": 2.0, "nu": 0.2},
    "scheme": {"name": "one_against_all"},
    "scaling": "none",
}


def outputs(n, flipped):
    """Make two cues. The first contradicts the truth if `flipped`, and the second is uninformative."""
    truth = RNG.integers(0, 2, n).astype(np.int16)
    first = np.where((truth == 0) != flipped, 0.9, 0.1) + RNG.uniform(-0.05, 0.05, n)
    proba = np.stack([np.stack([first, 1 - first], axis=1), RNG.dirichlet([9, 9], n)], axis=1)
    return proba, truth


@pytest.fixture(scope="module")
def data():
    train, truth = {}, {}
    for home in ("a", "b", "c"):
        train[home], truth[home] = outputs(40, flipped=True)
    truth["unused"] = np.zeros(3, np.int16)
    return train, truth, *outputs(50, flipped=True)


def test_das_corrects_an_inverted_cue_and_a_vote_does_not(data):
    train, truth, test, expected = data
    fused = fit(train, truth, CLASSES, method="das", classifier=SVM)
    assert (fused.integrator.predict_proba(test).argmax(axis=1) == expected).mean() > 0.95
    assert fused.cross_validated.shape == (120, 2)
    np.testing.assert_array_equal(fused.truth, np.concatenate([truth[home] for home in train]))
    vote = fit(train, truth, CLASSES, method="vote_distribution").integrator.predict_proba(test)
    assert (vote.argmax(axis=1) == expected).mean() < 0.1
    np.testing.assert_array_equal(vote, vote_distribution(test))


def test_temperatures_are_applied_before_a_vote(data):
    """A correct but uncertain cue is outvoted by a wrong but certain one, unless both are tempered."""
    proba = np.array([[[0.55, 0.45], [0.1, 0.9]]])
    train, truth = {"a": proba}, {"a": np.zeros(1, np.int16)}
    for temperatures, place in ((None, 1), ((0.05, 10.0), 0)):
        fused = fit(train, truth, CLASSES, method="vote_distribution", temperatures=temperatures)
        assert fused.integrator.predict_proba(proba).argmax() == place
