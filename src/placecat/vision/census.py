"""Compute the census transform, its histograms, and the 3x3 Laplacian that may precede it."""

from functools import lru_cache
from itertools import pairwise, product
from typing import Any

import cv2
import numpy as np
from numpy.typing import NDArray

from placecat.errors import PlacecatError

CODES = 256

# Up to this many pixels per cell, one joint histogram over cells and codes is faster than one histogram per
# cell.
_FEW = 10_000

# Neighbours are ordered left to right, then top to bottom. The first one sets the highest bit.
_NEIGHBOURS = ((-1, -1), (-1, 0), (-1, 1), (0, -1), (0, 1), (1, -1), (1, 0), (1, 1))

LAPLACIANS = {
    "cross": np.array([[0, 1, 0], [1, -4, 1], [0, 1, 0]], np.float32),
    "full": np.array([[1, 1, 1], [1, -8, 1], [1, 1, 1]], np.float32),
    "diagonal": np.array([[2, 0, 2], [0, -8, 0], [2, 0, 2]], np.float32),
}


def census(images: NDArray[Any]) -> NDArray[np.uint8]:
    """Compute the census transform: one bit for each of the eight neighbours of a pixel.

    A bit is set if the centre is at least as bright as the neighbour. Neighbours are ordered left to right,
    then top to bottom. The top left neighbour sets the highest bit (128), and the bottom right one sets the
    lowest (1). Border pixels have no code.

    `images` is (..., h, w) of any real dtype. Raises PlacecatError if h or w is below 3. Returns
    (..., h - 2, w - 2) uint8.

    References
    ----------
    Zabih and Woodfill, ECCV 1994; Wu and Rehg, CENTRIST, PAMI 2011, equation 1 (thesis 3.1.2).
    """
    *_, height, width = images.shape
    if height < 3 or width < 3:
        raise PlacecatError(
            f"the census transform needs at least 3x3 pixels, not {width}x{height}: use larger frames"
        )
    # In the flattened array, each neighbour is a constant step away, even across images. Only border pixels
    # get wrong codes, and these are dropped.
    flat = np.ascontiguousarray(images).reshape(-1)
    margin = width + 1
    inner = slice(margin, max(margin, flat.size - margin))
    codes = np.zeros(flat.shape, np.uint8)
    target, centre = codes[inner], flat[inner]
    bit = np.empty(target.shape, bool)
    for down, right in _NEIGHBOURS:
        step = down * width + right
        np.greater_equal(centre, flat[inner.start + step : inner.stop + step], out=bit)
        np.add(target, target, out=target)
        np.bitwise_or(target, bit.view(np.uint8), out=target)
    return codes.reshape(images.shape)[..., 1:-1, 1:-1]


def histograms(codes: NDArray[np.uint8]) -> NDArray[np.float32]:
    """Return (n, 256) float32 histograms of (n, h, w) uint8 codes from `census`; rows sum to 1."""
    count = len(codes)
    if count == 0:
        return np.zeros((0, CODES), np.float32)
    offsets = np.arange(count)[:, None] * CODES
    counts = np.bincount((codes.reshape(count, -1) + offsets).ravel(), minlength=count * CODES)
    return (counts.reshape(count, CODES) / (codes[0].size or 1)).astype(np.float32)


def cell_histograms(codes: NDArray[np.uint8], cells: int) -> NDArray[np.float32]:
    """Compute a histogram of the codes in each cell of a ``cells`` x ``cells`` grid.

    Cells consist of whole pixels. Cell k of n covers the pixels from floor(k length / n) up to but not
    including floor((k + 1) length / n). The thesis does not specify this.

    `codes` are (h, w) uint8 codes from `census`, and `cells` is at most 16. Returns a (cells**2, 256) float32
    array with one row per cell, in row-major order of the grid. Each row sums to 1, or to 0 for a cell
    without pixels.
    """
    number = cells * cells
    places, sizes = _places(*codes.shape, cells)
    if codes.size <= _FEW * number:
        counts = cv2.calcHist([places, codes], [0, 1], None, [number, CODES], [0, number, 0, CODES])
    else:
        rows, columns = (pairwise(_edges(length, cells)) for length in codes.shape)
        blocks = [codes[slice(*row), slice(*column)] for row, column in product(rows, columns)]
        counts = np.hstack([cv2.calcHist([block], [0], None, [CODES], [0, CODES]) for block in blocks]).T
    return np.asarray(counts, np.float32) / sizes


def _edges(length: int, cells: int) -> NDArray[np.intp]:
    return np.arange(cells + 1) * length // cells


@lru_cache(maxsize=8)
def _places(height: int, width: int, cells: int) -> tuple[NDArray[np.uint8], NDArray[np.float32]]:
    """Return the (h, w) cell indices of the pixels, and the (cells**2, 1) pixel counts of the cells.

    Counts of 0 are replaced by 1.
    """
    rows, columns = (
        np.repeat(np.arange(cells), np.diff(_edges(length, cells))) for length in (height, width)
    )
    places = (rows[:, None] * cells + columns).astype(np.uint8)
    sizes = np.bincount(places.ravel(), minlength=cells * cells)[:, None]
    return places, np.maximum(sizes, 1).astype(np.float32)


def laplacian(image: NDArray[Any], kernel: str = "cross") -> NDArray[Any]:
    """Convolve an image with a 3x3 Laplacian, mirroring the border about the outermost pixels.

    Parameters
    ----------
    image
        (h, w) uint8 or float32.
    kernel
        ``cross`` (4 neighbours), ``full`` (8 neighbours) or ``diagonal`` (the 3x3 kernel of OpenCV's
        Laplacian with aperture 3). The thesis says only "Laplacian filter".

    Returns
    -------
    (h, w) array: int16 for a uint8 image, float32 for a float32 image.
    """
    depth = cv2.CV_16S if image.dtype == np.uint8 else cv2.CV_32F
    return cv2.filter2D(image, depth, LAPLACIANS[kernel], borderType=cv2.BORDER_REFLECT_101)
