"""Matrix products each of whose rows depends on its own row only, to the bit.

BLAS makes no such promise. It multiplies in tiles, sums in another order at the edges of a matrix than inside
it, and takes another routine for one row than for many, so that a frame alone would get other last bits than
the same frame among others. Here every product has one of a few fixed numbers of rows, the last one filled up
with zeros, and the columns have margins of zeros which take what edges there are. Whether that is enough
depends on the processor's kernels: it is tried, once for each shape, and if it fails rows go one by one.
"""

from collections.abc import Iterator
from functools import cache
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from placecat.learning.single_thread import single_blas_thread

# Columns of one product without margins. With them 320, what OpenBLAS's AVX2 kernels of float32 take as one.
_COLUMNS = 304
# Zero columns on both sides, the tile of these kernels (8) and its double.
_MARGIN, _TILE = 8, 16
# Numbers of rows of one product, the preferred first: multiples of 12, a tile of these kernels, where large
# ones are fast and small ones waste little on few rows.
_ROWS = (48, 240, 12)
# Columns of random numbers that a shape is tried on, at least.
_TRIED = 256


class RowProducts:
    """left @ right.T for one `right`, every row of the result as if it were alone.

    Parameters
    ----------
    right
        (m, k) float32 or float64; copied. m may be 0.

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
        """Multiply (n, k) rows, converted to the dtype of `right`; gives (n, m). n may be 0."""
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
    """Multiply (n, k) rows by (m, k) rows: (n, m), in the dtype of `right`. See :class:`RowProducts`."""
    return RowProducts(right)(left)


def sum_products(left: NDArray[np.float64], right: NDArray[np.float64]) -> NDArray[np.float64]:
    """Multiply as :func:`row_products` does, for few k: one term after the other, without BLAS.

    Parameters
    ----------
    left, right
        (n, k) and (m, k) float64, k at least 1.

    Returns
    -------
    (n, m) float64.
    """
    result = left[:, :1] * right[:, 0]
    for term in range(1, right.shape[1]):
        result += left[:, term, None] * right[:, term]
    return result


def squared_lengths(X: NDArray[np.floating]) -> NDArray[np.float64]:
    """Sum of squares of each row of (n, k), summed in float64: (n,), every row as if it were alone."""
    result = np.empty(len(X))
    for start in range(0, len(X), _ROWS[0]):
        # Converted first: einsum would convert by buffers that end anywhere in a row.
        part = np.ascontiguousarray(X[start : start + _ROWS[0]], np.float64)
        np.einsum("ij,ij->i", part, part, out=result[start : start + _ROWS[0]])
    return result


def _multiply(block: NDArray[Any], tile: NDArray[Any]) -> NDArray[Any]:
    return block @ tile.T


def _padded(columns: int) -> int:
    return -(-(columns + 2 * _MARGIN) // _TILE) * _TILE


@cache
def _numbers_of_rows(k: int, columns: int, dtype: str) -> tuple[int, ...]:
    """Numbers of rows, falling, whose products agree wherever a row stands; none if none does.

    Tried on random numbers: for one row, repeated, all rows of all products have to be equal to the bit.
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
    """First row and number of rows of the products that cover n rows, the last one perhaps beyond."""
    start = 0
    while start < n:
        rest = n - start
        # The largest that is at least half full.
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
    # At one address, since a kernel may look at it.
    row = np.empty(rows.shape[1], rows.dtype)
    for number in range(len(rows)):
        row[:] = rows[number]
        columns[number] = (tile @ row)[_MARGIN : _MARGIN + columns.shape[1]]
