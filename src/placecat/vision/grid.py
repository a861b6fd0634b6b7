"""Compute means and variances over the cells of a regular grid."""

from functools import lru_cache

import numpy as np
from numpy.typing import NDArray


@lru_cache(maxsize=256)
def cell_weights(length: int, cells: int) -> NDArray[np.float64]:
    """Return weights that average ``length`` pixels into ``cells`` equal cells.

    If a cell border cuts through a pixel, the pixel is split proportionally between the two cells, so all
    cells have the same size. The thesis does not say how it divides a length that is not a multiple of the
    number of cells.

    Both numbers refer to a single axis and are at least 1. ``length`` may be less than ``cells``. Returns a
    read-only (cells, length) float64 array whose rows sum to 1.
    """
    edges = np.arange(cells + 1) * (length / cells)
    pixels = np.arange(length)
    overlap = np.minimum(edges[1:, None], pixels + 1) - np.maximum(edges[:-1, None], pixels)
    weights = np.clip(overlap, 0, None) * (cells / length)
    weights.flags.writeable = False
    return weights


def cell_means(maps: NDArray[np.float32], cells: int) -> NDArray[np.float32]:
    """Average (..., h, w) float32 maps over a ``cells`` x ``cells`` grid, using two small matrix products.

    Returns (..., cells, cells) float32, with rows from the top and columns from the left.
    """
    height, width = maps.shape[-2:]
    rows, columns = (cell_weights(length, cells).astype(np.float32) for length in (height, width))
    return np.asarray((rows @ maps) @ columns.T, np.float32)


def mean_variance(patches: NDArray[np.float32], grid: int) -> NDArray[np.float32]:
    """Compute the mean and variance of each channel, over the whole patch and over each cell of a grid.

    `patches` is (n, c, h, w) float32. `grid` is the number of cells along each axis, or 0 for the whole patch
    only. Returns (n, 2 c (1 + grid**2)) float32. The whole patch comes first, then the cells row by row from
    the top left. Each of these areas contributes c means, then c non-negative variances (with divisor N).
    """
    count, channels = patches.shape[:2]
    values = patches.astype(np.float64)
    # Variances are computed as differences of squares, so the values are centred first to preserve precision.
    centre = values.mean(axis=(2, 3), keepdims=True)
    values -= centre
    areas = [_moments(values, centre[:, :, 0, 0], 1)]
    if grid:
        areas.append(_moments(values, centre[:, :, 0, 0], grid))
    size = 2 * channels * (1 + grid**2)
    return np.concatenate(areas, axis=1).reshape(count, size).astype(np.float32)


def _moments(values: NDArray[np.float64], centre: NDArray[np.float64], cells: int) -> NDArray[np.float64]:
    """Return the (n, cells**2, 2c) moments of (n, c, h, w) centred values."""
    count, channels, height, width = values.shape
    rows, columns = cell_weights(height, cells), cell_weights(width, cells).T
    mean = rows @ values @ columns
    variance = np.clip(rows @ (values * values) @ columns - mean * mean, 0, None)
    mean += centre[:, :, None, None]
    both = np.concatenate([mean, variance], axis=1)
    return both.reshape(count, 2 * channels, cells * cells).transpose(0, 2, 1)
