import numpy as np
import pytest

from placecat_bench.pieces import nu_svm

SMALL = {"frames": 320, "features": 32, "homes": 3, "new": 50}


@pytest.fixture(scope="module")
def entries():
    return list(nu_svm.entries(**SMALL))


def test_its_entries_and_targets(entries):
    assert [(entry.input, entry.target) for entry in entries] == [
        ("fit 320 x 32, 3 homes", "at least 16x faster"),
        ("predict 50 x 32 from 320", "at least 25x faster"),
        ("predict 50 x 32 from 320", "at most 0.001"),
    ]
    for entry in entries[:2]:
        for part in entry.parts.values():
            part()


def test_scikit_learn_gives_the_same_probabilities(entries):
    fit, predict, limit = entries
    fit.ours()
    fit.theirs()
    found = predict.ours()
    assert found.shape == (50, 5)
    assert np.ptp(found) > 0.1
    np.testing.assert_allclose(found, predict.theirs(), atol=1e-3)
    assert limit.measure() == np.abs(found - predict.theirs()).max()


def test_the_models_that_were_timed_predict(monkeypatch):
    """Theirs takes minutes: it is not fitted again."""
    fits = []
    theirs = nu_svm.theirs
    monkeypatch.setattr(nu_svm, "theirs", lambda *given: fits.append(1) or theirs(*given))
    fit, predict, limit = nu_svm.entries(**SMALL)
    fit.theirs()
    predict.theirs()
    limit.measure()
    assert fits == [1]
