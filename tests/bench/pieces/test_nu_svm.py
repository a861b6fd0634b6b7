import numpy as np
import pytest

from placecat_bench.pieces import nu_svm

SMALL = {"frames": 320, "features": 32, "homes": 3, "new": 50}


@pytest.fixture(scope="module")
def entries():
    return list(nu_svm.entries(**SMALL))


def test_entries_and_targets(entries):
    assert [(entry.input, entry.target) for entry in entries[:3]] == [
        ("fit 320 x 32, 3 homes", "at least 16x faster"),
        ("predict 50 x 32 from 320", "at least 25x faster"),
        ("predict 50 x 32 from 320", "at most 0.001"),
    ]
    assert [entry.target for entry in entries[3:-1]] == 2 * [
        "at least 3x faster",
        "at least 5x faster",
        "at most 0.005",
    ]
    assert "CUDA 9" in entries[-1].reason
    for entry in (*entries[:2], *entries[3:5]):
        for part in entry.parts.values():
            part()


def test_scikit_learn_gives_the_same_probabilities(entries):
    fit, predict, limit = entries[:3]
    fit.ours()
    fit.theirs()
    found = predict.ours()
    assert found.shape == (50, 5)
    assert np.ptp(found) > 0.1
    np.testing.assert_allclose(found, predict.theirs(), atol=1e-3)
    assert limit.measure() == np.abs(found - predict.theirs()).max()


@pytest.mark.parametrize(("package", "place"), [("sklearn", 3), ("sklearnex", 6)])
def test_the_other_peers_give_nearly_the_same_probabilities(entries, package, place):
    pytest.importorskip(package, reason="without the extra bench")
    fit, _, limit = entries[place : place + 3]
    fit.theirs()
    assert limit.measure() < 0.02


def test_prediction_uses_the_timed_models(monkeypatch):
    """Fitting takes minutes, so it is not repeated."""
    fits = []
    theirs = nu_svm.theirs
    monkeypatch.setattr(nu_svm, "theirs", lambda *given: fits.append(1) or theirs(*given))
    fit, predict, limit, *_ = nu_svm.entries(**SMALL)
    fit.theirs()
    predict.theirs()
    limit.measure()
    assert fits == [1]
