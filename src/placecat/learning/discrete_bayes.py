"""Base class of the two joint-probability models, which apply Bayes' rule to codes."""

from abc import abstractmethod
from typing import Any, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.special import logsumexp
from sklearn.base import BaseEstimator, ClassifierMixin
from sklearn.utils.validation import check_array, check_is_fitted

from placecat.errors import PlacecatError
from placecat.learning.checks import check_labels, check_width
from placecat.schema.signatures import check_parameters

PRIORS = ("uniform", "frequency")


class DiscreteBayes(ClassifierMixin, BaseEstimator):
    """Bayes' rule (thesis equation 10) applied to a model of p(c_1 = q_1, ..., c_V = q_V | l_i).

    Subclasses implement `_fit_model` and `_log_likelihood`.

    Parameters
    ----------
    alpha
        Number added to every count (Laplace smoothing). It must be positive; otherwise, a value that never
        occurs in a class would rule that class out. The thesis does not specify this.
    n_values
        Number of values per variable: the number of clusters, or 2 for activations. By default, it is the
        largest training code plus 1, but at least 2.
    prior
        p(l_i) in equation (10), ``uniform`` or ``frequency``. The thesis does not specify this. ``uniform``
        matches the thesis's KNN (3.3.1.1) and its accuracy measure, which is a mean over classes.

    Attributes
    ----------
    classes_
        (n_classes,) labels, sorted.
    class_count_
        (n_classes,) int64, the number of training samples of each class.
    class_log_prior_
        (n_classes,) float64, log p(l_i).
    n_values_
        Number of values per variable.
    n_features_in_
        V, the number of variables.
    """

    alpha: float
    n_values: int | None
    prior: str

    classes_: NDArray[Any]
    class_count_: NDArray[np.int64]
    class_log_prior_: NDArray[np.float64]
    n_values_: int
    n_features_in_: int

    def __sklearn_tags__(self) -> Any:
        """Tell scikit-learn that the samples are codes."""
        tags = super().__sklearn_tags__()
        tags.input_tags.categorical = True
        tags.input_tags.positive_only = True
        return tags

    def fit(self, X: ArrayLike, y: ArrayLike) -> Self:
        """Estimate the model from codes and their classes.

        `X` is an (n, V) array of integers in [0, n_values): the codewords of V cells or the activations of V
        clusters. `y` is an (n,) array of classes, which are strings or integers. Raises PlacecatError if a
        setting is invalid or a code is out of range.
        """
        check_parameters(self)
        codes = self._read_codes(X)
        targets = check_labels(y, len(codes))
        self.n_features_in_ = codes.shape[1]
        self.n_values_ = max(2, int(codes.max()) + 1) if self.n_values is None else self.n_values
        codes = self._narrow(codes)
        self.classes_, labels = np.unique(targets, return_inverse=True)
        self.class_count_ = np.bincount(labels)
        frequency = self.class_count_ if self.prior == "frequency" else np.ones(len(self.classes_))
        self.class_log_prior_ = np.log(frequency / frequency.sum())
        self._fit_model(codes, labels)
        return self

    def predict_joint_log_likelihood(self, X: ArrayLike) -> NDArray[np.float64]:
        """Return (n, n_classes) logarithms of p(codes, class), the numerator of equation (10).

        X is an (n, V) array of integers. Raises PlacecatError if a code is outside [0, n_values_), or if V
        differs from that of the training data.
        """
        check_is_fitted(self)
        codes = self._read_codes(X)
        check_width(codes, self)
        codes = self._narrow(codes)
        return self._log_likelihood(codes) + self.class_log_prior_

    def predict_log_proba(self, X: ArrayLike) -> NDArray[np.float64]:
        """Return (n, n_classes) logarithms of p(class | codes)."""
        joint = self.predict_joint_log_likelihood(X)
        return joint - logsumexp(joint, axis=1, keepdims=True)

    def predict_proba(self, X: ArrayLike) -> NDArray[np.float64]:
        """Return (n, n_classes) probabilities p(class | codes), whose rows sum to 1."""
        return np.exp(self.predict_log_proba(X))

    def predict(self, X: ArrayLike) -> NDArray[Any]:
        """Return the most probable class of each sample, (n,)."""
        best = self.predict_joint_log_likelihood(X).argmax(axis=1)
        return self.classes_[best]

    @abstractmethod
    def _fit_model(self, codes: NDArray[np.integer], labels: NDArray[np.intp]) -> None: ...

    @abstractmethod
    def _log_likelihood(self, codes: NDArray[np.integer]) -> NDArray[np.float64]: ...

    def _read_codes(self, X: ArrayLike) -> NDArray[np.integer]:
        codes = check_array(X, dtype=None, order="C", estimator=self)
        if codes.dtype.kind in "iu":
            return codes
        if codes.dtype.kind == "b":
            return codes.astype(np.uint8)
        if codes.dtype.kind != "f" or not np.array_equal(codes, np.floor(codes)):
            raise PlacecatError("X must contain codes, which are non-negative integers")
        return codes.astype(np.int64)

    def _narrow(self, codes: NDArray[np.integer]) -> NDArray[np.integer]:
        """Check the range of the codes, and convert them to a small dtype."""
        if codes.min() >= 0 and codes.max() < self.n_values_:
            return codes.astype(np.uint8 if self.n_values_ <= 256 else np.int32, copy=False)
        sample, variable = np.argwhere((codes < 0) | (codes >= self.n_values_))[0]
        raise PlacecatError(
            f"code {codes[sample, variable]} of sample {sample}, variable {variable} is outside "
            f"[0, {self.n_values_}): set n_values to the codebook's number of clusters (2 for activations)"
        )
