import cv2
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from placecat.errors import PlacecatError
from placecat.vision.census import LAPLACIANS, cell_histograms, census, histograms, laplacian


def naive_census(image: np.ndarray) -> np.ndarray:
    height, width = image.shape
    codes = np.zeros((height - 2, width - 2), int)
    for y in range(1, height - 1):
        for x in range(1, width - 1):
            bits = ""
            for dy in (-1, 0, 1):
                for dx in (-1, 0, 1):
                    if dy or dx:
                        bits += "1" if image[y, x] >= image[y + dy, x + dx] else "0"
            codes[y - 1, x - 1] = int(bits, 2)
    return codes


def test_example_of_wu_and_rehg() -> None:
    assert census(np.array([[32, 64, 96], [32, 64, 96], [32, 32, 96]], np.uint8)).tolist() == [[0b11010110]]


@pytest.mark.parametrize(("spot", "code"), [((0, 0), 127), ((0, 1), 191), ((2, 1), 253), ((2, 2), 254)])
def test_bit_order(spot: tuple[int, int], code: int) -> None:
    image = np.zeros((3, 3), np.float32)
    image[spot] = 1
    assert census(image).item() == code


@given(arrays(np.int16, st.tuples(st.integers(3, 9), st.integers(3, 9)), elements=st.integers(-4, 4)))
def test_equals_a_naive_loop(image: np.ndarray) -> None:
    np.testing.assert_array_equal(census(image), naive_census(image))


@pytest.mark.parametrize("dtype", [np.uint8, np.int16, np.float32])
def test_stack_equals_single_images(dtype: type) -> None:
    stack = np.random.default_rng(0).integers(0, 9, (4, 6, 7)).astype(dtype)
    np.testing.assert_array_equal(census(stack), [naive_census(image) for image in stack])
    assert census(stack[:0]).shape == (0, 4, 5)


def test_not_contiguous() -> None:
    image = np.random.default_rng(1).integers(0, 9, (12, 14))[::2, ::-1]
    np.testing.assert_array_equal(census(image), naive_census(image))


@pytest.mark.parametrize("shape", [(2, 5), (5, 2), (3, 1, 4)])
def test_too_small(shape: tuple[int, ...]) -> None:
    with pytest.raises(PlacecatError, match="at least 3x3 pixels, not"):
        census(np.zeros(shape))


def test_histograms() -> None:
    codes = np.array([[[0, 0], [3, 255]], [[7, 7], [7, 7]]], np.uint8)
    expected = np.zeros((2, 256))
    expected[0, [0, 3, 255]] = [0.5, 0.25, 0.25]
    expected[1, 7] = 1
    found = histograms(codes)
    np.testing.assert_array_equal(found, expected)
    assert found.dtype == np.float32
    assert histograms(codes[:0]).shape == (0, 256)


@given(st.integers(1, 13), st.integers(1, 13), st.integers(1, 4))
def test_cell_histograms_equal_a_naive_loop(height: int, width: int, cells: int) -> None:
    codes = np.random.default_rng(height * 100 + width).integers(0, 256, (height, width)).astype(np.uint8)
    expected = np.zeros((cells, cells, 256))
    for row in range(cells):
        for column in range(cells):
            top, bottom = row * height // cells, (row + 1) * height // cells
            left, right = column * width // cells, (column + 1) * width // cells
            for y in range(top, bottom):
                for x in range(left, right):
                    expected[row, column, codes[y, x]] += 1 / ((bottom - top) * (right - left))
    found = cell_histograms(codes, cells)
    assert found.shape == (cells * cells, 256)
    np.testing.assert_allclose(found, expected.reshape(-1, 256), atol=1e-6)


def test_laplacian_kernels() -> None:
    assert all(kernel.sum() == 0 for kernel in LAPLACIANS.values())
    image = np.random.default_rng(2).integers(0, 256, (9, 11)).astype(np.uint8)
    np.testing.assert_array_equal(laplacian(image, "cross"), cv2.Laplacian(image, cv2.CV_16S, ksize=1))
    np.testing.assert_array_equal(laplacian(image, "diagonal"), cv2.Laplacian(image, cv2.CV_16S, ksize=3))
    spot = np.zeros((3, 3), np.float32)
    spot[1, 1] = 1
    np.testing.assert_array_equal(laplacian(spot, "full")[1], [2, -8, 2])
