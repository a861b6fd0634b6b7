import cv2
import numpy as np
import pytest
import reference_attention as reference
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra import numpy as hnp

from number_of_examples import examples
from placecat.errors import PlacecatError
from placecat.vision import color


def pure(b, g, r):
    return np.full((2, 2, 3), (b, g, r), np.uint8)


@pytest.mark.parametrize(
    ("bgr", "expected"),
    [
        ((0, 0, 200), (3, -1.5, -1.5, -3)),
        ((0, 90, 0), (-1.5, 3, -1.5, -3)),
        ((255, 0, 0), (-1.5, -1.5, 3, -6)),
        ((0, 70, 70), (0.75, 0.75, -1.5, 3)),
        ((13, 13, 13), (0, 0, 0, 0)),
        ((0, 0, 0), (0, 0, 0, 0)),
    ],
)
def test_channels_of_pure_colours(bgr, expected):
    total, planes = color.reduced_planes(pure(*bgr))
    np.testing.assert_allclose(color.channels(planes)[:, 0, 0], expected, atol=1e-6)
    assert total.tolist() == [[sum(bgr)]]


@pytest.mark.parametrize("clip", [False, True])
@pytest.mark.parametrize(("seed", "height", "width"), [(1, 40, 56), (2, 33, 47), (3, 101, 9)])
def test_pyramid_equals_the_one_of_every_pixels_channels(seed, height, width, clip):
    image = reference.frame(seed, height, width)
    total, planes = color.reduced_planes(image, clip=clip, strip_rows=16)
    pixels = reference.opponent(image)
    expected = [reference.reduce(np.maximum(c, 0) if clip else c) for c in pixels]
    np.testing.assert_allclose(color.channels(planes), expected, atol=2e-6)
    np.testing.assert_allclose(total, reference.reduce(image.sum(axis=2, dtype=float)), atol=1e-3)


@given(
    hnp.arrays(
        np.uint8,
        st.tuples(st.integers(1, 40), st.integers(1, 12), st.just(3)),
        elements=st.sampled_from([0, 1, 128, 255]),
    )
)
@settings(max_examples=examples(60), deadline=None)
def test_any_frame_is_finite_within_range_and_strips_do_not_matter(image):
    total, planes = color.reduced_planes(image, strip_rows=4)
    channels = color.channels(planes)
    assert np.isfinite(channels).all()
    assert channels[:3].min() >= -1.5 - 1e-5
    assert channels[3].min() >= -6 - 1e-5
    assert channels.max() <= 3 + 1e-5
    np.testing.assert_allclose(channels, [reference.reduce(c) for c in reference.opponent(image)], atol=2e-6)
    whole = color.reduced_planes(image, strip_rows=64)
    assert whole[0].tobytes() == total.tobytes()
    assert [p.tobytes() for p in whole[1]] == [p.tobytes() for p in planes]


@pytest.mark.parametrize("clip", [False, True])
def test_the_sum_alone(clip):
    image = reference.frame(2, 61, 47)
    total, planes = color.reduced_planes(image, color=False, clip=clip, strip_rows=16)
    assert planes == []
    assert total.tobytes() == color.reduced_planes(image, clip=clip)[0].tobytes()


def test_views_are_accepted_and_left_alone():
    image = reference.frame(4, 30, 40)
    before = image.copy()
    mirrored = color.reduced_planes(image[:, ::-1])
    np.testing.assert_array_equal(image, before)
    assert mirrored[0].tobytes() == color.reduced_planes(image[:, ::-1].copy())[0].tobytes()


@pytest.mark.parametrize("wrong", [np.zeros((4, 4, 3)), [[0]], np.zeros((4, 4, 3), np.int16)])
def test_wrong_types(wrong):
    with pytest.raises(TypeError, match="uint8"):
        color.check_frame(wrong)


@pytest.mark.parametrize("shape", [(4, 4), (4, 4, 4), (0, 4, 3), (1, 4, 4, 3)])
def test_wrong_shapes(shape):
    with pytest.raises(PlacecatError, match="shape"):
        color.check_frame(np.zeros(shape, np.uint8))


def test_reduced_grey():
    image = reference.frame(3, 360, 640)
    reduced = color.reduced_grey(image, 320)
    assert reduced.shape == (180, 320)
    grey = cv2.cvtColor(image, cv2.COLOR_BGR2GRAY)
    np.testing.assert_allclose(reduced, grey.reshape(180, 2, 320, 2).mean(axis=(1, 3)), atol=0.51)
    for width in (640, 900, None):
        np.testing.assert_array_equal(color.reduced_grey(image, width), grey)
