"""Smoothing judged on training homes that nothing smoothed has seen."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from placecat.evaluation.accuracy import confusion_matrix, home_accuracy
from placecat.evaluation.probabilities import log_loss
from placecat.fusion.smoothing import Smoother, SmoothingModel, fit


@dataclass(frozen=True, eq=False)
class TrainingHome:
    """One training home, with what a model says of it that has not seen it.

    Attributes
    ----------
    labels
        (frames,) class indices of all its frames in order of time, -1 for unlabelled.
    sequences
        Stretches of its frames without a cut.
    frame_rate
        Frames a second.
    rows
        (n,) ascending indices of the frames that `proba` is of.
    step
        Frames from one chosen frame to the next, where none between is unlabelled.
    proba
        (n, n_classes) distributions by a model that was trained without the home.
    """

    labels: NDArray[np.int16]
    sequences: Sequence[slice]
    frame_rate: float
    rows: NDArray[np.int64]
    step: int
    proba: NDArray[np.float64]


def judge_smoothing(
    homes: Mapping[str, TrainingHome], n_classes: int, *, smoothing: Mapping[str, Any], smallest: float
) -> dict[str, tuple[float, float]]:
    """Smooth each training home as if it were tested.

    Transitions and emission are counted on the other training homes.

    Parameters
    ----------
    homes
        The training homes of one fold by name, at least two.
    n_classes
        Number of places.
    smoothing
        All settings of :func:`placecat.fusion.smoothing.fit`.
    smallest
        As for :func:`placecat.evaluation.probabilities.log_loss`.

    Returns
    -------
    dict
        For each home its accuracy, the mean over places in percent
        (:func:`placecat.evaluation.accuracy.home_accuracy`), and its log-loss
        (:func:`placecat.evaluation.probabilities.log_loss`), in nats.
    """
    judged = {}
    for name, home in homes.items():
        others = [other for key, other in homes.items() if key != name]
        walks = [(other.labels[part], other.frame_rate) for other in others for part in other.sequences]
        model = fit(
            [labels for labels, _ in walks],
            np.concatenate([other.proba for other in others]),
            np.concatenate([other.labels[other.rows] for other in others]),
            n_classes,
            training_frame_rates=[rate for _, rate in walks],
            **smoothing,
        )
        judged[name] = judge(home.labels[home.rows], _smoothed(model, home), n_classes, smallest)
    return judged


def judge(
    truth: NDArray[np.int16], proba: NDArray[np.float64], n_classes: int, smallest: float
) -> tuple[float, float]:
    """Accuracy in percent (mean over the places) and log-loss (likewise) of one home's frames."""
    confusion = confusion_matrix(truth, proba.argmax(axis=1), n_classes)
    return home_accuracy(confusion), log_loss(truth, proba, smallest=smallest)


def _smoothed(model: SmoothingModel, home: TrainingHome) -> NDArray[np.float64]:
    """(n, n_classes) after the delay; between the chosen frames lies as much time as was filmed."""
    smoothed = np.empty(home.proba.shape)
    for part in home.sequences:
        smoother, last = Smoother(model), None
        for n in np.flatnonzero((home.rows >= part.start) & (home.rows < part.stop)):
            frames = home.step if last is None else int(home.rows[n] - last)
            _, smoothed[n] = smoother.step(home.proba[n], frames / home.frame_rate)
            last = home.rows[n]
    return smoothed
