"""Scaling of descriptors for the kernel, which determines the effect of a given gamma."""

from typing import Annotated, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray
from sklearn.base import BaseEstimator, TransformerMixin
from sklearn.utils.validation import check_is_fitted

from placecat.learning.checks import check_samples, check_width
from placecat.learning.products import squared_lengths
from placecat.ranges import OneOf, Positive
from placecat.schema.signatures import check_parameters

KINDS = ("none", "minmax", "standard", "root", "distance", "unit")


class KernelScaling(TransformerMixin, BaseEstimator):
    """Scale descriptors so that the same gamma suits descriptors of any scale and length.

    The thesis specifies gamma = 2, but not the scale of the descriptors. In the list of kinds below, m is the
    resulting mean of ||x - y||^2 over pairs of distinct training samples, and D is the number of dimensions
    that vary:

    - ``none``: leave x unchanged.
    - ``minmax``: scale each dimension to [0, 1] on the training data; m depends on the data.
    - ``standard``: scale each dimension to mean 0 and variance 1 / D; m is 2 n / (n - 1).
    - ``root``: divide each dimension by the square root of its standard deviation, then scale as for
      ``distance``. This is halfway between ``standard`` and ``distance``; m is 1.
    - ``distance``: subtract the mean of x, then divide by the square root of the mean ||x - y||^2. This
      preserves the relative weights of the dimensions; m is 1.
    - ``unit``: scale each sample to Euclidean length 1 (a zero sample stays zero); m is at most 4.

    Test samples outside the training range are not clipped.

    Parameters
    ----------
    kind
        One of the kinds above.
    gamma_scale
        Additional factor for squared distances, > 0. The values of m above are for a factor of 1.

    Attributes
    ----------
    offset_
        (D,) float64, subtracted from each sample.
    factor_
        (D,) float64, applied after the subtraction. It is 0 for a dimension that is constant in training,
        because its test values could otherwise dominate. The kinds ``none``, ``distance`` and ``unit`` keep
        constant dimensions.
    n_features_in_
        D.

    Examples
    --------
    >>> KernelScaling("minmax").fit_transform([[0.0, 7.0], [4.0, 7.0]]).tolist()
    [[0.0, 0.0], [1.0, 0.0]]
    """

    def __init__(self, kind: Annotated[str, OneOf(KINDS)] = "standard", gamma_scale: Positive = 1.0) -> None:
        self.kind = kind
        self.gamma_scale = gamma_scale

    def fit(self, X: ArrayLike, y: object = None) -> Self:
        """Learn the offset and factor from real, finite (n, D) training data X. `y` is ignored.

        Raises PlacecatError if a setting or X is invalid.
        """
        check_parameters(self)
        samples = check_samples(X)
        width = samples.shape[1]
        self.n_features_in_ = width
        self.offset_ = np.zeros(width)
        self.factor_ = np.ones(width)
        if self.kind == "minmax":
            low, high = samples.min(axis=0).astype(np.float64), samples.max(axis=0).astype(np.float64)
            self.offset_, self.factor_ = low, _inverse(high - low, np.maximum(abs(low), abs(high)))
        elif self.kind in ("standard", "root", "distance"):
            mean = samples.mean(axis=0, dtype=np.float64)
            deviation = samples.std(axis=0, dtype=np.float64)
            self.offset_ = mean
            if self.kind == "standard":
                inverse = _inverse(deviation, abs(mean))
                self.factor_ = inverse / np.sqrt(float(max(int(np.count_nonzero(inverse)), 1)))
            else:
                n = len(samples)
                if self.kind == "root":
                    self.factor_ = np.sqrt(_inverse(deviation, abs(mean)))
                spread = float(((deviation * self.factor_) ** 2).sum())
                mean_square = 2.0 * n / (n - 1) * spread if n > 1 else 0.0
                self.factor_ *= 1.0 / np.sqrt(mean_square) if mean_square > 0 else 1.0
        self.factor_ *= np.sqrt(self.gamma_scale)
        return self

    def transform(self, X: ArrayLike) -> NDArray[np.float32]:
        """Scale finite (n, D) samples to (n, D) float32. Raises PlacecatError for any other input."""
        check_is_fitted(self)
        samples = check_samples(X)
        check_width(samples, self)
        if self.kind == "unit":
            length = np.sqrt(squared_lengths(samples))
            inverse = np.divide(
                np.sqrt(self.gamma_scale), length, out=np.zeros_like(length), where=length > 0
            )
            return samples * inverse[:, None].astype(np.float32)
        if (self.factor_ == 1.0).all() and not self.offset_.any():
            return samples
        scaled = samples - self.offset_.astype(np.float32)
        scaled *= self.factor_.astype(np.float32)
        return scaled


def _inverse(spread: NDArray[np.float64], size: NDArray[np.float64]) -> NDArray[np.float64]:
    # Treat a spread as 0 if it is no larger than the rounding errors of float32.
    varies = spread > 1e-6 * size
    return np.divide(1.0, spread, out=np.zeros_like(spread), where=varies)
