"""Convert decision values to probabilities with a fitted sigmoid."""

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.special import expit

from placecat.errors import PlacecatError

# Newton's method takes at most this many steps, and stops once the gradient per sample is below this
# tolerance. The decision values are standardised first.
_STEPS, _TOLERANCE = 100, 1e-10


def fit_sigmoid(decisions: ArrayLike, positive: ArrayLike, balanced: bool = False) -> tuple[float, float]:
    """Fit p(positive | d) = 1 / (1 + exp(A d + B)), where A <= 0, by maximum likelihood.

    The targets are smoothed to (n+ + 1) / (n+ + 2) for positives and 1 / (n- + 2) for negatives. Newton's
    method with step halving solves the convex problem. The thesis (3.3.1.2) uses this method through dlib's
    probabilistic decision function.

    A larger decision value never makes the positive class less probable. If the best sigmoid is decreasing,
    the result is flat (A = 0) instead. It is also flat if all decision values are equal.

    Parameters
    ----------
    decisions
        (n,) decision values, preferably for samples held out by cross-validation. Raises PlacecatError if n
        is 0 or a value is not finite.
    positive
        (n,) bool, true for positive samples.
    balanced
        Whether positives and negatives have a total weight of n / 2 each. If so, p assumes equally frequent
        classes.

    Returns
    -------
    A (at most 0) and B.

    References
    ----------
    Platt, Probabilistic outputs for support vector machines, 1999.
    Lin, Lin and Weng, A note on Platt's probabilistic outputs for support vector machines, 2007.

    Examples
    --------
    >>> a, b = fit_sigmoid([-2.0, -1.0, 1.0, 2.0], [False, False, True, True])
    >>> a < 0, abs(b) < 1e-8
    (True, True)
    >>> fit_sigmoid([-2.0, -1.0, 1.0, 2.0], [True, True, False, False])
    (0.0, 0.0)
    """
    d = np.asarray(decisions, dtype=np.float64).ravel()
    is_positive = np.asarray(positive, dtype=bool).ravel()
    if len(d) == 0 or not np.isfinite(d).all():
        raise PlacecatError(
            "the sigmoid needs held-out decision values, and all must be finite: check the folds"
        )
    n_positive = int(is_positive.sum())
    n_negative = len(d) - n_positive
    target = np.where(is_positive, (n_positive + 1.0) / (n_positive + 2.0), 1.0 / (n_negative + 2.0))

    weights = np.ones(len(d))
    if balanced and n_positive and n_negative:
        weights = np.where(is_positive, 0.5 * len(d) / n_positive, 0.5 * len(d) / n_negative)

    # Standardising the decision values makes the Hessian well conditioned, whatever their scale.
    shift, scale = float(d.mean()), float(d.std())
    rate = float(np.average(target, weights=weights))
    flat = 0.0, float(np.log((1.0 - rate) / rate))
    if scale <= 1e-12 * max(1.0, abs(shift)):
        return flat
    z = (d - shift) / scale

    def loss(slope: float, offset: float) -> float:
        f = slope * z + offset
        return float(weights @ (np.logaddexp(0.0, f) - (1.0 - target) * f))

    slope, offset = flat
    value = loss(slope, offset)
    for _ in range(_STEPS):
        p = expit(-(slope * z + offset))
        residual = weights * (target - p)
        g_slope, g_offset = float(residual @ z), float(residual.sum())
        if max(abs(g_slope), abs(g_offset)) < _TOLERANCE * len(d):
            break
        weight = weights * p * (1.0 - p)
        h11 = float(weight @ (z * z)) + 1e-12
        h12 = float(weight @ z)
        h22 = float(weight.sum()) + 1e-12
        determinant = h11 * h22 - h12 * h12
        d_slope = -(h22 * g_slope - h12 * g_offset) / determinant
        d_offset = -(h11 * g_offset - h12 * g_slope) / determinant
        descent = g_slope * d_slope + g_offset * d_offset
        step = 1.0
        while step > 1e-10:
            new = loss(slope + step * d_slope, offset + step * d_offset)
            if new <= value + 1e-4 * step * descent:
                break
            step /= 2.0
        else:
            break
        slope, offset, value = slope + step * d_slope, offset + step * d_offset, new
    # The problem is convex, so if the best sigmoid is decreasing, the best non-decreasing one is flat.
    return flat if slope > 0.0 else (slope / scale, offset - slope * shift / scale)


def apply_sigmoid(decisions: NDArray[np.float64], a: ArrayLike, b: ArrayLike) -> NDArray[np.float64]:
    """Return 1 / (1 + exp(a d + b)), in [0, 1], without overflow. NaN stays NaN.

    `decisions` may have any shape. `a` and `b` come from `fit_sigmoid` and are broadcast against `decisions`.
    """
    return expit(-(np.asarray(a) * decisions + np.asarray(b)))
