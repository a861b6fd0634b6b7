"""Two-class nu-SVM with an RBF kernel, fitted on a shared Gram matrix."""

import logging
from typing import Annotated, Self

import numpy as np
from numpy.typing import NDArray
from sklearn.base import BaseEstimator, ClassifierMixin

from placecat.errors import PlacecatError
from placecat.learning.kernel_machine import KernelMachine
from placecat.ranges import OneOf, Positive, PositiveShare

logger = logging.getLogger(__name__)

POLICIES = ("lower", "refuse")


def largest_feasible_nu(n_positive: int, n_negative: int) -> float:
    """Return 2 min(n+, n-) / n, above which the nu-SVM has no solution.

    References
    ----------
    Chen, Lin and Schölkopf, A tutorial on nu-support vector machines, 2005 (thesis [8]).

    Examples
    --------
    >>> largest_feasible_nu(10, 90)
    0.2
    """
    return 2.0 * min(n_positive, n_negative) / (n_positive + n_negative)


def accepted_nu(nu: float, n_positive: int, n_negative: int) -> float:
    """Return `nu`, capped just below the largest feasible nu.

    At the limit, the weight of every sample of the smaller class is at its bound. To compute the margin,
    libsvm needs a sample whose weight is not at its bound. Otherwise it would divide by zero or infinity.
    """
    return min(nu, largest_feasible_nu(n_positive, n_negative) * (1.0 - 1e-7))


class NuSVM(KernelMachine, ClassifierMixin, BaseEstimator):
    """Binary nu-SVM (thesis 3.3.1.2, [66]) with the kernel exp(-gamma ||x - y||^2).

    The solver is libsvm, called through scikit-learn's NuSVC. `fit` takes samples, whereas `prepare` and
    `fit_rows` let many fits share one Gram matrix.

    Parameters
    ----------
    gamma
        Inverse squared kernel width, > 0. Thesis 4.2 uses 2.0. `KernelScaling` sets the scale of X.
    nu
        Share of margin errors, in (0, 1]. Thesis 4.2 uses 0.2.
    nu_policy
        What to do if nu exceeds 2 min(n+, n-) / n. ``lower`` lowers nu to this limit, as in thesis 4.2 and
        4.3, and ``refuse`` raises PlacecatError.
    tol
        libsvm's stopping tolerance. The thesis does not specify this.
    cache_mb
        Size of libsvm's cache per fit, in MB. It affects only speed.

    Attributes
    ----------
    nu_
        The nu actually used: the smaller of `nu` and the largest feasible nu, doubled until there is a
        margin.
    classes_, support_, support_vectors_, dual_coef_, intercept_
        See `KernelMachine`.

    References
    ----------
    Schölkopf et al., New support vector algorithms, Neural Computation 12, 2000.

    Examples
    --------
    >>> model = NuSVM(gamma=1.0, nu=0.5).fit([[0.0], [0.2], [2.0], [2.2]], ["a", "a", "b", "b"])
    >>> model.predict([[0.1], [2.1]]).tolist()
    ['a', 'b']
    """

    gram_dtype = np.float64

    def __init__(
        self,
        gamma: Positive = 2.0,
        nu: PositiveShare = 0.2,
        nu_policy: Annotated[str, OneOf(POLICIES)] = "lower",
        tol: Positive = 1e-3,
        cache_mb: Positive = 400.0,
    ) -> None:
        self.gamma = gamma
        self.nu = nu
        self.nu_policy = nu_policy
        self.tol = tol
        self.cache_mb = cache_mb

    def fit_rows(
        self,
        shared: NDArray[np.float64],
        positive: NDArray[np.bool_],
        rows: NDArray[np.intp] | None = None,
        context: str = "this class",
    ) -> Self:
        """Fit on some rows of a Gram matrix without copying it; see `TwoClass.fit_rows`.

        With the policy ``refuse``, this also raises PlacecatError if nu is infeasible or leaves no margin.
        With ``lower``, it does so only if even the largest feasible nu leaves no margin.
        """
        import sklearn
        from sklearn.svm import NuSVC

        chosen = np.arange(len(shared)) if rows is None else rows
        n_positive = int(np.count_nonzero(positive[chosen]))
        n_negative = len(chosen) - n_positive
        if min(n_positive, n_negative) == 0:
            raise PlacecatError(
                f"{context}: a nu-SVM needs samples of both classes; add samples or drop the class"
            )
        largest = largest_feasible_nu(n_positive, n_negative)
        counts = f"{n_positive} of {len(chosen)} samples positive"
        if self.nu > largest:
            if self.nu_policy == "refuse":
                raise PlacecatError(
                    f"nu = {self.nu} is infeasible for {context} ({counts}): the largest feasible value is "
                    f"{largest:.6g}; lower nu or set nu_policy to 'lower'"
                )
            logger.info("nu lowered from %g to %.6g for %s (%s)", self.nu, largest, context, counts)
        # A zero weight excludes a sample without copying the matrix.
        weights = None
        if len(chosen) < len(shared):
            weights = np.zeros(len(shared))
            weights[chosen] = 1.0
        nu = min(float(self.nu), largest)
        while True:
            machine = NuSVC(
                nu=accepted_nu(nu, n_positive, n_negative),
                kernel="precomputed",
                tol=self.tol,
                cache_size=self.cache_mb,
            )
            try:
                with sklearn.config_context(assume_finite=True, skip_parameter_validation=True):
                    machine.fit(shared, positive, sample_weight=weights)
                break
            except ValueError as error:
                # If both classes have identical samples, a small nu leaves a margin of 0, and libsvm divides
                # by it.
                if "not finite" not in str(error):
                    raise
                if self.nu_policy == "refuse" or nu >= largest:
                    raise PlacecatError(
                        f"nu = {nu:.6g} leaves no margin for {context} ({counts}), because both classes "
                        f"have identical descriptors: use a nu closer to {largest:.6g}, or another "
                        "descriptor or scaling"
                    ) from None
                logger.info("nu raised from %g for %s: no margin", nu, context)
                nu = min(2 * nu, largest)
        self.nu_ = nu
        # scikit-learn's support_ counts only samples with a nonzero weight.
        self.support_ = chosen[machine.support_].astype(np.intp)
        self.dual_coef_ = np.asarray(machine.dual_coef_[0], dtype=np.float64)
        self.intercept_ = float(machine.intercept_[0])
        return self
