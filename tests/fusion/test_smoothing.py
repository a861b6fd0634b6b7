from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from number_of_examples import examples
from placecat.errors import PlacecatError
from placecat.fusion.delay import Delay
from placecat.fusion.hmm import ForwardFilter, emission_matrix, likelihoods, transition_matrix
from placecat.fusion.smoothing import Smoother, SmoothingModel, apply, fit

SETTINGS = {
    "n_classes": 2,
    "delay_seconds": 0.5,
    "evidence": "hard",
    "evidence_seconds": 1.0,
    "reliability": "hard",
    "transition_counts": 1.0,
    "emission_counts": 1.0,
}


def made():
    rng = np.random.default_rng(1)
    proba = rng.dirichlet([1, 1], 12)
    training = [np.array([0, 0, 0, 1, 1, 1, 1, 0], np.int16)]
    cv = rng.dirichlet([1, 1], 8)
    return proba, {
        "training_sequences": training,
        "training_frame_rates": [5.0],
        "training_proba": cv,
        "training_truth": training[0],
    }


def smooth(proba, sequences, *, frame_rate, times=None, **training):
    return apply(fit(**training), proba, sequences, frame_rate=frame_rate, times=times)


def test_each_sequence_restarts_the_filter():
    proba, training = made()
    both = smooth(proba, [slice(0, 5), slice(5, 12)], frame_rate=7.0, **training, **SETTINGS)
    alone = smooth(proba[5:], [slice(0, 7)], frame_rate=7.0, **training, **SETTINGS)
    np.testing.assert_array_equal(both["hmm"][5:], alone["hmm"])
    np.testing.assert_array_equal(both["delayed"][5:], alone["delayed"])


def test_uneven_frame_times_are_used():
    proba, training = made()
    times = np.array([0, 0.2, 0.4, 0.6, 9.6, 0, 0.1, 0.2, 0.5, 0.9, 1.0, 1.1])
    result = smooth(proba, [slice(0, 5), slice(5, 12)], frame_rate=5.0, times=times, **training, **SETTINGS)
    fitted = fit(**training, **SETTINGS)
    for part in (slice(0, 5), slice(5, 12)):
        smoother = Smoother(fitted)
        steps = [0.2, *np.diff(times[part])]
        expected = [smoother.step(one, step) for one, step in zip(proba[part], steps, strict=True)]
        np.testing.assert_array_equal(result["hmm"][part], [hmm for hmm, _ in expected])
        np.testing.assert_array_equal(result["delayed"][part], [delayed for _, delayed in expected])


@pytest.mark.parametrize("rate", [5.0, 30.0, 25.0, 49.0, 30000 / 1001, 1 / 0.225])
def test_equals_the_filter_and_the_delay_at_the_training_frame_rate(rate):
    """The results are bitwise identical, although 1 / rate is rounded."""
    proba, training = made()
    transition = transition_matrix(training["training_sequences"], 2, smoothing=1.0)
    emission = emission_matrix(training["training_truth"], training["training_proba"], 2)
    forwards, follower = ForwardFilter(transition), Delay(0.5)
    expected = np.array([forwards.step(row) for row in likelihoods(proba, emission)])
    delayed = np.array([follower.step(row, 1 / rate) for row in expected])
    training["training_frame_rates"] = [rate]
    result = smooth(proba, [slice(0, 12)], frame_rate=rate, **training, **SETTINGS)
    np.testing.assert_array_equal(result["hmm"], expected)
    np.testing.assert_array_equal(result["delayed"], delayed)


def model(rate=5.0, leave=0.02, emission=(0.5, 0.25, 0.25), evidence="hard", delay_seconds=2.0):
    """Return a model with three places, each of which is left with probability `leave` per frame."""
    transition = np.full((3, 3), leave / 2) + (1 - 1.5 * leave) * np.eye(3)
    emissions = np.stack([np.roll(emission, place) for place in range(3)])
    return SmoothingModel(transition, emissions, evidence, 1.0, delay_seconds, rate)


def run(smoothing_model, proba, seconds):
    smoother = Smoother(smoothing_model)
    steps = [smoother.step(row, time) for row, time in zip(proba, seconds, strict=True)]
    return np.array([hmm for hmm, _ in steps]), np.array([delayed for _, delayed in steps])


