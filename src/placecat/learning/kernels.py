"""Compute the RBF kernel in cache-sized blocks, and kernel expansions that several classifiers share."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, Self

import numpy as np
from joblib import Parallel, delayed
from numpy.typing import ArrayLike, DTypeLike, NDArray
from scipy.sparse import issparse
from sklearn.utils.multiclass import check_classification_targets
from sklearn.utils.validation import column_or_1d

from placecat.errors import PlacecatError
from placecat.learning.products import RowProducts, row_products, squared_lengths
from placecat.learning.single_thread import single_blas_thread

# Rows and columns per tile: 2 MiB of float32.
ROW_TILE = 512
COLUMN_TILE = 1024
# The same for predictions, where a row's bits must not depend on other rows.
PREDICTION_ROWS = 480
PREDICTION_COLUMNS = 912


def check_samples(X: ArrayLike, name: str = "X") -> NDArray[np.float32]:
    """Return `X` as a finite, C-contiguous (n, D) float32 matrix, without copying if it already is one.

    Raises PlacecatError if `X` is sparse, complex, not two-dimensional or empty, or holds NaN or infinite
    values; the message calls it `name`.
    """
    if issparse(X):
        raise PlacecatError(f"{name} is sparse, but must be dense: use {name}.toarray()")
    samples = np.asarray(X)
    if samples.dtype.kind == "c":
        raise PlacecatError(f"Complex data not supported: {name} must be real")
    if samples.ndim != 2 or 0 in samples.shape:
        shape = f"{name} has shape {samples.shape}; give a non-empty matrix (samples, features)"
        raise PlacecatError(shape + _short_of(samples))
    samples = np.ascontiguousarray(samples, dtype=np.float32)
    # A finite sum proves that all values are finite; an infinite sum may only be an overflow.
    with np.errstate(over="ignore", invalid="ignore"):
        finite = bool(np.isfinite(samples.sum()))
    if not finite and not np.isfinite(samples).all():
        row = int(np.flatnonzero(~np.isfinite(samples).all(axis=1))[0])
        raise PlacecatError(
            f"{name} holds NaN or infinite values, first in row {row}; drop or fix these samples"
        )
    return samples


def _short_of(samples: NDArray[Any]) -> str:
    """Describe a matrix's wrong shape in the words that scikit-learn's checks expect."""
    if samples.ndim != 2:
        return ". Reshape your data"
    what = "sample" if len(samples) == 0 else "feature"
    return f": 0 {what}(s) (shape={samples.shape}) while a minimum of 1 is required."


def check_width(X: NDArray[Any], estimator: Any) -> None:
    """Raise PlacecatError if the samples' number of features differs from the training data."""
    expected = estimator.n_features_in_
    if X.shape[1] != expected:
        raise PlacecatError(
            f"X has {X.shape[1]} features, but {type(estimator).__name__} is expecting {expected} features "
            "as input: it was fitted on them"
        )


def check_labels(y: ArrayLike | None, n: int) -> NDArray[Any]:
    """Return `y` as class labels (n,).

    Raises PlacecatError if labels are missing, if there are not `n` of them, or if they cannot be classes,
    such as 0.5 and NaN.
    """
    if y is None:
        raise PlacecatError("a classifier requires y to be passed, but the target y is None")
    labels = np.asarray(y)
    if labels.ndim == 2 and labels.shape[1] == 1:
        labels = column_or_1d(labels, warn=True)
    if labels.shape != (n,):
        raise PlacecatError(f"y has shape {labels.shape} for {n} samples; give one label per sample")
    # Integers and booleans are always classes.
    if labels.dtype.kind not in "iub":
        try:
            check_classification_targets(labels)
        except ValueError as error:
            raise PlacecatError(f"y: {error}") from None
    return labels


def encode_two_classes(y: ArrayLike | None, n: int) -> tuple[NDArray[Any], NDArray[np.bool_]]:
    """Return the two classes of labels (n,), sorted, and (n,) bool, true for the second class.

    Raises PlacecatError like `check_labels`, and if there are not two classes.
    """
    classes, index = np.unique(check_labels(y, n), return_inverse=True)
    if len(classes) != 2:
        held = f"{len(classes)} class{'es' if len(classes) > 1 else ''}"
        raise PlacecatError(
            f"Only binary classification is supported: 2 classes are needed, the labels hold {held}"
        )
    return classes, index == 1


# One product of rows [2 gamma x, -gamma x.x, 1] and columns [y, 1, -gamma y.y] gives -gamma ||x - y||^2.
# The origin is the mean of y, which leaves distances unchanged and reduces cancellation.
def _columns(Y: NDArray[np.float32], gamma: float) -> tuple[NDArray[np.float32], NDArray[np.float32]]:
    """Return the origin (D,) and the columns (m, D + 2)."""
    origin = Y.mean(axis=0, dtype=np.float64).astype(np.float32)
    columns = np.empty((len(Y), Y.shape[1] + 2), dtype=np.float32)
    np.subtract(Y, origin, out=columns[:, :-2])
    columns[:, -2] = 1.0
    columns[:, -1] = -gamma * np.einsum("ij,ij->i", columns[:, :-2], columns[:, :-2], dtype=np.float64)
    return origin, columns


def _rows(X: NDArray[np.float32], origin: NDArray[np.float32], gamma: float) -> NDArray[np.float32]:
    """Return the rows (n, D + 2); a row's bits do not depend on other rows."""
    rows = np.empty((len(X), X.shape[1] + 2), dtype=np.float32)
    np.subtract(X, origin, out=rows[:, :-2])
    rows[:, -2] = -gamma * squared_lengths(rows[:, :-2])
    rows[:, -1] = 1.0
    rows[:, :-2] *= np.float32(2.0 * gamma)
    return rows


