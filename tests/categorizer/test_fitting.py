import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from placecat.categorizer.fitting import LEAST, fit
from placecat.errors import PlacecatError

SIDES = st.integers(16, 2000)


def test_a_known_size_is_passed_through():
    frame = np.zeros((48, 64, 3), np.uint8)
    assert fit((64, 48), [(32, 24), (64, 48)], resize=True)(frame) is frame


def test_another_size_is_averaged():
    frame = np.zeros((4, 8, 3), np.uint8)
    frame[:, ::2] = 200
    assert np.array_equal(fit((8, 4), [(4, 2)], resize=True)(frame), np.full((2, 4, 3), 100))


def test_the_middle_is_kept():
    frame = np.zeros((4, 8, 3), np.uint8)
    frame[:, 2:6] = 50
    assert (fit((8, 4), [(4, 4)], resize=True)(frame) == 50).all()


def test_the_size_that_keeps_most_is_chosen():
    chosen = fit((1920, 1080), [(640, 480), (320, 180), (1280, 720)], resize=True)
    assert chosen.target == (1280, 720)
    assert chosen.kept == (1920, 1080)


def test_an_aspect_ratio_that_leaves_too_little_is_rejected():
    message = r"720x1280 pixels: cropping it .* 640x480, would leave only 42% of"
    with pytest.raises(PlacecatError, match=message):
        fit((720, 1280), [(640, 480)], resize=True)


@given(st.tuples(SIDES, SIDES), st.tuples(SIDES, SIDES))
def test_the_crop_is_inside_the_frame_and_has_the_target_aspect_ratio(source, target):
    try:
        chosen = fit(source, [target], resize=True)
    except PlacecatError:
        return
    width, height = chosen.kept
    assert width <= source[0] and height <= source[1]
    assert width * height >= LEAST * source[0] * source[1]
    # The aspect ratio is exact to within one pixel, or about a hundredth of the width.
    assert abs(width - height * target[0] / target[1]) <= max(1, target[0] / target[1], 0.011 * width)
