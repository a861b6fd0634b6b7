"""Log-loss and calibration of distributions over places, weighting all places equally."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray


class Reliability(NamedTuple):
    """The points of a reliability diagram, which shows how often decisions of similar confidence are correct.

    All three arrays have one entry per bin. `confidence` is the mean probability of the decided place, and
    `accuracy` is the share of correct decisions. Both range from 0 to 1, and are NaN for an empty bin.
    `weight` is the weighted share of frames. It sums to 1, or is all 0 if no frame is labelled.
    """

    confidence: NDArray[np.float64]
    accuracy: NDArray[np.float64]
    weight: NDArray[np.float64]


def balanced_weights(truth: ArrayLike) -> NDArray[np.float64]:
    """Return frame weights that give each place present the same total weight, as in thesis 4.2.

    `truth` contains (n,) integers, with -1 for frames that are not scored. The (n,) weights sum to 1 and are
    0 for frames that are not scored. If no frame is scored, all weights are 0.
    """
    truth = np.asarray(truth, dtype=np.int64)
    scored = truth >= 0
    counts = np.bincount(truth[scored])
    weights = np.zeros(len(truth))
    weights[scored] = 1.0 / (counts[truth[scored]] * np.count_nonzero(counts))
    return weights


def log_loss(truth: ArrayLike, proba: ArrayLike, *, smallest: float) -> float:
    """Average -ln p(true place), in nats, over the frames of each place and then over the places present.

    `truth` contains (n,) integers, with -1 for frames that are not scored, and `proba` contains (n,
    n_classes) distributions. The log-loss of uniform distributions over k places is ln k. The result is NaN
    if no frame is scored. Probabilities below `smallest`, a number in (0, 1), are raised to it. This limits
    the loss of a frame to -ln `smallest`, so a single 0 cannot make the mean infinite.
    """
    truth = np.asarray(truth, dtype=np.int64)
    weights = balanced_weights(truth)
    scored = np.flatnonzero(truth >= 0)
    if not scored.size:
        return float("nan")
    of_truth = np.asarray(proba, dtype=np.float64)[scored, truth[scored]]
    return float(-weights[scored] @ np.log(np.maximum(of_truth, smallest)))


def reliability(truth: ArrayLike, proba: ArrayLike, *, bins: int) -> Reliability:
    """Compare the confidence of decisions with their accuracy, giving all places equal weight.

    `truth` contains (n,) integers, with -1 for frames that are not scored, and `proba` contains
    (n, n_classes) distributions. The decision is the most probable class (the first in a tie), and its
    probability is the confidence. Confidences in ((m - 1) / `bins`, m / `bins`] share a bin.

    References
    ----------
    C. Guo, G. Pleiss, Y. Sun and K. Q. Weinberger, On Calibration of Modern Neural Networks, ICML 2017. That
    paper weights all frames equally.
    """
    truth, proba = np.asarray(truth, dtype=np.int64), np.asarray(proba, dtype=np.float64)
    confidence, right = proba.max(axis=1), proba.argmax(axis=1) == truth
    edges = np.linspace(0.0, 1.0, bins + 1)
    # Rounding errors may push a confidence above 1.
    own = np.clip(np.searchsorted(edges, confidence, side="left") - 1, 0, bins - 1)
    weights = balanced_weights(truth)
    weight = _sums(own, weights, bins)
    return Reliability(
        _ratio(_sums(own, weights * confidence, bins), weight),
        _ratio(_sums(own, weights * right, bins), weight),
        weight,
    )


def pooled(diagrams: Sequence[Reliability]) -> Reliability:
    """Merge diagrams with the same bins, such as one per home, giving each equal weight."""
    weights = np.array([one.weight for one in diagrams])
    confidence, accuracy = (
        _ratio(np.nansum(weights * values, axis=0), weights.sum(axis=0))
        for values in (np.array([one.confidence for one in diagrams]), [one.accuracy for one in diagrams])
    )
    return Reliability(confidence, accuracy, weights.mean(axis=0))


def calibration_error(diagram: Reliability) -> float:
    """Compute the expected calibration error, in [0, 1] (Guo et al., equation 3).

    The result is NaN if no frame is scored.
    """
    if not diagram.weight.any():
        return float("nan")
    return float(np.nansum(diagram.weight * np.abs(diagram.accuracy - diagram.confidence)))


def _sums(index: NDArray[np.intp], values: NDArray[np.float64], bins: int) -> NDArray[np.float64]:
    return np.bincount(index, values, bins).astype(np.float64)


def _ratio(total: NDArray[np.float64], weight: NDArray[np.float64]) -> NDArray[np.float64]:
    return np.divide(total, weight, out=np.full(len(weight), np.nan), where=weight > 0)