def _to_kernel(products: NDArray[np.float32]) -> NDArray[np.float32]:
    """Replace the products by exp(-gamma ||x - y||^2), in place."""
    # Rounding may make a squared distance negative.
    np.minimum(products, 0.0, out=products)
    return np.exp(products, out=products)


def _check_gamma(gamma: float) -> float:
    if not (np.isfinite(gamma) and gamma > 0):
        raise PlacecatError(f"gamma = {gamma} is not a kernel width; give a number above 0")
    return float(gamma)


def rbf_gram(
    X: ArrayLike, gamma: float, dtype: DTypeLike = np.float32, n_jobs: int | None = None
) -> NDArray[Any]:
    """Compute a training set's Gram matrix exp(-gamma ||x_i - x_j||^2), for all classes and folds.

    It is computed block by block, and is exactly symmetric with ones on the diagonal.

    Parameters
    ----------
    X
        (n, D) finite, converted to float32.
    gamma
        Inverse squared width, > 0, in units of 1 / X^2 (thesis 4.2: 2.0, without the scale of X).
    dtype
        dtype of the result: float32, or float64 for libsvm. Values are always computed in float32.
    n_jobs
        Number of threads. The result does not depend on it.

    Returns
    -------
    (n, n) matrix of values in [0, 1]. Raises PlacecatError if gamma or X is invalid.

    Examples
    --------
    >>> rbf_gram([[0.0], [1.0]], gamma=np.log(2.0)).round(6).tolist()
    [[1.0, 0.5], [0.5, 1.0]]
    """
    samples = check_samples(X)
    origin, right = _columns(samples, _check_gamma(gamma))
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


def rbf_cross(X: ArrayLike, Y: ArrayLike, gamma: float) -> NDArray[np.float32]:
    """Compute exp(-gamma ||x_i - y_j||^2) between X (n, D) and Y (m, D): (n, m) float32 in [0, 1].

    Raises PlacecatError if the widths differ, gamma is not above 0, or an input is not a finite matrix.
    `KernelExpansion` avoids building this whole matrix.
    """
    rows, columns = check_samples(X), check_samples(Y, "Y")
    if rows.shape[1] != columns.shape[1]:
        raise PlacecatError(f"X has {rows.shape[1]} features, Y has {columns.shape[1]}; give equal widths")
    origin, right = _columns(columns, _check_gamma(gamma))
    left = _rows(rows, origin, gamma)
    return _to_kernel(row_products(left, right))


@dataclass(frozen=True)
class KernelExpansion:
    """K functions sum_s coef[s, k] exp(-gamma ||x - v_s||^2) + intercept[k] over shared vectors.

    Attributes
    ----------
    support_vectors
        (S, D) float32, the union of the K functions' vectors. S may be 0.
    coef
        (S, K) float64.
    intercept
        (K,) float64.
    gamma
        See `rbf_gram`.
    """

    support_vectors: NDArray[np.float32]
    coef: NDArray[np.float64]
    intercept: NDArray[np.float64]
    gamma: float

    #: Attributes that prediction does not need; stored systems omit them.
    TRAINING_ONLY = ("_prepared",)

    @classmethod
    def union(cls, machines: Sequence[Any], X: NDArray[np.float32]) -> Self:
        """Combine `KernelMachine`s fitted on rows of the same `X` (n, D) into one expansion."""
        support = np.unique(np.concatenate([machine.support_ for machine in machines])).astype(np.intp)
        coef = np.zeros((len(support), len(machines)))
        for k, machine in enumerate(machines):
            coef[np.searchsorted(support, machine.support_), k] = machine.dual_coef_
        intercept = np.array([machine.intercept_ for machine in machines], dtype=np.float64)
        return cls(X[support], coef, intercept, float(machines[0].gamma))

    @cached_property
    def _prepared(self) -> tuple[NDArray[np.float32], list[tuple[RowProducts, RowProducts]]]:
        """Return the origin and, for each block of vectors, the products that give kernels and sums."""
        origin, right = _columns(self.support_vectors, self.gamma)
        coef = self.coef.astype(np.float32)
        parts = [
            slice(first, first + PREDICTION_COLUMNS) for first in range(0, len(coef), PREDICTION_COLUMNS)
        ]
        return origin, [(RowProducts(right[part]), RowProducts(coef[part].T)) for part in parts]

    def decisions(self, X: ArrayLike) -> NDArray[np.float64]:
        """Evaluate all K functions for finite X (n, D): (n, K) float64. Raises PlacecatError for other X.

        One matrix product computes the kernel and another the sums. A row's bits do not depend on other rows.
        """
        samples = check_samples(X)
        width = self.support_vectors.shape[1]
        if samples.shape[1] != width:
            raise PlacecatError(f"X has {samples.shape[1]} features; the classifier was fitted on {width}")
        result = np.tile(self.intercept, (len(samples), 1))
        if len(self.support_vectors) == 0:
            return result
        origin, parts = self._prepared
        for start in range(0, len(samples), PREDICTION_ROWS):
            left = _rows(samples[start : start + PREDICTION_ROWS], origin, self.gamma)
            for kernels, sums in parts:
                result[start : start + PREDICTION_ROWS] += sums(_to_kernel(kernels(left)))
        return result
