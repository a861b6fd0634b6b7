"""Quality measures for the distributions in a home."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from placecat.evaluation.probabilities import calibration_error, log_loss, reliability
from placecat.evaluation.stays import stay_accuracy, stays_by_class


class ProbabilityQuality(NamedTuple):
    """Log-loss and calibration error, as in :class:`HomeQuality`."""

    log_loss: float
    calibration_error: float


class HomeQuality(NamedTuple):
    """Quality measures for a home.

    `log_loss` is in nats (:func:`placecat.evaluation.probabilities.log_loss`), and `calibration_error` is in
    percent (:func:`placecat.evaluation.probabilities.calibration_error`). `stays` is the number of stays, and
    `stays_right` is how many of them are named correctly (:func:`placecat.evaluation.stays.stays_by_class`).
    `stay_accuracy` is in percent (:func:`placecat.evaluation.stays.stay_accuracy`). Apart from the counts,
    the measures weight all places equally, and are NaN if no frame is labelled.
    """

    log_loss: float
    calibration_error: float
    stays: int
    stays_right: int
    stay_accuracy: float


def probability_quality(
    truth: ArrayLike, proba: NDArray[np.float64], *, bins: int, smallest: float
) -> ProbabilityQuality:
    """Compute the measures that ignore frame order. The parameters are as in :func:`home_quality`."""
    return ProbabilityQuality(
        log_loss(truth, proba, smallest=smallest),
        100.0 * calibration_error(reliability(truth, proba, bins=bins)),
    )


def home_quality(
    truth: ArrayLike, proba: NDArray[np.float64], sequences: Sequence[slice], *, bins: int, smallest: float
) -> HomeQuality:
    """Compute the quality measures for the distributions in a home.

    `truth` contains (frames,) class indices in temporal order, with -1 for unlabelled frames. `proba`
    contains (frames, n_classes) distributions. `sequences` contains one slice of frames per sequence, and the
    slices together cover all frames. `bins` and `smallest` are passed to `reliability` and `log_loss` in
    `placecat.evaluation.probabilities`.
    """
    counts = stays_by_class(truth, proba.argmax(axis=1), sequences, proba.shape[1])
    stays, right = (int(count) for count in counts.sum(axis=0))
    return HomeQuality(
        *probability_quality(truth, proba, bins=bins, smallest=smallest),
        stays,
        right,
        stay_accuracy(counts),
    )
