"""The categorizer without the pipeline. tests/test_pipeline.py compares it with the batch pipeline."""

from dataclasses import replace

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
    """Later frames do not change earlier decisions."""
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


def test_without_times_frames_have_the_frame_rate_of_the_model(categorizer):
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
    # Each frame carries less evidence, and less time has passed.
    np.testing.assert_array_equal(own[-1].integrated, fast[-1].integrated)
    assert np.abs(fast[0].hmm - 1 / 3).max() < np.abs(own[0].hmm - 1 / 3).max()


@pytest.mark.parametrize("seconds", [-1.0, float("nan")])
def test_invalid_times_are_rejected(categorizer, seconds):
    with pytest.raises(PlacecatError, match="the time between two frames is"):
        categorizer.update(frames(1)[0], seconds)


def test_clock_times_are_equivalent_to_seconds_between_frames(categorizer):
    seen, steps = frames(5), [0.2, 0.05, 0.5, 0.0, 1.25]
    between = [categorizer.update(frame, step) for frame, step in zip(seen, steps, strict=True)]
    categorizer.reset()
    start = 2.0**30
    clock = [
        categorizer.update(frame, time=float(start + time))
        for frame, time in zip(seen, np.cumsum([0.0, *steps[1:]]), strict=True)
    ]
    for one, two in zip(between, clock, strict=True):
        np.testing.assert_allclose(one.proba, two.proba, rtol=1e-6)
        assert two.seconds - start == pytest.approx(one.seconds)
    assert between[-1].seconds == pytest.approx(sum(steps[1:]))


def test_a_repeated_frame_adds_no_evidence(categorizer):
    first, second = frames(2)
    categorizer.update(first, time=1.0)
    once = categorizer.update(second, time=1.5)
    twice = categorizer.update(second, time=1.5)
    np.testing.assert_allclose(once.proba, twice.proba, atol=1e-12)
    np.testing.assert_allclose(once.hmm, twice.hmm, atol=1e-12)
    assert twice.seconds == once.seconds
    assert sum(visit.frames for visit in categorizer.visits()) == 2


def test_invalid_frames_are_rejected_and_skipped(categorizer):
    with pytest.raises(PlacecatError, match="OpenCV returns None if a camera fails"):
        categorizer.update(None)
    assert categorizer.visits() == []


@pytest.mark.parametrize(
    ("times", "message"),
    [
        ({"time": 0.5}, "a frame is 1.5 s older than the previous one"),
        ({"time": float("inf")}, "frame time is inf"),
        ({"seconds": -0.1}, "the time between two frames is"),
        ({"seconds": 0.1, "time": 3.0}, "not both"),
        ({"seconds": "0.1"}, "'0.1': pass a number of seconds"),
        ({"time": "now"}, "'now': pass a number of seconds"),
    ],
)
def test_a_frame_with_an_invalid_time_is_skipped(categorizer, times, message):
    first, late, second = frames(3)
    categorizer.update(first, time=2.0)
    expected = categorizer.update(second, time=2.5)
    visits = categorizer.visits()
    categorizer.reset()
    categorizer.update(first, time=2.0)
    with pytest.raises(PlacecatError, match=message):
        categorizer.update(late, **times)
    np.testing.assert_array_equal(categorizer.update(second, time=2.5).proba, expected.proba)
    assert categorizer.visits() == visits


def test_a_decision_is_about_the_times_that_the_delay_mixes(categorizer):
    """Compute equation (16) by hand: the weights of the filter's outputs, and the mean of their times."""
    steps = [0.2, 0.4, 0.1, 2.0]
    weights, times = np.zeros(0), np.zeros(0)
    for frame, step in zip(frames(4), steps, strict=True):
        decision = categorizer.update(frame, step)
        share = 1 - np.exp(-step / 2.0) if len(weights) else 1.0
        weights = np.append(weights * (1 - share), share)
        times = np.append(times, decision.seconds)
        assert decision.about == pytest.approx(weights @ times)
    assert 0 < decision.seconds - decision.about < 2.0


def test_below_the_threshold_of_the_card_a_place_is_unknown():
    system = make_system()
    assert Categorizer(system).threshold == 0.4
    seen = [Categorizer(system).update(frame, 0.2) for frame in frames(3)]
    confidence = seen[0].confidence
    for threshold, name in (
        (confidence, seen[0].place),
        (confidence + 1e-9, "unknown"),
        (None, "unknown"),
        (0.0, seen[0].place),
    ):
        card = system.card | {"unknown": system.card["unknown"] | {"threshold": threshold}}
        categorizer = Categorizer(replace(system, card=card))
        decision = categorizer.update(frames(1)[0], 0.2)
        assert (decision.name, decision.is_known) == (name, name != "unknown")
        assert (decision.place, decision.confidence) == (seen[0].place, confidence)
        assert [visit.place for visit in categorizer.visits()] == [name]
    assert Categorizer(replace(system, card=system.card | {"unknown": None})).update(frames(1)[0]).is_known


def test_visits_are_the_names_of_the_decisions(categorizer):
    assert categorizer.visits() == []
    seen = frames(3) + frames(3, seed=9)
    decisions = [categorizer.update(frame, time=time) for time, frame in enumerate(seen)]
    visits = categorizer.visits()
    assert [name for visit in visits for name in [visit.place] * visit.frames] == [
        one.name for one in decisions
    ]
    assert (visits[0].start, visits[-1].end) == (0, 5)
    categorizer.reset()
    assert categorizer.visits() == []


@pytest.mark.parametrize(
    ("frame", "message"),
    [
        (np.zeros((90, 160, 3), np.uint8), "160x90 pixels, but the model was trained on 320x180"),
        (np.zeros((180, 320), np.uint8), "height, width, 3"),
        (np.zeros((180, 320, 3), np.float32), "uint8"),
    ],
)
def test_unsuitable_frames_are_rejected_and_change_nothing(categorizer, frame, message):
    first, second = frames(2)
    categorizer.update(first)
    expected = categorizer.update(second).proba
    categorizer.reset()
    categorizer.update(first)
    with pytest.raises(PlacecatError, match=message):
        categorizer.update(frame)
    np.testing.assert_array_equal(categorizer.update(second).proba, expected)


def test_frames_of_other_sizes_are_scaled_on_request():
    system = make_system()
    plain, scaling = Categorizer(system), Categorizer(system, resize=True)
    seen = frames(3)
    # Each pixel is repeated four times, and borders are added above and below. Only the middle remains.
    large = [
        np.pad(np.kron(frame, np.ones((2, 2, 1), np.uint8)), ((100, 100), (0, 0), (0, 0))) for frame in seen
    ]
    for frame, other in zip(seen, (large[0], seen[1], large[2]), strict=True):
        np.testing.assert_array_equal(plain.update(frame).proba, scaling.update(other).proba)
    with pytest.raises(PlacecatError, match=r"would leave only 32% of it; film .*, or train a model"):
        scaling.update(np.zeros((320, 180, 3), np.uint8))


def test_the_frame_is_not_modified(categorizer):
    frame = frames(1)[0]
    before = frame.copy()
    categorizer.update(frame)
    np.testing.assert_array_equal(frame, before)
