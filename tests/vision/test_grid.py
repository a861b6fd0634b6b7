import cv2
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from placecat.vision.grid import cell_means, cell_weights, mean_variance


def test_divisible() -> None:
    np.testing.assert_array_equal(cell_weights(4, 2), [[0.5, 0.5, 0, 0], [0, 0, 0.5, 0.5]])


def test_pixel_across_a_border_counts_for_both() -> None:
    np.testing.assert_allclose(cell_weights(3, 2), [[2 / 3, 1 / 3, 0], [0, 1 / 3, 2 / 3]])


def test_fewer_pixels_than_cells() -> None:
    np.testing.assert_allclose(cell_weights(2, 4), [[1, 0], [1, 0], [0, 1], [0, 1]])


@given(st.integers(1, 50), st.integers(1, 9))
def test_cells_and_pixels_are_fair(length: int, cells: int) -> None:
    weights = cell_weights(length, cells)
    np.testing.assert_allclose(weights.sum(axis=1), 1)
    np.testing.assert_allclose(weights.sum(axis=0), cells / length)


@pytest.mark.parametrize("shape", [(45, 80), (23, 40), (9, 13), (180, 320)])
def test_cell_means_equal_opencv_area_averaging(shape: tuple[int, int]) -> None:
    image = np.random.default_rng(0).random(shape, np.float32)
    expected = cv2.resize(image, (4, 4), interpolation=cv2.INTER_AREA)
    found = cell_means(image[None], 4)[0]
    np.testing.assert_allclose(found, expected, atol=1e-5)
    assert found.dtype == np.float32


def test_mean_variance_layout() -> None:
    patches = np.arange(4, dtype=np.float32).reshape(1, 1, 2, 2)
    np.testing.assert_allclose(mean_variance(patches, 2)[0], [1.5, 1.25, 0, 0, 1, 0, 2, 0, 3, 0])
    np.testing.assert_allclose(mean_variance(patches, 0)[0], [1.5, 1.25])


@given(st.integers(4, 64), st.integers(1, 3))
def test_mean_variance_equals_weighted_loops(side: int, grid: int) -> None:
    rng = np.random.default_rng(side)
    patches = rng.normal(50, 5, (2, 3, side, side)).astype(np.float32)
    found = mean_variance(patches, grid)
    assert found.shape == (2, 2 * 3 * (1 + grid * grid))
    for patch, row in zip(patches.astype(float), found, strict=True):
        expected = [*(c.mean() for c in patch), *(c.var() for c in patch)]
        for down in range(grid):
            for right in range(grid):
                area = np.zeros((side, side))
                for y in range(side):
                    for x in range(side):
                        high = min(y + 1, (down + 1) * side / grid) - max(y, down * side / grid)
                        wide = min(x + 1, (right + 1) * side / grid) - max(x, right * side / grid)
                        area[y, x] = max(high, 0) * max(wide, 0)
                means = [np.average(c, weights=area) for c in patch]
                expected += means
                expected += [
                    np.average((c - m) ** 2, weights=area) for c, m in zip(patch, means, strict=True)
                ]
        np.testing.assert_allclose(row, expected, rtol=1e-4, atol=1e-5)


@given(st.floats(0, 1e4), st.floats(0, 1e-3))
def test_variance_is_never_negative(level: float, noise: float) -> None:
    rng = np.random.default_rng(4)
    patches = (level + noise * rng.random((1, 1, 7, 7))).astype(np.float32)
    assert (mean_variance(patches, 3)[0].reshape(10, 2)[:, 1] >= 0).all()
