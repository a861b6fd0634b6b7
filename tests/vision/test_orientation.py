import cv2
import numpy as np
import pytest
import reference_attention as reference

from placecat.vision import orientation

SETTINGS = {"gabor_size": 9, "gabor_sigma": 2.0, "gabor_wavelength": 4.0, "gabor_aspect": 1.0}


@pytest.mark.parametrize("aspect", [1.0, 0.5])
@pytest.mark.parametrize("size", [9, 7])
def test_magnitude_equals_two_dimensional_kernels(aspect, size):
    plane = np.random.default_rng(1).normal(0, 30, (21, 34)).astype(np.float32)
    got = orientation.orientation_maps(
        plane, gabor_size=size, gabor_sigma=1.7, gabor_wavelength=5.0, gabor_aspect=aspect
    )
    for plane_of_angle, angle in zip(got, (0, 45, 90, 135), strict=True):
        expected = reference.gabor_magnitude(plane.astype(float), angle, size, 1.7, 5.0, aspect)
        np.testing.assert_allclose(plane_of_angle, expected, atol=2e-4)


@pytest.mark.parametrize("phase", [0.0, 1.0, np.pi / 2])
def test_single_phase_is_the_kernel_of_opencv(phase):
    plane = np.random.default_rng(2).normal(0, 30, (21, 34)).astype(np.float32)
    got = orientation.orientation_maps(plane, gabor_phase=phase, **SETTINGS)
    total = cv2.getGaborKernel((9, 9), 2.0, 0, 1e9, 1.0, 0).sum()
    for plane_of_angle, degrees in zip(got, orientation.ANGLES, strict=True):
        kernel = cv2.getGaborKernel((9, 9), 2.0, np.deg2rad(degrees), 4.0, 1.0, phase) * 2 / total
        # OpenCV's kernel is rotated by 180 degrees, because filter2D computes a correlation.
        expected = cv2.filter2D(
            plane.astype(float), cv2.CV_64F, kernel[::-1, ::-1], borderType=cv2.BORDER_REFLECT_101
        )
        np.testing.assert_allclose(plane_of_angle, np.abs(expected), atol=2e-4)


def test_a_wave_answers_at_its_angle_with_its_amplitude():
    y, x = np.mgrid[:40, :40]
    half = np.sqrt(0.5)
    for k, (dx, dy) in enumerate([(1, 0), (half, half), (0, 1), (-half, half)]):
        wave = (20 * np.cos(np.pi / 2 * (x * dx + y * dy))).astype(np.float32)
        inner = orientation.orientation_maps(wave)[:, 10:30, 10:30]
        assert inner.mean(axis=(1, 2)).argmax() == k
        np.testing.assert_allclose(inner[k], 20, rtol=0.03)


def test_turning_the_image_swaps_the_angles():
    plane = np.random.default_rng(3).normal(0, 30, (32, 32)).astype(np.float32)
    maps = orientation.orientation_maps(plane)
    turned = orientation.orientation_maps(np.ascontiguousarray(plane.T))
    for here, there in ((0, 2), (1, 1), (2, 0), (3, 3)):
        np.testing.assert_allclose(turned[here], maps[there].T, atol=1e-4)


def test_flat_and_tiny_planes():
    assert not orientation.orientation_maps(np.zeros((23, 40), np.float32)).any()
    assert orientation.orientation_maps(np.ones((2, 3), np.float32)).shape == (4, 2, 3)
