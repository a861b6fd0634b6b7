import numpy as np
import pytest
import reference_attention as reference

from placecat.vision.spectral_residual import spectral_residual


def texture(shape, seed=1):
    return np.random.default_rng(seed).uniform(0, 255, shape).astype(np.float32)


@pytest.mark.parametrize("shape", [(24, 40), (23, 41), (45, 80), (2, 2), (2, 3), (3, 2), (7, 4)])
@pytest.mark.parametrize(("box", "sigma"), [(3, 1.0), (5, 0.0)])
def test_equals_numpy_transform_of_the_whole_spectrum(shape, box, sigma):
    plane = texture(shape)
    expected = reference.spectral_residual(plane.astype(float), box, sigma)
    got = spectral_residual(plane, residual_box=box, residual_sigma=sigma)
    assert got.dtype == np.float32
    np.testing.assert_allclose(got, expected, atol=2e-3)


def test_something_that_breaks_a_pattern_stands_out():
    _, x = np.mgrid[:48, :64]
    plane = (128 + 60 * np.cos(2 * np.pi * x / 8) + 5 * texture((48, 64)) / 255).astype(np.float32)
    plane[20:23, 40:43] = 255
    top = np.unravel_index(spectral_residual(plane).argmax(), plane.shape)
    assert abs(top[0] - 21) <= 2
    assert abs(top[1] - 41) <= 2


def test_flat_images_have_no_saliency():
    for value in (0, 85.333, 255):
        assert not spectral_residual(np.full((23, 40), value, np.float32)).any()


def test_working_width():
    plane = texture((40, 80))
    small = spectral_residual(plane, residual_width=20)
    assert small.shape == plane.shape
    assert not np.allclose(small, spectral_residual(plane), atol=0.05)
    np.testing.assert_array_equal(spectral_residual(plane, residual_width=200), spectral_residual(plane))
