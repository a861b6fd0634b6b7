"""Measure how many decisions reach a confidence threshold, and how many of these are wrong."""

import math
from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from placecat.evaluation.probabilities import balanced_weights

# Tolerance for rounding errors in sums of weights.
_ROUNDING = 1e-9


class Decided(NamedTuple):
    """The confidence and weight of each decision on a home's n labelled frames, and whether it is wrong.

    The weights sum to 1, so all homes count equally. So do the places in a home, as in the accuracy.
    """

    confidence: NDArray[np.float64]
    wrong: NDArray[np.bool_]
    weight: NDArray[np.float64]


class Selection(NamedTuple):
    """Coverage and risk, each in [0, 1], of the decisions that reach a confidence threshold.

    `coverage` is the share of decisions that reach the threshold, `risk` is the share of these that are
    wrong, and `worst` is the highest risk in any home. Both risks are NaN if no decision reaches the
    threshold.
    """

    coverage: float
    risk: float
    worst: float


def decided(truth: ArrayLike, proba: ArrayLike) -> Decided:
    """Return the confidence and weight of each decision in a home, and whether it is wrong.

    `truth` contains (n,) integers, with -1 for frames that are not scored, and `proba` contains
    (n, n_classes) distributions. The decision is the most probable class, or the first in a tie.
    """
    truth, proba = np.asarray(truth, np.int64), np.asarray(proba, np.float64)
    scored = truth >= 0
    wrong = proba.argmax(axis=1) != truth
    return Decided(proba.max(axis=1)[scored], wrong[scored], balanced_weights(truth)[scored])


def choose_threshold(homes: Sequence[Decided], risk: float) -> float:
    """Choose the lowest threshold that keeps the share of wrong decisions at or below `risk`, in [0, 1].

    `homes` contains the decisions for each home, made by a system that was not trained on that home. Returns
    the confidence of one of the decisions, or infinity if none is high enough.

    References
    ----------
    Y. Geifman and R. El-Yaniv, Selective Classification for Deep Neural Networks, NeurIPS 2017. Their bound
    is not used here because it assumes that frames are independent, which the frames of a walk are not.
    """
    confidence, wrong, weight = (np.concatenate(parts) for parts in zip(*homes, strict=True))
    order = np.argsort(-confidence, kind="stable")
    confidence, weight = confidence[order], weight[order]
    risks = np.cumsum(weight * wrong[order]) / np.cumsum(weight)
    # A threshold cannot separate equal confidences.
    is_last = np.append(confidence[1:] != confidence[:-1], True)
    good = np.flatnonzero(is_last & (risks <= risk + _ROUNDING))
    return float(confidence[good[-1]]) if len(good) else math.inf


def select(homes: Sequence[Decided], thresholds: Sequence[float]) -> Selection:
    """Measure the coverage and risk of the decisions at or above each home's threshold."""
    left = []
    for home, threshold in zip(homes, thresholds, strict=True):
        is_left = home.confidence >= threshold
        left.append((home.weight[is_left].sum(), home.weight[is_left & home.wrong].sum()))
    weight, wrong = np.array(left).T
    some = weight > 0
    if not some.any():
        return Selection(0.0, math.nan, math.nan)
    weight_of_some, wrong_of_some = weight[some], wrong[some]
    return Selection(
        float(weight.mean()),
        float(wrong_of_some.sum() / weight_of_some.sum()),
        float((wrong_of_some / weight_of_some).max()),
    )


def select_unseen(homes: Mapping[str, Decided], risk: float) -> Selection:
    """Measure coverage and risk on two or more homes, choosing the threshold for each home on the others."""
    thresholds = [
        choose_threshold([other for name, other in homes.items() if name != home], risk) for home in homes
    ]
    return select(list(homes.values()), thresholds)
