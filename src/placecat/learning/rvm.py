"""Two-class relevance vector machine, fitted by fast marginal likelihood maximisation on a Gram matrix."""

import logging
from typing import NamedTuple, Self

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import LinAlgError, cho_factor, cho_solve, solve_triangular
from scipy.special import expit
from sklearn.base import BaseEstimator, ClassifierMixin

from placecat.errors import PlacecatError
from placecat.learning.kernel_machine import KernelMachine
from placecat.learning.single_thread import single_blas_thread
from placecat.ranges import Count, Positive

logger = logging.getLogger(__name__)

# Number of Gram matrix rows squared at a time. For 8000 samples, this takes 4 MiB.
SQUARE_ROWS = 128
# Number of functions whose sparsity factors are updated in each round.
SHORTLIST = 1024


class RVM(KernelMachine, ClassifierMixin, BaseEstimator):
    """Binary relevance vector machine (thesis 3.3.1.2) with the kernel exp(-gamma ||x - y||^2).

    The model has a basis function per training sample, a bias, a logistic likelihood, and weights w with the
    prior N(0, diag(1/alpha)). Fitting maximises the evidence over alpha by adding, re-estimating or deleting
    one basis function at a time (Tipping and Faul 2003). The Laplace approximation at the mode of w makes the
    problem Gaussian. After each approximation, the statistics that rank all functions are updated. Many
    additions, re-estimates and deletions follow, but only of functions in the model and the most promising
    ones outside it.

    Parameters
    ----------
    gamma
        Inverse squared kernel width, > 0. The thesis specifies no value for the RVM. The default of 2.0
        matches that of the nu-SVM.
    tol
        Fitting stops when further rounds raise the log evidence by less than this, in nats per sample.
    max_iter
        Maximum number of Laplace approximations. A warning is logged if it is reached.
    candidates
        Maximum number of basis functions outside the model that each round considers.

    Attributes
    ----------
    support_, dual_coef_, intercept_
        Indices and weights of the relevance vectors, and the weight of the bias (0 if it is not in the
        model).
    alpha_
        (s,) prior precisions of `dual_coef_`.
    evidence_
        Log marginal likelihood in the Laplace approximation.
    classes_, support_vectors_
        See `KernelMachine`.

    Notes
    -----
    `predict_proba` returns the sigmoid at the mode of w and ignores the posterior variance (Tipping 2001,
    section 3).

    References
    ----------
    Tipping, Sparse Bayesian learning and the relevance vector machine, JMLR 1, 2001.
    Tipping and Faul, Fast marginal likelihood maximisation for sparse Bayesian models, AISTATS 2003.

    Examples
    --------
    >>> X = np.linspace(-2.0, 2.0, 41)[:, None]
    >>> model = RVM(gamma=1.0).fit(X, X[:, 0] > 0.5)
    >>> model.predict([[0.0], [1.0]]).tolist(), len(model.support_) < 6
    ([False, True], True)
    """

    #: The sigmoid of the logistic likelihood.
    own_sigmoid = (-1.0, 0.0)
    prefers_own_sigmoid = False

    def __init__(
        self, gamma: Positive = 2.0, tol: Positive = 1e-5, max_iter: Count = 200, candidates: Count = 100
    ) -> None:
        self.gamma = gamma
        self.tol = tol
        self.max_iter = max_iter
        self.candidates = candidates

    def fit_rows(
        self,
        shared: NDArray[np.float32],
        positive: NDArray[np.bool_],
        rows: NDArray[np.intp] | None = None,
        context: str = "this class",
    ) -> Self:
        """Fit on a copy of some rows of a Gram matrix; see `TwoClass.fit_rows`."""
        chosen = np.arange(len(shared)) if rows is None else rows
        target = positive[chosen].astype(np.float64)
        if target.min() == target.max():
            raise PlacecatError(
                f"{context}: an RVM needs samples of both classes; add samples or drop the class"
            )
        gram = shared if rows is None else shared[np.ix_(rows, rows)]
        with single_blas_thread():
            active, weights, alpha = self._maximise(gram, target, context)
        n = len(chosen)
        kernels = active < n
        order = np.argsort(active[kernels])
        self.support_ = chosen[active[kernels][order]].astype(np.intp)
        self.dual_coef_ = weights[kernels][order]
        self.alpha_ = alpha[kernels][order]
        self.intercept_ = float(weights[~kernels].sum())
        return self

    def _maximise(
        self, gram: NDArray[np.float32], target: NDArray[np.float64], context: str
    ) -> tuple[NDArray[np.intp], NDArray[np.float64], NDArray[np.float64]]:
        """Maximise the evidence. Return the active functions (n is the bias), their weights and alpha."""
        tol = self.tol * len(target)
        active = np.array([len(target)])
        basis = _basis(gram, active)
        best = _laplace_mode(basis, target, np.ones(1), np.zeros(1))
        statistics = _Statistics(gram)
        promising = statistics.promising(basis, best, self.candidates, renew=True)
        surrogate = _Surrogate(gram, basis, best, active, promising)
        steps = most = 2 * self.candidates
        small_rises = 0
        for _ in range(self.max_iter):
            new_active, alpha, start, expected = surrogate.ascend(best.alpha, steps)
            risen = 0.0
            if expected >= tol:
                new_basis = _basis(gram, new_active)
                mode = _laplace_mode(new_basis, target, alpha, start)
                risen = mode.evidence - best.evidence
                if risen <= 0 and steps > 1:
                    # The steps on the Gaussian problem went too far, so go back and take fewer steps.
                    steps = max(steps // 4, 1)
                    continue
                if risen > 0:
                    active, basis, best = new_active, new_basis, mode
                    steps = min(2 * steps, most)
            # A single small rise may be due to taking too few steps, so convergence requires several.
            small_rises = small_rises + 1 if risen < tol else 0
            if statistics.current and (expected < tol or small_rises > 2):
                break
            promising = statistics.promising(basis, best, self.candidates, renew=small_rises > 0)
            surrogate = _Surrogate(gram, basis, best, active, promising)
        else:
            logger.warning("RVM of %s stopped after %d rounds without converging", context, self.max_iter)
        self.evidence_ = best.evidence
        return active, best.weights, best.alpha


class _Mode(NamedTuple):
    """Laplace approximation of the posterior over the model's weights."""

    weights: NDArray[np.float64]
    alpha: NDArray[np.float64]
    # (n,) target minus prediction.
    error: NDArray[np.float64]
    # (n,) p (1 - p).
    curvature: NDArray[np.float64]
    # Lower Cholesky factor of basis B basis' + diag(alpha).
    factor: NDArray[np.float64]
    # -inf if the functions are so similar that factorisation fails. Such a mode is never kept.
    evidence: float


def _basis(gram: NDArray[np.float32], active: NDArray[np.intp]) -> NDArray[np.float64]:
    """Return the (m, n) values of the active basis functions at the n samples; function n is the bias."""
    n = len(gram)
    basis = np.ones((len(active), n))
    kernels = active < n
    basis[kernels] = gram[active[kernels]]
    return basis


def _laplace_mode(
    basis: NDArray[np.float64],
    target: NDArray[np.float64],
    alpha: NDArray[np.float64],
    start: NDArray[np.float64],
) -> _Mode:
    """Find the mode of w by Newton's method.

    `basis` is (m, n), `target` is (n,) and contains zeros and ones, and `alpha` and `start` are (m,).
    """
    narrow = basis.astype(np.float32)
    diagonal = np.diag_indices(len(alpha))

    def penalised(w: NDArray[np.float64]) -> tuple[float, NDArray[np.float64]]:
        f = w @ basis
        return float(np.logaddexp(0.0, f).sum() - target @ f + 0.5 * (alpha * w) @ w), f

    weights = start
    value, f = penalised(weights)
    for _ in range(50):
        p = expit(f)
        # The direction may be approximate, but the gradient and the value must be accurate.
        rough = narrow * np.sqrt(p * (1.0 - p)).astype(np.float32)
        hessian = (rough @ rough.T).astype(np.float64)
        hessian[diagonal] += alpha
        gradient = basis @ (target - p) - alpha * weights
        try:
            factor = cho_factor(hessian, lower=True)
        except LinAlgError:
            # If functions are nearly identical, float32 is too imprecise, so use float64.
            factor = _factor(basis, p * (1.0 - p), alpha)
            if factor is None:
                return _Mode(weights, alpha, target - p, p, hessian, -np.inf)
        move = cho_solve(factor, gradient)
        if float(gradient @ move) < 1e-6:
            break
        step = 1.0
        while True:
            new_value, new_f = penalised(weights + step * move)
            if new_value <= value or step < 1e-6:
                break
            step /= 2.0
        if new_value > value:
            break
        weights, value, f = weights + step * move, new_value, new_f
    p = expit(f)
    curvature = p * (1.0 - p)
    factor = _factor(basis, curvature, alpha)
    if factor is None:
        return _Mode(weights, alpha, target - p, p, hessian, -np.inf)
    lower = np.tril(factor[0])
    evidence = -value + 0.5 * float(np.log(alpha).sum()) - float(np.log(np.diag(lower)).sum())
    return _Mode(weights, alpha, target - p, curvature, lower, evidence)


def _factor(
    basis: NDArray[np.float64], curvature: NDArray[np.float64], alpha: NDArray[np.float64]
) -> tuple[NDArray[np.float64], bool] | None:
    """Return `cho_factor` of basis B basis' + diag(alpha), or None if rounding errors prevent it."""
    scaled = basis * np.sqrt(curvature)
    hessian = scaled @ scaled.T
    hessian[np.diag_indices(len(alpha))] += alpha
    try:
        factor: tuple[NDArray[np.float64], bool] = cho_factor(hessian, lower=True)
    except LinAlgError:
        return None
    return factor


class _Statistics:
    """Sparsity and quality factors of the n kernels and the bias, which show which functions are promising.

    The quality factors are always up to date. The sparsity factors require a product of Gram matrix rows with
    all functions in the model. In most rounds, they are therefore updated only for the most promising
    functions. Before convergence is declared, they are updated for all functions.
    """

    def __init__(self, gram: NDArray[np.float32]) -> None:
        self.gram = gram
        self.sparsity = np.ones(len(gram) + 1)
        self.current = False

    def promising(self, basis: NDArray[np.float64], mode: _Mode, count: int, renew: bool) -> NDArray[np.intp]:
        """Return up to `count` functions, in ascending order, that would increase the evidence the most."""
        gram, n = self.gram, len(self.gram)
        squared_quality = np.empty(n + 1)
        squared_quality[:n] = gram @ mode.error.astype(np.float32)
        squared_quality[n] = mode.error.sum()
        squared_quality **= 2
        self.current = renew or n <= SHORTLIST
        functions = np.arange(n)
        if not self.current:
            ratio = squared_quality[:n] / self.sparsity[:n]
            functions = np.sort(np.argpartition(-ratio, SHORTLIST)[:SHORTLIST])
        curvature = mode.curvature.astype(np.float32)
        whitened = solve_triangular(mode.factor, basis * mode.curvature, lower=True)
        narrow = whitened.astype(np.float32).T
        for start in range(0, len(functions), SQUARE_ROWS):
            chosen = functions[start : start + SQUARE_ROWS]
            rows = gram[chosen[0] : chosen[-1] + 1] if self.current else gram[chosen]
            explained = rows @ narrow
            self.sparsity[chosen] = (rows * rows) @ curvature - np.einsum("ij,ij->i", explained, explained)
        self.sparsity[n] = mode.curvature.sum() - float((whitened.sum(axis=1) ** 2).sum())
        np.maximum(self.sparsity, 1e-6, out=self.sparsity)
        ratio = squared_quality / self.sparsity
        best = np.argsort(-ratio, kind="stable")[:count]
        return np.sort(best[ratio[best] > 1.0])


class _Surrogate:
    """The Gaussian problem at a Laplace mode, for the functions in the model and other promising ones.

    Let C = B^-1 + sum_a phi_a phi_a' / alpha_a. Changing 1/alpha_i by d causes a rank-one change of
    R = Phi' C^-1 Phi and Q = Phi' C^-1 z for the pool's functions Phi:
    R -= R_i R_i' d / (1 + d R_ii), Q -= R_i Q_i d / (1 + d R_ii), and the log evidence gains
    (Q_i^2 d / (1 + d R_ii) - log(1 + d R_ii)) / 2. Adding, re-estimating and deleting a function differ
    only in d.

    In the pool, the functions in the model come first.
    """

    def __init__(
        self,
        gram: NDArray[np.float32],
        basis: NDArray[np.float64],
        mode: _Mode,
        active: NDArray[np.intp],
        promising: NDArray[np.intp],
    ) -> None:
        added = promising[~np.isin(promising, active)]
        phi = np.concatenate([basis, _basis(gram, added)])
        weighted = phi * np.sqrt(mode.curvature)
        r = weighted @ weighted.T
        explained = solve_triangular(mode.factor, r[: len(active)], lower=True)
        r -= explained.T @ explained
        self.pool = np.concatenate([active, added])
        self.r = r
        self.q = phi @ mode.error

    def ascend(
        self, alpha: NDArray[np.float64], steps: int
    ) -> tuple[NDArray[np.intp], NDArray[np.float64], NDArray[np.float64], float]:
        """Change the alpha with the greatest gain, up to `steps` times.

        `alpha` contains the (m,) precisions of the functions in the model. Returns the (m',) functions of the
        new model, their precisions, their mean weights in the Gaussian problem, and the sum of the gains in
        nats.
        """
        # A step needs only the diagonal and one column of R.
        q, r_diagonal = self.q.copy(), self.r.diagonal().copy()
        columns, scaled, terms = (np.empty((steps + 1, len(q))) for _ in range(3))
        inverse = np.zeros(len(self.pool))
        inverse[: len(alpha)] = 1.0 / alpha
        total = 0.0
        for step in range(steps):
            diagonal = np.maximum(r_diagonal, 1e-12)
            # Remove each function's own contribution: s = R / (1 - R / alpha), and likewise q.
            own = np.maximum(1.0 - diagonal * inverse, 1e-12)
            sparsity, quality = diagonal / own, q / own
            best = np.maximum(quality**2 - sparsity, 0.0) / sparsity**2
            change = best - inverse
            grown = np.maximum(1.0 + change * diagonal, 1e-12)
            gain = 0.5 * (q**2 * change / grown - np.log(grown))
            # The model must not become empty.
            if np.count_nonzero(inverse) == 1:
                gain[(inverse > 0) & (best == 0)] = -np.inf
            i = int(gain.argmax())
            if not gain[i] > 1e-9:
                break
            scale = change[i] / grown[i]
            terms[0] = self.r[:, i]
            np.multiply(scaled[:step], columns[:step, i, None], out=terms[1 : step + 1])
            column = np.subtract.reduce(terms[: step + 1], axis=0, out=columns[step])
            q -= column * (q[i] * scale)
            np.multiply(column, scale, out=scaled[step])
            r_diagonal -= scaled[step] * column
            inverse[i] = best[i]
            total += float(gain[i])
        kept = inverse > 0
        return self.pool[kept], 1.0 / inverse[kept], q[kept] * inverse[kept], total
