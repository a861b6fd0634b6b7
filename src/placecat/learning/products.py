"""Matrix products in which each row of the result depends only on the corresponding input row.

This must hold down to the last bit, which BLAS does not guarantee. BLAS multiplies in tiles, sums in a
different order at the edges of a matrix, and uses different routines for one row than for many. The last bits
of a frame's result would therefore depend on the other frames. Here, every product has one of a few fixed row
counts, and the last product is padded with zeros. The columns have margins of zeros on both sides. Whether
this works depends on the BLAS kernels that the processor uses, so each shape is tested once. If the test
fails, rows are multiplied one by one.
"""

from collections.abc import Iterator
from functools import cache
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from placecat.learning.single_thread import single_blas_thread

# Number of columns per product, without margins. With margins, there are 320, which is one block of
# OpenBLAS's AVX2 float32 kernels.
_COLUMNS = 304
# Number of zero columns on each side, equal to the tile size of these kernels. The total number of columns is
# padded to a multiple of `_TILE`.
_MARGIN, _TILE = 8, 16
# Numbers of rows per product, in order of preference. They are multiples of 12, the tile height of these
# kernels.
_ROWS = (48, 240, 12)
# Minimum number of random columns used to test a shape.
_TRIED = 256


class RowProducts:
    """Compute left @ right.T for a fixed `right` so that no row affects the last bits of another.

    `right` is an (m, k) float32 or float64 matrix, where m may be 0. It is copied.

    Examples
    --------
    >>> RowProducts(np.array([[1.0, 2.0], [0.0, 1.0]]))([[3.0, 4.0]]).tolist()
    [[11.0, 4.0]]
    """

    def __init__(self, right: ArrayLike) -> None:
        matrix = np.asarray(right)
        self.shape: tuple[int, int] = matrix.shape
        self.dtype = matrix.dtype
        self._tiles: list[NDArray[Any]] = []
        for first in range(0, len(matrix), _COLUMNS):
            part = matrix[first : first + _COLUMNS]
            padded = np.zeros((_padded(len(part)), matrix.shape[1]), matrix.dtype)
            padded[_MARGIN : _MARGIN + len(part)] = part
            self._tiles.append(padded)

    def __call__(self, left: ArrayLike) -> NDArray[Any]:
        """Convert (n, k) rows to `right`'s dtype, multiply them, and return (n, m) products. n may be 0."""
        rows = np.ascontiguousarray(left, dtype=self.dtype)
        m, k = self.shape
        result = np.empty((len(rows), m), self.dtype)
        with single_blas_thread():
            for number, tile in enumerate(self._tiles):
                columns = result[:, number * _COLUMNS : (number + 1) * _COLUMNS]
                sizes = _numbers_of_rows(k, len(tile), self.dtype.char)
                if sizes:
                    _by_blocks(rows, tile, columns, sizes)
                else:
                    _one_by_one(rows, tile, columns)
        return result


def row_products(left: ArrayLike, right: ArrayLike) -> NDArray[Any]:
    """Return the (n, m) products of (n, k) and (m, k) rows, in `right`'s dtype. See :class:`RowProducts`."""
    return RowProducts(right)(left)


def sum_products(left: NDArray[np.float64], right: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the (n, m) products of (n, k) and (m, k) float64 rows, as :func:`row_products` does.

    This is meant for small k, at least 1. It adds the terms one by one, without BLAS.
    """
    result = left[:, :1] * right[:, 0]
    for term in range(1, right.shape[1]):
        result += left[:, term, None] * right[:, term]
    return result


def squared_lengths(X: NDArray[np.floating]) -> NDArray[np.float64]:
    """Return the (n,) sums of squares of (n, k) rows. Each sum depends only on its own row."""
    result = np.empty(len(X))
    for start in range(0, len(X), _ROWS[0]):
        # Convert first, because einsum's conversion buffers may end in the middle of a row.
        part = np.ascontiguousarray(X[start : start + _ROWS[0]], np.float64)
        np.einsum("ij,ij->i", part, part, out=result[start : start + _ROWS[0]])
    return result


def _multiply(block: NDArray[Any], tile: NDArray[Any]) -> NDArray[Any]:
    return block @ tile.T


def _padded(columns: int) -> int:
    return -(-(columns + 2 * _MARGIN) // _TILE) * _TILE


@cache
def _numbers_of_rows(k: int, columns: int, dtype: str) -> tuple[int, ...]:
    """Return the row counts whose products agree in every row, in descending order; empty if none do.

    The test repeats one row of random numbers. All rows of the product must then be identical.
    """
    rng = np.random.default_rng(0)
    agreeing = list(_ROWS)
    for _ in range(-(-_TRIED // columns)):
        row, right = (rng.uniform(-1.0, 1.0, shape).astype(dtype) for shape in (k, (columns, k)))
        expected = None
        for size in list(agreeing):
            found = _multiply(np.tile(row, (size, 1)), right)[:, _MARGIN:-_MARGIN]
            if (found != found[0]).any() or (expected is not None and (found[0] != expected).any()):
                agreeing.remove(size)
            elif expected is None:
                expected = found[0]
    return tuple(sorted(agreeing, reverse=True))


def _blocks(n: int, sizes: tuple[int, ...]) -> Iterator[tuple[int, int]]:
    """Yield the first row and the row count of each product for n rows. The last may extend beyond n."""
    start = 0
    while start < n:
        rest = n - start
        # Choose the largest block that would be more than half full.
        size = next((size for size in sizes if 2 * rest > size), sizes[-1])
        yield start, size
        start += size


def _by_blocks(rows: NDArray[Any], tile: NDArray[Any], columns: NDArray[Any], sizes: tuple[int, ...]) -> None:
    for start, size in _blocks(len(rows), sizes):
        block = rows[start : start + size]
        if len(block) < size:
            block = np.zeros((size, rows.shape[1]), rows.dtype)
            block[: len(rows) - start] = rows[start:]
        product = _multiply(block, tile)
        part = columns[start : start + size]
        part[:] = product[: len(part), _MARGIN : _MARGIN + columns.shape[1]]


def _one_by_one(rows: NDArray[Any], tile: NDArray[Any], columns: NDArray[Any]) -> None:
    # Always use the same address, because the kernel may depend on it.
    row = np.empty(rows.shape[1], rows.dtype)
    for number in range(len(rows)):
        row[:] = rows[number]
        columns[number] = (tile @ row)[_MARGIN : _MARGIN + columns.shape[1]]
