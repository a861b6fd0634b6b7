import numpy as np
import pytest

from placecat_bench.pieces import gentle_adaboost


def test_entries_and_targets():
    time, accuracy, *_ = gentle_adaboost.entries(frames=500, features=8, rounds=10)
    assert (time.input, time.target) == ("500 x 8, 10 rounds", "at least 4x faster")
    assert accuracy.target == "at most 1"
    for part in time.parts.values():
        part()
    assert len(time.ours().feature_) == 10


def test_opencv_makes_nearly_the_same_decisions():
    """With fewer frames than bins, both can split between any two values."""
    time, accuracy, *_ = gentle_adaboost.entries(frames=200, features=8, rounds=10)
    frames = gentle_adaboost.draw_frames(200, 8, gentle_adaboost.HOMES).descriptors
    theirs = time.theirs().predict(frames, flags=256)[1][:, 0]
    assert np.corrcoef(time.ours().decision_function(frames), theirs)[0, 1] > 0.95
    assert abs(accuracy.measure()) < 3


def test_the_accuracy_difference_is_positive_if_ours_is_worse(monkeypatch):
    ours = gentle_adaboost.ours
    monkeypatch.setattr(gentle_adaboost, "ours", lambda X, positive, rounds: ours(X, ~positive, rounds))
    _, accuracy, *_ = gentle_adaboost.entries(frames=200, features=8, rounds=10)
    assert accuracy.measure() > 50


@pytest.mark.parametrize("name", gentle_adaboost.OTHERS)
def test_lightgbm_and_xgboost_are_about_as_accurate(name):
    pytest.importorskip(name, reason="without the extra bench")
    entries = list(gentle_adaboost.entries(frames=500, features=8, rounds=10))
    place = 2 + 2 * list(gentle_adaboost.OTHERS).index(name)
    time, accuracy = entries[place : place + 2]
    assert time.peer == accuracy.peer == gentle_adaboost.OTHERS[name]
    time.ours()
    time.theirs()
    assert abs(accuracy.measure()) < 5
