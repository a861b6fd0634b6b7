"""The logarithmic opinion pool, a product of the cues' distributions, each raised to a learned power."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import minimize

from placecat.errors import PlacecatError

Float = NDArray[np.float64]

# Lower limit of the probabilities. Without it, a single wrong 0 would rule out a place.
SMALLEST = 1e-6


def pool(proba: Float, weights: Float, smallest: float = SMALLEST) -> Float:
    """Raise each distribution to the power of its cue's weight, multiply the results, and normalise.

    `proba` contains (n, cues, n_classes) distributions. Probabilities below `smallest`, a number in (0, 1),
    are raised to it. `weights` contains one non-negative number per cue. If all are 0, the result is uniform.
    Returns (n, n_classes) distributions.

    >>> pool(np.array([[[0.8, 0.2], [0.1, 0.9]]]), np.array([1.0, 0.0])).round(3).tolist()
    [[0.8, 0.2]]
    """
    powers = np.exp(_scores(_logs(proba, smallest), weights))
    return powers / powers.sum(axis=-1, keepdims=True)


def fit_weights(
    proba: Float,
    truth: NDArray[np.int16],
    homes: NDArray[np.str_] | Sequence[str],
    *,
    shrinkage: float,
    smallest: float = SMALLEST,
) -> Float:
    """Find the (cues,) weights that minimise the log-loss on frames that the cues have not seen.

    The weights are 0 or more, and the loss is convex in them. All homes have equal weight, as do the classes
    within a home. The candidates include each cue on its own, at its best power. Without shrinkage, the pool
    is therefore at least as good as any single cue on these frames.

    `proba` contains (n, cues, n_classes) distributions from cues that saw neither the frame nor its home.
    `smallest` is as in :func:`pool`. `truth` contains the (n,) class indices of the frames, and `homes` names
    the home of each. The loss, in nats, includes the sum of squared weights times `shrinkage`, which is 0 or
    more. Raises PlacecatError if no finite weights are found.

    References
    ----------
    Heskes, Selecting weighting factors in logarithmic opinion pools, NIPS 1997.

    Examples
    --------
    >>> proba = np.array([[[0.9, 0.1], [0.5, 0.5]], [[0.2, 0.8], [0.9, 0.1]]])
    >>> weights = fit_weights(proba, np.array([0, 1], np.int16), ["a", "b"], shrinkage=0.01)
    >>> bool(weights[0] > 1), round(float(weights[1]), 6)
    (True, 0.0)
    """
    logs, index = _logs(proba, smallest), truth.astype(np.intp)
    rows, importance = np.arange(len(logs)), _importance(index, np.asarray(homes))
    right = logs[rows, :, index]

    def loss(weights: Float) -> tuple[float, Float]:
        scores = _scores(logs, weights)
        powers = np.exp(scores)
        total = powers.sum(axis=1)
        expected = (logs * (powers / total[:, None])[:, None]).sum(axis=2)
        value = float((importance * (np.log(total) - scores[rows, index])).sum())
        slope = (importance[:, None] * (expected - right)).sum(axis=0)
        return value + shrinkage * float((weights**2).sum()), slope + 2 * shrinkage * weights

    cues = logs.shape[1]
    start, bounds = np.full(cues, 1.0 / cues), [(0.0, None)] * cues
    options = {"maxiter": 1000, "ftol": 1e-12, "gtol": 1e-8}
    found = minimize(loss, start, jac=True, method="L-BFGS-B", bounds=bounds, options=options)
    if not np.isfinite(found.x).all():
        raise PlacecatError("no finite integration weights were found: raise integrator.shrinkage")
    # The search is accurate to about a millionth. Later decimals vary between processors.
    weights: Float = found.x.round(6)
    return weights


def _logs(proba: Float, smallest: float) -> Float:
    return np.log(np.maximum(np.asarray(proba, dtype=np.float64), smallest))


def _scores(logs: Float, weights: Float) -> Float:
    """Sum (n, cues, n_classes) weighted logarithms over the cues, and subtract each row's maximum."""
    # Add the cues one by one, so that a frame's scores do not depend on the other frames, even in the last
    # bits.
    total = np.zeros((len(logs), logs.shape[2]))
    for cue, weight in enumerate(weights.tolist()):
        total += weight * logs[:, cue]
    return total - total.max(axis=1, keepdims=True)


def _importance(truth: NDArray[np.intp], homes: NDArray[np.str_]) -> Float:
    """Return (n,) frame weights that sum to 1, weighting homes, and classes within a home, equally."""
    _, home = np.unique(homes, return_inverse=True)
    group = home * (truth.max() + 1) + truth
    sizes = np.bincount(group)
    classes = np.array([len(np.unique(truth[home == one])) for one in range(home.max() + 1)])
    importance: Float = 1.0 / (len(classes) * classes[home] * sizes[group])
    return importance
