import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.integrate import solve_ivp

from placecat.fusion.delay import Delay

taus = st.floats(0.01, 100.0)


def delay(set_point, seconds, frame_rate):
    """Apply the delay to a complete sequence."""
    follower = Delay(seconds)
    steps = [follower.step(target, 1.0 / frame_rate) for target in set_point]
    return np.array(steps).reshape(set_point.shape)


def distributions(frames, seed=0):
    return np.random.default_rng(seed).dirichlet(np.ones(3), frames)


def test_follows_equation_16():
    target = np.array([[1.0, 0.0], [0.0, 1.0], [0.0, 1.0]])
    h = 0.25
    tau = -0.2 / np.log(1 - h)
    result = delay(target, seconds=tau, frame_rate=5.0)
    np.testing.assert_allclose(result, [[1, 0], [0.75, 0.25], [0.5625, 0.4375]])


@pytest.mark.parametrize("seconds", [0, 0.0])
def test_a_time_constant_of_zero_passes_the_input_through(seconds):
    target = distributions(7)
    np.testing.assert_array_equal(delay(target, seconds=seconds, frame_rate=5.0), target)


def test_is_causal():
    target = distributions(9)
    whole = delay(target, seconds=1.0, frame_rate=5.0)
    np.testing.assert_array_equal(whole[:4], delay(target[:4], seconds=1.0, frame_rate=5.0))


def test_frame_by_frame_equals_the_complete_sequence():
    """The results are bitwise identical and follow equation (16)."""
    target = distributions(50)
    whole, follower, state = delay(target, seconds=2.0, frame_rate=5.0), Delay(2.0), target[0]
    h = 1 - np.exp(-0.2 / 2.0)
    for t in range(50):
        state = state + h * (target[t] - state)
        np.testing.assert_allclose(whole[t], state, rtol=1e-13)
        np.testing.assert_array_equal(follower.step(target[t], 0.2), whole[t])


def test_solves_equation_14():
    """Compare with a numerical solver for differential equations, with frames at uneven times."""
    times = np.cumsum([0.0, 0.1, 0.7, 0.05, 2.0, 0.4])
    target, follower, tau = distributions(6), Delay(0.8), 0.8
    state = follower.step(target[0], 0.3)
    for t in range(1, 6):
        solved = solve_ivp(
            lambda _, p, held=target[t]: (held - p) / tau,
            (times[t - 1], times[t]),
            state,
            rtol=1e-10,
            atol=1e-12,
        )
        state = follower.step(target[t], times[t] - times[t - 1])
        np.testing.assert_allclose(state, solved.y[:, -1], rtol=1e-7)


@given(taus, st.integers(2, 30), st.integers(0, 100))
def test_repeated_frames_at_a_higher_rate_change_nothing(tau, times, seed):
    target = distributions(12, seed)
    slow = delay(target, seconds=tau, frame_rate=5.0)
    fast = delay(np.repeat(target, times, axis=0), seconds=tau, frame_rate=5.0 * times)
    np.testing.assert_allclose(fast[times - 1 :: times], slow, atol=1e-12)


@given(taus, st.floats(0.1, 60.0))
def test_step_response_has_the_time_constant(tau, rate):
    """After tau seconds, the output has covered 63% of a step."""
    frames = 1 + int(np.ceil(tau * rate))
    target = np.repeat([[1.0, 0.0], [0.0, 1.0]], [1, frames], axis=0)
    left = delay(target, seconds=tau, frame_rate=rate)[:, 0]
    np.testing.assert_allclose(left, np.exp(-np.arange(frames + 1) / rate / tau), atol=1e-12)


def test_no_elapsed_time_changes_nothing():
    follower = Delay(1.0)
    first = follower.step(np.array([1.0, 0.0]), 0.2)
    np.testing.assert_array_equal(follower.step(np.array([0.0, 1.0]), 0.0), first)


def test_no_frames():
    assert delay(np.zeros((0, 5)), seconds=1.0, frame_rate=5.0).shape == (0, 5)
