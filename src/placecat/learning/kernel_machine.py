"""Base class of the two-class classifiers that use a Gram matrix."""

from collections.abc import Sequence
from typing import Any, Self

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray
from sklearn.utils.validation import check_is_fitted

from placecat.learning.checks import check_samples, check_width
from placecat.learning.kernels import KernelExpansion, rbf_gram
from placecat.learning.memory import remembered
from placecat.learning.two_class import TwoClass


class KernelMachine(TwoClass):
    """Two-class classifier whose decision value is a sum over support vectors.

    Each subclass has a parameter `gamma` and a method `fit_rows` that sets `support_`, `dual_coef_` and
    `intercept_`.

    Attributes
    ----------
    classes_, support_vectors_
        The two labels, and the (s, D) float32 support vectors. Only `fit` sets them.
    support_
        (s,) ascending indices of the support vectors among the samples of the Gram matrix.
    dual_coef_
        (s,) float64, the weights of the support vectors in the sum.
    intercept_
        Constant added to the sum.
    """

    gamma: float
    support_: NDArray[np.intp]
    dual_coef_: NDArray[np.float64]
    intercept_: float
    support_vectors_: NDArray[np.float32]
    #: The Gram matrix dtype that the machine can use without copying.
    gram_dtype: DTypeLike = np.float32

    def fit(self, X: ArrayLike, y: ArrayLike) -> Self:
        """See `TwoClass.fit`."""
        super().fit(X, y)
        self.support_vectors_ = check_samples(X)[self.support_]
        return self

    def prepare(self, X: NDArray[np.float32], n_jobs: int | None = None) -> NDArray[Any]:
        """Compute the C-contiguous (n, n) Gram matrix of (n, D) samples in the dtype `gram_dtype`."""
        return remembered(
            "gram",
            (X, float(self.gamma), np.dtype(self.gram_dtype).char),
            lambda: rbf_gram(X, self.gamma, dtype=self.gram_dtype, n_jobs=n_jobs),
            latest=True,
        )

    def decide_rows(self, shared: NDArray[Any], rows: NDArray[np.intp]) -> NDArray[np.float64]:
        """Return (len(rows),) float64 decision values for some rows of the (n, n) Gram matrix `shared`."""
        weights = np.zeros(len(shared), dtype=shared.dtype)
        weights[self.support_] = self.dual_coef_
        # A slice of the matrix is a view, whereas indexing with a list would copy it.
        is_run = len(rows) > 0 and bool(np.all(np.diff(rows) == 1))
        block = shared[rows[0] : rows[-1] + 1] if is_run else shared[rows]
        return (block @ weights).astype(np.float64) + self.intercept_

    def decision_function(self, X: ArrayLike) -> NDArray[np.float64]:
        """Return (n,) decision values for (n, D) samples, positive for ``classes_[1]``. Call `fit` first."""
        check_is_fitted(self, "support_vectors_")
        samples = check_samples(X)
        check_width(samples, self)
        coef, intercept = self.dual_coef_[:, None], np.array([self.intercept_])
        expansion = KernelExpansion(self.support_vectors_, coef, intercept, float(self.gamma))
        return expansion.decisions(samples)[:, 0]

    @staticmethod
    def collect(machines: Sequence["KernelMachine"], X: NDArray[np.float32]) -> KernelExpansion:
        """Combine machines fitted on the same (n, D) samples `X` into one expansion for prediction."""
        support = np.unique(np.concatenate([machine.support_ for machine in machines])).astype(np.intp)
        coef = np.zeros((len(support), len(machines)))
        for k, machine in enumerate(machines):
            coef[np.searchsorted(support, machine.support_), k] = machine.dual_coef_
        intercept = np.array([machine.intercept_ for machine in machines], dtype=np.float64)
        return KernelExpansion(X[support], coef, intercept, float(machines[0].gamma))
