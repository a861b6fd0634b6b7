"""The exposure, motion blur and noise of the camera."""

import numpy as np
import pytest

from placecat_homes.sensor import Sensor, develop, exposures, motion, smear
from placecat_homes.view import Lens, Pose

STILL = Sensor(drift=0.0, noise=0.0, blur=0.0, sharpen=0.0, vignette=0.0, balance=0.0)


def test_exposure_brings_dark_and_bright_rooms_to_one_level():
    for level in (0.01, 0.3):
        factors = exposures(np.full((5, 9, 16, 3), level), STILL, 0)
        assert factors * level == pytest.approx(STILL.key, rel=0.01)


def test_exposure_lags_behind_a_change_of_light():
    previews = np.full((30, 9, 16, 3), 0.02)
    previews[10:] = 0.2
    factors = exposures(previews, STILL, 0)[:, 0]
    assert factors[9] == pytest.approx(factors[0])
    assert (np.diff(factors[9:]) < 0).all()
    assert factors[10] * 0.2 > 2 * STILL.key
    assert factors[29] * 0.2 == pytest.approx(STILL.key, rel=0.05)


def test_white_balance_removes_part_of_a_cast():
    previews = np.full((40, 9, 16, 3), 0.1) * [1.4, 1.0, 0.6]
    kept = exposures(previews, STILL, 0) * [1.4, 1.0, 0.6]
    balanced = exposures(previews, Sensor(drift=0, balance=1.0), 0) * [1.4, 1.0, 0.6]
    assert np.ptp(balanced[-1]) < 0.02 * np.ptp(kept[-1])


def test_exposure_is_reproducible_with_a_seed():
    previews = np.random.default_rng(0).uniform(0.01, 0.5, (20, 9, 16, 3))
    sensor = Sensor()
    assert np.array_equal(exposures(previews, sensor, 1), exposures(previews, sensor, 1))
    assert not np.array_equal(exposures(previews, sensor, 1), exposures(previews, sensor, 2))


def test_motion_of_a_turn_and_a_sideways_step():
    lens, far = Lens(64, 36, 60), np.full((36, 64), 50.0, np.float32)
    focus = 32 / np.tan(np.radians(30))
    # Turning left by a small angle moves the picture to the right.
    flow = motion(Pose(0, 0, 0, 0), Pose(0, 0, 0, 0.02), lens, far, 1.0)
    assert flow[18, 32] == pytest.approx([0.02 * focus, 0], abs=0.05)
    # A step to the right (towards -y) moves objects at a distance of 2 m to the left.
    near = np.full((36, 64), 2.0, np.float32)
    flow = motion(Pose(0, 0, 0, 0), Pose(0, -0.1, 0, 0), lens, near, 0.5)
    assert flow[18, 32] == pytest.approx([-0.05 * focus * 0.5, 0], abs=0.05)


def test_smear_spreads_a_line_along_the_motion():
    picture = np.zeros((20, 40, 3), np.float32)
    picture[:, 20] = 1
    flow = np.zeros((20, 40, 2), np.float32)
    flow[..., 0] = 8
    blurred = smear(picture, flow)
    assert blurred.sum() == pytest.approx(picture.sum(), rel=0.01)
    assert (blurred[10, :, 0] > 0.05).sum() >= 5
    assert np.array_equal(smear(picture, np.zeros_like(flow)), picture)


def test_develop_gives_bgr_with_monotone_tones_and_seeded_noise():
    ramp = np.linspace(0, 2, 64, dtype=np.float32)[None, :, None] * np.float32([1, 0.5, 0.25])
    frame = develop(np.tile(ramp, (8, 1, 1)), np.ones(3, np.float32), STILL, 0)
    assert frame.shape == (8, 64, 3) and frame.dtype == np.uint8
    assert (np.diff(frame[0].astype(int), axis=0) >= 0).all()
    assert frame[0, 40, 0] < frame[0, 40, 1] < frame[0, 40, 2]
    noisy = Sensor(noise=3.0)
    flat = np.full((64, 64, 3), 0.18, np.float32)
    first, again, other = (develop(flat, np.ones(3, np.float32), noisy, seed) for seed in (1, 1, 2))
    assert np.array_equal(first, again)
    assert not np.array_equal(first, other)
    assert 1.0 < first.std() < 6.0
