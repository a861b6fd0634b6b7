"""Compute the RBF kernel in cache-sized blocks, and evaluate kernel sums for several classifiers at once."""

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from joblib import Parallel, delayed
from numpy.typing import ArrayLike, DTypeLike, NDArray

from placecat.learning.checks import check_samples
from placecat.learning.products import RowProducts, squared_lengths
from placecat.learning.single_thread import single_blas_thread

# Number of rows and columns per tile. A tile takes 2 MiB in float32.
ROW_TILE = 512
COLUMN_TILE = 1024
# The same for predictions, in which even the last bits of a row must not depend on other rows.
PREDICTION_ROWS = 480
PREDICTION_COLUMNS = 912


# The product of rows [2 gamma x, -gamma x.x, 1] and columns [y, 1, -gamma y.y] is -gamma ||x - y||^2.
# The origin is the mean of y, which leaves distances unchanged and reduces cancellation.
def _columns(Y: NDArray[np.float32], gamma: float) -> tuple[NDArray[np.float32], NDArray[np.float32]]:
    """Return the (D,) origin and the (m, D + 2) columns."""
    origin = Y.mean(axis=0, dtype=np.float64).astype(np.float32)
    columns = np.empty((len(Y), Y.shape[1] + 2), dtype=np.float32)
    np.subtract(Y, origin, out=columns[:, :-2])
    columns[:, -2] = 1.0
    columns[:, -1] = -gamma * np.einsum("ij,ij->i", columns[:, :-2], columns[:, :-2], dtype=np.float64)
    return origin, columns


def _rows(X: NDArray[np.float32], origin: NDArray[np.float32], gamma: float) -> NDArray[np.float32]:
    """Return the (n, D + 2) rows. Each row is independent of the others, down to the last bit."""
    rows = np.empty((len(X), X.shape[1] + 2), dtype=np.float32)
    np.subtract(X, origin, out=rows[:, :-2])
    rows[:, -2] = -gamma * squared_lengths(rows[:, :-2])
    rows[:, -1] = 1.0
    rows[:, :-2] *= np.float32(2.0 * gamma)
    return rows


def _to_kernel(products: NDArray[np.float32]) -> NDArray[np.float32]:
    """Replace the products in place with exp(-gamma ||x - y||^2)."""
    # Rounding can make a squared distance negative.
    np.minimum(products, 0.0, out=products)
    return np.exp(products, out=products)


def rbf_gram(
    X: ArrayLike, gamma: float, dtype: DTypeLike = np.float32, n_jobs: int | None = None
) -> NDArray[Any]:
    """Compute the Gram matrix exp(-gamma ||x_i - x_j||^2) of a training set, once for all classes and folds.

    The matrix is computed block by block. It is exactly symmetric, with ones on the diagonal.

    Parameters
    ----------
    X
        (n, D) finite samples, converted to float32. Raises PlacecatError for any other input.
    gamma
        Inverse squared width, > 0, in units of 1 / X^2. Thesis 4.2 uses 2.0, but does not specify the scale
        of X.
    dtype
        dtype of the result: float32, or float64 for libsvm. Values are always computed in float32.
    n_jobs
        Number of threads. The result does not depend on it.

    Returns
    -------
    (n, n) matrix of values in [0, 1].

    Examples
    --------
    >>> rbf_gram([[0.0], [1.0]], gamma=np.log(2.0)).round(6).tolist()
    [[1.0, 0.5], [0.5, 1.0]]
    """
    samples = check_samples(X)
    origin, right = _columns(samples, gamma)
    left = _rows(samples, origin, gamma)
    n = len(samples)
    gram = np.empty((n, n), dtype=dtype)

    def fill(start: int) -> None:
        stop = min(start + ROW_TILE, n)
        for first in range(start, n, COLUMN_TILE):
            last = min(first + COLUMN_TILE, n)
            block = _to_kernel(left[start:stop] @ right[first:last].T)
            if first == start:
                size = stop - start
                corner = np.tril(block[:, :size], -1)
                block[:, :size] = corner + corner.T
                np.fill_diagonal(block[:, :size], 1.0)
            gram[start:stop, first:last] = block
            gram[first:last, start:stop] = block.T

    with single_blas_thread():
        Parallel(n_jobs=n_jobs, backend="threading")(delayed(fill)(start) for start in range(0, n, ROW_TILE))
    return gram


@dataclass(frozen=True)
class KernelExpansion:
    """K functions sum_s coef[s, k] exp(-gamma ||x - v_s||^2) + intercept[k] with shared vectors v_s."""

    #: (S, D), every vector used by any of the K functions. S may be 0.
    support_vectors: NDArray[np.float32]
    #: (S, K)
    coef: NDArray[np.float64]
    #: (K,)
    intercept: NDArray[np.float64]
    #: See `rbf_gram`.
    gamma: float

    #: Attributes that stored systems omit, because prediction does not need them.
    TRAINING_ONLY = ("_prepared",)

    @cached_property
    def _prepared(self) -> tuple[NDArray[np.float32], list[tuple[RowProducts, RowProducts]]]:
        """Return the origin and, for each block of vectors, the products that compute kernels and sums."""
        origin, right = _columns(self.support_vectors, self.gamma)
        coef = self.coef.astype(np.float32)
        parts = [
            slice(first, first + PREDICTION_COLUMNS) for first in range(0, len(coef), PREDICTION_COLUMNS)
        ]
        return origin, [(RowProducts(right[part]), RowProducts(coef[part].T)) for part in parts]

    def decisions(self, X: NDArray[np.float32]) -> NDArray[np.float64]:
        """Evaluate all K functions for (n, D) samples, and return (n, K) float64 values.

        One matrix product computes the kernel, and another computes the sums. Each row of the result is
        independent of the other rows, down to the last bit.
        """
        result = np.tile(self.intercept, (len(X), 1))
        if len(self.support_vectors) == 0:
            return result
        origin, parts = self._prepared
        for start in range(0, len(X), PREDICTION_ROWS):
            left = _rows(X[start : start + PREDICTION_ROWS], origin, self.gamma)
            for kernels, sums in parts:
                result[start : start + PREDICTION_ROWS] += sums(_to_kernel(kernels(left)))
        return result
