import numpy as np
import pytest

from placecat.errors import PlacecatError
from placecat.fusion.delay import Delay, delay


def test_follows_equation_16():
    target = np.array([[1.0, 0.0], [0.0, 1.0], [0.0, 1.0]])
    np.testing.assert_allclose(delay(target, step=0.25), [[1, 0], [0.75, 0.25], [0.5625, 0.4375]])


def test_step_one_passes_through():
    target = np.random.default_rng(0).random((7, 3))
    np.testing.assert_allclose(delay(target, step=1.0), target)


def test_is_causal():
    target = np.random.default_rng(0).random((9, 3))
    np.testing.assert_array_equal(delay(target, step=0.3)[:4], delay(target[:4], step=0.3))


def test_frame_by_frame_is_the_whole_sequence():
    """Bit for bit, and as equation (16) is written."""
    target = np.random.default_rng(0).dirichlet(np.ones(5), 50)
    whole, follower, state = delay(target, step=0.3), Delay(0.3), target[0]
    for t in range(50):
        state = state + 0.3 * (target[t] - state)
        np.testing.assert_array_equal(whole[t], state)
        np.testing.assert_array_equal(follower.step(target[t]), state)


def test_closed_form_of_a_step():
    target = np.repeat([[1.0, 0.0], [0.0, 1.0]], [1, 20], axis=0)
    expected = 0.9 ** np.arange(21)
    np.testing.assert_allclose(delay(target, step=0.1)[:, 0], expected)


@pytest.mark.parametrize("step", [0.0, -0.5, 1.5])
def test_impossible_steps_are_refused(step):
    with pytest.raises(PlacecatError, match=r"smoothing\.delay_step"):
        delay(np.eye(2), step=step)


def test_no_frames():
    assert delay(np.zeros((0, 5)), step=0.1).shape == (0, 5)
