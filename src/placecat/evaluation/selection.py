"""Decisions withheld below a confidence threshold: how many remain, and how many of these are wrong."""

import math
from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from placecat.evaluation.probabilities import balanced_weights

# Sums of weights are rounded.
_ROUNDING = 1e-9


class Decided(NamedTuple):
    """Decisions on the n labelled frames of one home: their probabilities, and whether they are wrong.

    The weights sum to 1: all homes weigh the same, and so do the places within a home, as in the accuracy.
    """

    confidence: NDArray[np.float64]
    wrong: NDArray[np.bool_]
    weight: NDArray[np.float64]


class Selection(NamedTuple):
    """Coverage and risk of the decisions at or above a threshold in some homes, from 0 to 1.

    `coverage` is their share of all decisions, `risk` the share of wrong decisions among them, and `worst`
    the highest risk in any home. Both risks are NaN if no decision reaches the threshold.
    """

    coverage: float
    risk: float
    worst: float


def decided(truth: ArrayLike, proba: ArrayLike) -> Decided:
    """Judge the decisions in one home.

    `truth` is (n,) integers, -1 for frames that are not scored, and `proba` (n, n_classes) distributions; the
    decision is the most probable class, the first of several.
    """
    truth, proba = np.asarray(truth, np.int64), np.asarray(proba, np.float64)
    scored = truth >= 0
    wrong = proba.argmax(axis=1) != truth
    return Decided(proba.max(axis=1)[scored], wrong[scored], balanced_weights(truth)[scored])


def choose_threshold(homes: Sequence[Decided], risk: float) -> float:
    """Choose the lowest threshold that keeps the share of wrong decisions at or below `risk`, 0 to 1.

    `homes` holds decisions of systems that have not seen the home. Returns one of the confidences, or
    infinity if none is high enough.

    References
    ----------
    Y. Geifman and R. El-Yaniv, Selective Classification for Deep Neural Networks, NeurIPS 2017. Their bound
    assumes independent frames and is not used: the frames of a walk are dependent.
    """
    confidence, wrong, weight = (np.concatenate(parts) for parts in zip(*homes, strict=True))
    order = np.argsort(-confidence, kind="stable")
    confidence, weight = confidence[order], weight[order]
    risks = np.cumsum(weight * wrong[order]) / np.cumsum(weight)
    # Equal confidences form one group.
    is_last = np.append(confidence[1:] != confidence[:-1], True)
    good = np.flatnonzero(is_last & (risks <= risk + _ROUNDING))
    return float(confidence[good[-1]]) if len(good) else math.inf


def select(homes: Sequence[Decided], thresholds: Sequence[float]) -> Selection:
    """Measure the decisions at or above each home's threshold."""
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
    """Measure each home (at least two) with the threshold chosen on the other homes."""
    thresholds = [
        choose_threshold([other for name, other in homes.items() if name != home], risk) for home in homes
    ]
    return select(list(homes.values()), thresholds)
