"""How good distributions over places are: log-loss and calibration, with every place weighing the same."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from placecat.errors import PlacecatError


class Reliability(NamedTuple):
    """The points of a reliability diagram: what happens to frames whose decision is about as sure.

    Attributes
    ----------
    confidence
        (bins,) mean probability of the decided place, 0 to 1; NaN in a bin without frames.
    accuracy
        (bins,) share of the decisions that are right, 0 to 1; NaN likewise.
    weight
        (bins,) share of the frames, which sum to 1; all 0 if no frame is labelled.
    """

    confidence: NDArray[np.float64]
    accuracy: NDArray[np.float64]
    weight: NDArray[np.float64]


def balanced_weights(truth: ArrayLike) -> NDArray[np.float64]:
    """Weights of frames that make every place that occurs weigh the same, as the accuracy does (thesis 4.2).

    Parameters
    ----------
    truth
        (n,) integers, -1 for frames that are not scored.

    Returns
    -------
    (n,) summing to 1, 0 for frames that are not scored; all 0 if none is.
    """
    truth = np.asarray(truth, dtype=np.int64)
    scored = truth >= 0
    counts = np.bincount(truth[scored])
    weights = np.zeros(len(truth))
    weights[scored] = 1.0 / (counts[truth[scored]] * np.count_nonzero(counts))
    return weights


def log_loss(truth: ArrayLike, proba: ArrayLike, *, smallest: float) -> float:
    """Mean of -ln p(true place) over the frames of each place that occurs, and over these places, in nats.

    Distributions that are uniform over k places have ln k.

    Parameters
    ----------
    truth
        (n,) integers, -1 for frames that are not scored.
    proba
        (n, n_classes) distributions.
    smallest
        In (0, 1). Probabilities below count as this one, so that a single 0 does not make the mean infinite:
        a frame costs -ln `smallest` at most. Nothing else is scaled.

    Returns
    -------
    NaN if no frame is scored.

    Raises
    ------
    PlacecatError
        If `smallest` is no such number.
    """
    if not isinstance(smallest, int | float) or not 0.0 < smallest < 1.0:
        raise PlacecatError(f"probabilities.smallest must be a number in (0, 1), but is {smallest!r}")
    truth = np.asarray(truth, dtype=np.int64)
    weights = balanced_weights(truth)
    scored = np.flatnonzero(truth >= 0)
    if not scored.size:
        return float("nan")
    of_truth = np.asarray(proba, dtype=np.float64)[scored, truth[scored]]
    return float(-weights[scored] @ np.log(np.maximum(of_truth, smallest)))


def reliability(truth: ArrayLike, proba: ArrayLike, *, bins: int) -> Reliability:
    """Compare how sure decisions are with how often they are right, places weighing the same.

    The largest probability of a distribution is its confidence; confidences in ((m - 1) / `bins`, m / `bins`]
    share a bin.

    Parameters
    ----------
    truth
        (n,) integers, -1 for frames that are not scored.
    proba
        (n, n_classes) distributions; of equal largest ones the first is the decision.
    bins
        At least 1.

    Raises
    ------
    PlacecatError
        If `bins` is no such number.

    References
    ----------
    C. Guo, G. Pleiss, Y. Sun and K. Q. Weinberger, On Calibration of Modern Neural Networks, ICML 2017; there
    all frames weigh the same.
    """
    if isinstance(bins, bool) or not isinstance(bins, int) or bins < 1:
        raise PlacecatError(f"probabilities.bins must be a whole number from 1 on, but is {bins!r}")
    truth, proba = np.asarray(truth, dtype=np.int64), np.asarray(proba, dtype=np.float64)
    confidence, right = proba.max(axis=1), proba.argmax(axis=1) == truth
    edges = np.linspace(0.0, 1.0, bins + 1)
    # Rounding may lift a certain decision above 1.
    own = np.clip(np.searchsorted(edges, confidence, side="left") - 1, 0, bins - 1)
    weights = balanced_weights(truth)
    weight = _sums(own, weights, bins)
    return Reliability(
        _ratio(_sums(own, weights * confidence, bins), weight),
        _ratio(_sums(own, weights * right, bins), weight),
        weight,
    )


def pooled(diagrams: Sequence[Reliability]) -> Reliability:
    """One diagram of several with the same bins, e.g. one a home, which weigh the same."""
    weights = np.array([one.weight for one in diagrams])
    confidence, accuracy = (
        _ratio(np.nansum(weights * values, axis=0), weights.sum(axis=0))
        for values in (np.array([one.confidence for one in diagrams]), [one.accuracy for one in diagrams])
    )
    return Reliability(confidence, accuracy, weights.mean(axis=0))


def calibration_error(diagram: Reliability) -> float:
    """Expected calibration error: the mean distance of accuracy and confidence (Guo et al. 2017, equation 3).

    Returns
    -------
    0 to 1; NaN if no frame is scored.
    """
    if not diagram.weight.any():
        return float("nan")
    return float(np.nansum(diagram.weight * np.abs(diagram.accuracy - diagram.confidence)))


def _sums(index: NDArray[np.intp], values: NDArray[np.float64], bins: int) -> NDArray[np.float64]:
    return np.bincount(index, values, bins).astype(np.float64)


def _ratio(total: NDArray[np.float64], weight: NDArray[np.float64]) -> NDArray[np.float64]:
    return np.divide(total, weight, out=np.full(len(weight), np.nan), where=weight > 0)
