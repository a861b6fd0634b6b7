"""Check an estimator's samples and labels, and raise PlacecatError if they are invalid."""

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray
from sklearn.utils.multiclass import check_classification_targets
from sklearn.utils.validation import check_array, column_or_1d

from placecat.errors import PlacecatError


def check_samples(X: ArrayLike, least: int = 1) -> NDArray[np.float32]:
    """Return `X` as a finite, C-contiguous (n, D) float32 matrix, copied only if necessary.

    Raises PlacecatError if `X` is sparse or not two-dimensional, if it has complex, infinite or NaN values,
    or if it has fewer than `least` samples.
    """
    if isinstance(X, np.ndarray) and X.dtype == np.float32 and X.ndim == 2 and X.size:
        # scikit-learn's own check would take longer than many predictions do.
        samples = np.ascontiguousarray(X)
    else:
        try:
            samples = check_array(
                X, dtype=np.float32, order="C", ensure_all_finite=False, ensure_min_samples=least
            )
        except ValueError as error:
            raise PlacecatError(f"X: {error}") from None
    wrong = np.flatnonzero(~np.isfinite(samples).all(axis=1))
    if len(wrong):
        raise PlacecatError(
            f"X has NaN or infinite values, the first in row {wrong[0]}: drop or correct these samples"
        )
    return samples


def check_width(X: NDArray[Any], estimator: Any) -> None:
    """Raise PlacecatError if samples do not have as many features as the training data."""
    expected = estimator.n_features_in_
    if X.shape[1] != expected:
        raise PlacecatError(
            f"X has {X.shape[1]} features, but {type(estimator).__name__} is expecting {expected} features "
            "as input, like its training data"
        )


def check_labels(y: ArrayLike | None, n: int) -> NDArray[Any]:
    """Return `y` as (n,) class labels.

    Raises PlacecatError if labels are missing or cannot be class labels, such as 0.5.
    """
    if y is None:
        raise PlacecatError("a classifier requires y to be passed, but the target y is None")
    try:
        labels = column_or_1d(y, warn=True)
        check_classification_targets(labels)
    except ValueError as error:
        raise PlacecatError(f"y: {error}") from None
    if len(labels) != n:
        raise PlacecatError(f"y has shape {labels.shape} for {n} samples; pass one label per sample")
    return labels


def encode_two_classes(y: ArrayLike | None, n: int) -> tuple[NDArray[Any], NDArray[np.bool_]]:
    """Return the two sorted classes of (n,) labels, and (n,) bools that are true for the second class."""
    classes, index = np.unique(check_labels(y, n), return_inverse=True)
    if len(classes) != 2:
        held = f"{len(classes)} class{'es' if len(classes) > 1 else ''}"
        raise PlacecatError(
            f"Only binary classification is supported: the labels must have 2 classes, not {held}"
        )
    return classes, index == 1
