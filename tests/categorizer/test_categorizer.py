"""The streaming object by itself; tests/test_pipeline.py compares it with the batch pipeline."""

import numpy as np
import pytest
from made_system import CLASSES, frames, make_system

from placecat.categorizer import Categorizer
from placecat.errors import PlacecatError


@pytest.fixture(scope="module", params=[False, True], ids=["found regions", "followed regions"])
def categorizer(request):
    return Categorizer(make_system(tracked=request.param))


@pytest.fixture(autouse=True)
def from_the_start(request):
    if "categorizer" in request.fixturenames:
        request.getfixturevalue("categorizer").reset()


def test_a_decision_is_a_distribution_and_its_parts(categorizer):
    decision = categorizer.update(frames(1)[0])
    assert decision.place in CLASSES
    assert decision.confidence == decision.proba.max() == decision.proba[CLASSES.index(decision.place)]
    for proba in (decision.proba, decision.hmm, decision.integrated, *decision.cues.values()):
        assert proba.shape == (3,)
        assert proba.sum() == pytest.approx(1)
    assert list(decision.cues) == ["gist", "hog_y"]
    assert decision.regions.shape[1] == 4
    assert 0 < len(decision.regions) <= 10


def test_it_is_causal(categorizer):
    """What comes later does not change what was decided."""
    seen = frames(6)
    short = [categorizer.update(frame).proba for frame in seen[:3]]
    categorizer.reset()
    long = [categorizer.update(frame).proba for frame in [*seen[:3], *frames(3, seed=5)]]
    np.testing.assert_array_equal(short, long[:3])


def test_a_reset_forgets_everything(categorizer):
    seen = frames(4)
    first = [categorizer.update(frame) for frame in seen]
    without = categorizer.update(seen[0])
    categorizer.reset()
    again = [categorizer.update(frame) for frame in seen]
    np.testing.assert_array_equal([one.proba for one in first], [one.proba for one in again])
    np.testing.assert_array_equal([one.regions for one in first][-1], [one.regions for one in again][-1])
    assert not np.array_equal(without.proba, first[0].proba)


def test_frames_come_at_the_rate_of_the_model_unless_their_times_are_given(categorizer):
    seen = frames(4)
    assert categorizer.frame_rate == 5.0
    own = [categorizer.update(frame) for frame in seen]
    categorizer.reset()
    same = [categorizer.update(frame, 0.2) for frame in seen]
    categorizer.reset()
    fast = [categorizer.update(frame, 1 / 30) for frame in seen]
    for attribute in ("hmm", "proba"):
        first, second, third = ([getattr(one, attribute) for one in run] for run in (own, same, fast))
        np.testing.assert_array_equal(first, second)
        assert not np.allclose(first, third)
    # Each frame says less, and less time has passed.
    np.testing.assert_array_equal(own[-1].integrated, fast[-1].integrated)
    assert np.abs(fast[0].hmm - 1 / 3).max() < np.abs(own[0].hmm - 1 / 3).max()


@pytest.mark.parametrize("seconds", [-1.0, float("nan")])
def test_impossible_times_are_refused(categorizer, seconds):
    with pytest.raises(PlacecatError, match="s between two frames"):
        categorizer.update(frames(1)[0], seconds)


@pytest.mark.parametrize(
    ("frame", "message"),
    [
        (np.zeros((90, 160, 3), np.uint8), "160x90 pixels, but the model was trained on 320x180"),
        (np.zeros((180, 320), np.uint8), "height, width, 3"),
        (np.zeros((180, 320, 3), np.float32), "uint8"),
    ],
)
def test_frames_that_do_not_fit_are_refused_and_change_nothing(categorizer, frame, message):
    first, second = frames(2)
    categorizer.update(first)
    expected = categorizer.update(second).proba
    categorizer.reset()
    categorizer.update(first)
    with pytest.raises(PlacecatError, match=message):
        categorizer.update(frame)
    np.testing.assert_array_equal(categorizer.update(second).proba, expected)


def test_the_frame_is_left_as_it_was(categorizer):
    frame = frames(1)[0]
    before = frame.copy()
    categorizer.update(frame)
    np.testing.assert_array_equal(frame, before)
