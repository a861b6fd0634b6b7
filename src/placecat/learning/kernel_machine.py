"""Common base class of the two-class classifiers that use a Gram matrix."""

from abc import abstractmethod
from collections.abc import Sequence
from typing import Any, Self

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray
from sklearn.utils.validation import check_is_fitted

from placecat.errors import PlacecatError
from placecat.learning.kernels import (
    KernelExpansion,
    check_samples,
    check_width,
    encode_two_classes,
    rbf_gram,
)
from placecat.learning.memory import remembered


class KernelMachine:
    """Two-class classifier whose decision value is a sum over support vectors.

    A subclass has the parameter `gamma` and a `fit_rows` that sets `support_`, `dual_coef_` and `intercept_`.

    Attributes
    ----------
    classes_, support_vectors_
        The two labels, and (s, D) float32. Set only by `fit`.
    support_
        (s,) ascending indices into the Gram matrix's samples.
    dual_coef_
        (s,) float64.
    intercept_
        float.
    """

    gamma: float
    support_: NDArray[np.intp]
    dual_coef_: NDArray[np.float64]
    intercept_: float
    classes_: NDArray[Any]
    support_vectors_: NDArray[np.float32]
    #: The Gram matrix dtype that the machine can use without copying.
    gram_dtype: DTypeLike = np.float32

    def __sklearn_tags__(self) -> Any:
        """Tell scikit-learn that there are two classes."""
        tags = super().__sklearn_tags__()  # type: ignore[misc]
        tags.classifier_tags.multi_class = False
        return tags

    def fit(self, X: ArrayLike, y: ArrayLike) -> Self:
        """Fit on real samples (n, D) and labels (n,) of exactly two classes.

        Raises PlacecatError if there are not two classes, or a setting is invalid.
        """
        samples = check_samples(X)
        self.classes_, positive = encode_two_classes(y, len(samples))
        self.fit_rows(self.prepare(samples), positive, context=f"class {self.classes_[1]!s}")
        self.support_vectors_ = samples[self.support_]
        self.n_features_in_ = samples.shape[1]
        return self

    @abstractmethod
    def fit_rows(
        self,
        shared: NDArray[Any],
        positive: NDArray[np.bool_],
        rows: NDArray[np.intp] | None = None,
        context: str = "this class",
    ) -> Self:
        """Fit on some rows of a Gram matrix.

        Raises PlacecatError if the rows have only one class, or a setting is invalid.

        Parameters
        ----------
        shared
            (n, n) matrix of `gram_dtype`, from `prepare`.
        positive
            (n,) bool.
        rows
            Ascending indices of the training samples, all by default.
        context
            The problem's name in messages.
        """

    def prepare(
        self, X: NDArray[np.float32], gram: NDArray[Any] | None = None, n_jobs: int | None = None
    ) -> NDArray[Any]:
        """Compute the Gram matrix that all classes and folds share.

        Parameters
        ----------
        X
            (n, D) float32.
        gram
            Precomputed (n, n) matrix for the same samples and gamma. Raises PlacecatError for another shape.
        n_jobs
            Number of threads.

        Returns
        -------
        (n, n) C-contiguous matrix of `gram_dtype`; `gram` itself if it is one.
        """
        if gram is None:
            return remembered(
                "gram",
                (X, float(self.gamma), np.dtype(self.gram_dtype).char),
                lambda: rbf_gram(X, self.gamma, dtype=self.gram_dtype, n_jobs=n_jobs),
                latest=True,
            )
        if gram.shape != (len(X), len(X)):
            raise PlacecatError(
                f"gram has shape {gram.shape} for {len(X)} samples; give a square matrix of these"
            )
        return np.ascontiguousarray(gram, dtype=self.gram_dtype)

    def decide_rows(self, shared: NDArray[Any], rows: NDArray[np.intp]) -> NDArray[np.float64]:
        """Evaluate for rows of the Gram matrix `shared` (n, n): (len(rows),) float64."""
        weights = np.zeros(len(shared), dtype=shared.dtype)
        weights[self.support_] = self.dual_coef_
        # A slice of the matrix is a view; an index list would make a copy.
        contiguous = (
            len(rows) > 0 and rows[-1] - rows[0] + 1 == len(rows) and bool(np.all(np.diff(rows) == 1))
        )
        block = shared[rows[0] : rows[-1] + 1] if contiguous else shared[rows]
        return (block @ weights).astype(np.float64) + self.intercept_

    def decision_function(self, X: ArrayLike) -> NDArray[np.float64]:
        """Return decision values (n,) of samples (n, D), positive for ``classes_[1]``. Needs `fit`."""
        check_is_fitted(self, "support_vectors_")
        samples = check_samples(X)
        check_width(samples, self)
        coef = self.dual_coef_[:, None]
        expansion = KernelExpansion(
            self.support_vectors_, coef, np.array([self.intercept_]), float(self.gamma)
        )
        return expansion.decisions(samples)[:, 0]

    def predict(self, X: ArrayLike) -> NDArray[Any]:
        """Return the labels (n,) of samples (n, D). Needs `fit`."""
        positive = self.decision_function(X) > 0
        return self.classes_[positive.astype(int)]

    @staticmethod
    def collect(machines: Sequence["KernelMachine"], X: NDArray[np.float32]) -> KernelExpansion:
        """Combine machines fitted on the same samples `X` (n, D) for prediction."""
        return KernelExpansion.union(machines, X)