def stays(rng, frames=40):
    """Make an integrator's distributions for a walk with stays of 8 frames. Some frames are wrong."""
    places = np.repeat(rng.integers(0, 3, frames // 8 + 1), 8)[:frames]
    wrong = rng.random(frames) < 0.3
    places = np.where(wrong, rng.integers(0, 3, frames), places)
    return rng.dirichlet(np.ones(3), frames) * 0.5 + 0.5 * np.eye(3)[places]


@settings(max_examples=examples(40), deadline=None)
@given(
    st.integers(0, 10_000),
    st.floats(0.001, 0.03),
    st.sampled_from([(0.5, 0.25, 0.25), (0.6, 0.2, 0.2), (0.4, 0.35, 0.25)]),
    st.sampled_from(["hard", "soft"]),
    st.floats(0.05, 8.0),
    st.sampled_from([5.0, 10.0, 30.0]),
)
def test_frames_repeated_at_six_times_the_rate_give_similar_results(
    seed, leave, emission, evidence, tau, learnt
):
    """The results agree only approximately, because places may change within a frame."""
    proba = stays(np.random.default_rng(seed))
    # Models with different rates make about the same predictions for one second.
    share = 5.0 / learnt
    emission = np.array(emission) ** share
    own = model(learnt, leave * share, emission / emission.sum(), evidence, tau)
    hmm, delayed = run(own, proba, np.full(40, 1 / 5))
    fast_hmm, fast_delayed = run(own, np.repeat(proba, 6, axis=0), np.full(240, 1 / 30))
    # For comparison, run a filter that ignores time.
    unchanged, _ = run(own, np.repeat(proba, 6, axis=0), [None] * 240)
    unaware, _ = run(own, proba, [None] * 40)
    assert np.abs(fast_hmm[5::6] - hmm).max() < 0.15
    assert np.abs(fast_hmm[5::6] - hmm).mean() < 0.03
    # Subtract the influence of the first frame on the delay. It depends on the duration of this frame and
    # fades over time.
    ends = np.arange(1, 41)[:, None] / 5
    started, fast_started = (
        np.exp(-(ends - ends[0]) / tau) * hmm[0],
        np.exp(-(ends - 1 / 30) / tau) * fast_hmm[0],
    )
    assert np.abs(fast_delayed[5::6] - fast_started - (delayed - started)).mean() < 0.05
    assert np.abs(fast_hmm[5::6] - hmm).mean() < 0.5 * np.abs(unchanged[5::6] - unaware).mean()


@settings(max_examples=examples(20), deadline=None)
@given(st.integers(0, 10_000), st.floats(0.001, 0.03))
def test_higher_rates_converge(seed, leave):
    """The filter has a limit in continuous time, so the changes shrink as the rate increases."""
    proba = stays(np.random.default_rng(seed))
    results = []
    for times in (1, 4, 16, 64):
        hmm, _ = run(model(5.0, leave), np.repeat(proba, times, axis=0), np.full(40 * times, 0.2 / times))
        results.append(hmm[times - 1 :: times])
    first, second, third = (np.abs(a - b).mean() for a, b in pairwise(results))
    assert third < 0.5 * second < 0.25 * first


@settings(max_examples=examples(40), deadline=None)
@given(st.integers(0, 10_000), st.lists(st.floats(0.0, 3.0), min_size=10, max_size=10))
def test_distributions_at_uneven_times(seed, seconds):
    proba = np.random.default_rng(seed).dirichlet(np.ones(3), 10)
    for result in run(model(), proba, seconds):
        np.testing.assert_allclose(result.sum(axis=1), 1.0)
        assert (result >= 0).all()


def test_a_second_frame_at_the_same_time_changes_nothing():
    smoother = Smoother(model())
    first = smoother.step(np.array([0.8, 0.1, 0.1]), 0.2)
    again = smoother.step(np.array([0.1, 0.8, 0.1]), 0.0)
    np.testing.assert_allclose(again, first)


def test_the_past_is_forgotten_after_a_long_gap():
    late = np.array([0.1, 0.1, 0.8])
    results = []
    for before in np.eye(3):
        smoother = Smoother(model())
        for _ in range(20):
            smoother.step(before)
        results.append(smoother.step(late, 600.0))
    for hmm, delayed in results:
        np.testing.assert_allclose(delayed, hmm, atol=1e-12)
        # The late frame counts as five frames, which is the limit of one second.
        np.testing.assert_allclose(hmm, np.array([1, 1, 2**5]) / 34, atol=1e-6)


@pytest.mark.parametrize(
    ("rate", "seconds", "frames"), [(5.0, 0.6, 3), (5.0, 9.0, 5), (0.5, 2.0, 1), (0.5, 9.0, 1)]
)
def test_a_frame_counts_for_at_most_a_second_or_one_frame(rate, seconds, frames):
    hmm, _ = Smoother(model(rate)).step(np.array([0.1, 0.1, 0.8]), seconds)
    np.testing.assert_allclose(hmm, np.array([1, 1, 2**frames]) / (2 + 2**frames), rtol=1e-9)


@pytest.mark.parametrize("seconds", [-0.1, float("nan"), float("inf")])
def test_invalid_times_are_rejected_and_change_nothing(seconds):
    smoother, other = Smoother(model()), Smoother(model())
    proba = np.array([0.8, 0.1, 0.1])
    with pytest.raises(PlacecatError, match="the time between two frames is"):
        smoother.step(proba, seconds)
    np.testing.assert_array_equal(smoother.step(proba), other.step(proba))


@settings(max_examples=examples(30), deadline=None)
@given(st.integers(0, 10_000), st.integers(2, 8))
def test_transitions_are_counted_at_the_highest_frame_rate(seed, times):
    """A home filmed at a lower rate counts as if its frames were repeated, except for its last frame."""
    rng = np.random.default_rng(seed)
    walks = [np.repeat(rng.integers(-1, 3, 9), rng.integers(1, 9, 9)).astype(np.int16) for _ in range(2)]
    walks = [np.append(walk, rng.integers(0, 3)).astype(np.int16) for walk in walks]
    mixed = transition_matrix(walks, 3, frame_rates=[5.0, 5.0 * times], smoothing=0.5)
    repeated = np.repeat(walks[0], times)[: len(walks[0]) * times - (times - 1)]
    alike = transition_matrix([repeated, walks[1]], 3, smoothing=0.5)
    np.testing.assert_allclose(mixed, alike, rtol=1e-12)
    assert (mixed > 0).all()


def test_equal_frame_rates_do_not_change_transitions():
    walks = [np.array([0, 0, 1, 1, 0], np.int16), np.array([1, 1, 0], np.int16)]
    for rates in ([5.0, 5.0], [1 / 3, 1 / 3], [29.97, 29.97]):
        np.testing.assert_array_equal(
            transition_matrix(walks, 2, frame_rates=rates), transition_matrix(walks, 2)
        )
    fitted = fit(walks, np.eye(2), np.array([0, 1]), training_frame_rates=[5.0, 30.0], **SETTINGS)
    assert fitted.frame_rate == 30.0
