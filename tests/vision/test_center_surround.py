import numpy as np
import pytest
import reference_attention as reference

from placecat.vision import center_surround, color


@pytest.mark.parametrize("radius", [1, 2, 3])
@pytest.mark.parametrize("shape", [(9, 12), (23, 40), (2, 3), (4, 2)])
def test_difference_equals_explicit_neighbourhoods(shape, radius):
    plane = np.random.default_rng(1).uniform(0, 255, shape).astype(np.float32)
    expected = reference.surround_difference(plane.astype(float), radius)
    bright, dark = center_surround.intensity_contrast(plane, (radius,))[0]
    np.testing.assert_allclose(bright, np.maximum(expected, 0), atol=center_surround.GREY_ROUNDING + 2e-4)
    np.testing.assert_allclose(dark, np.maximum(-expected, 0), atol=center_surround.GREY_ROUNDING + 2e-4)


def test_a_dot_and_its_ring():
    plane = np.zeros((5, 5), np.float32)
    plane[2, 2] = 8
    ring = [[0, 0, 0, 0, 0], [0, 1, 1, 1, 0], [0, 1, 0, 1, 0], [0, 1, 1, 1, 0], [0, 0, 0, 0, 0]]
    bright, dark = center_surround.intensity_contrast(plane, (1,))[0]
    np.testing.assert_allclose(dark, ring, atol=1e-6)
    np.testing.assert_allclose(bright, np.where(plane > 0, 8, 0), atol=1e-6)


def test_a_constant_adds_nothing():
    plane = np.random.default_rng(2).uniform(0, 100, (30, 41)).astype(np.float32)
    np.testing.assert_allclose(
        center_surround.intensity_contrast(plane + 100, (1, 3)),
        center_surround.intensity_contrast(plane, (1, 3)),
        atol=2e-3,
    )


def test_flat_planes_have_no_contrast_at_all():
    for value in (0, 0.1, 85.333, 255):
        plane = np.full((23, 40), value, np.float32)
        assert not center_surround.intensity_contrast(plane, (1, 3)).any()
        assert not center_surround.color_contrast([plane / 85, plane / 85, plane / 85], (1, 3)).any()


def test_color_contrast_matches_the_channels():
    planes = list(np.random.default_rng(3).uniform(-1, 2, (3, 12, 17)).astype(np.float32))
    got = center_surround.color_contrast(planes, (1, 3))
    assert got.shape == (2, 4, 12, 17)
    for k, radius in enumerate((1, 3)):
        for c, channel in enumerate(color.channels(planes)):
            expected = np.maximum(reference.surround_difference(channel.astype(float), radius), 0)
            np.testing.assert_allclose(got[k, c], expected, atol=2e-5)
