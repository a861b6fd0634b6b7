"""Values of a setting of the smoothing, judged on training homes that nothing smoothed has seen."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import pandas as pd
from numpy.typing import NDArray

from placecat.evaluation.accuracy import confusion_matrix, home_accuracy
from placecat.evaluation.probabilities import log_loss
from placecat.fusion.smoothing import Smoother, SmoothingModel, fit

COLUMNS = ("setting", "value", "test_home", "training_home", "accuracy", "log_loss")


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


def smoothing_candidates(
    homes: Mapping[str, TrainingHome],
    n_classes: int,
    *,
    test_home: str,
    setting: str,
    values: Sequence[Any],
    smoothing: Mapping[str, Any],
    smallest: float,
) -> pd.DataFrame:
    """Smooth each training home as if it were tested, with each value of a setting.

    Transitions and emission are counted on the other training homes. The test home has no part in it.

    Parameters
    ----------
    homes
        The training homes of one fold by name, at least two.
    n_classes
        Number of places.
    test_home
        Of the fold; for the table only.
    setting
        Of :func:`placecat.fusion.smoothing.fit`, e.g. ``delay_seconds``.
    values
        Its candidates.
    smoothing
        All settings of that function; `setting` is replaced.
    smallest
        As for :func:`placecat.evaluation.probabilities.log_loss`.

    Returns
    -------
    pandas.DataFrame
        A row for each value and training home: `COLUMNS`. ``accuracy`` is the mean over places in percent
        (:func:`placecat.evaluation.accuracy.home_accuracy`), ``log_loss`` that of
        :func:`placecat.evaluation.probabilities.log_loss`, in nats.
    """
    rows = []
    for name, home in homes.items():
        others = [other for key, other in homes.items() if key != name]
        walks = [(other.labels[part], other.frame_rate) for other in others for part in other.sequences]
        for value in values:
            model = fit(
                [labels for labels, _ in walks],
                np.concatenate([other.proba for other in others]),
                np.concatenate([other.labels[other.rows] for other in others]),
                n_classes,
                training_frame_rates=[rate for _, rate in walks],
                **(dict(smoothing) | {setting: value}),
            )
            truth, smoothed = home.labels[home.rows], _smoothed(model, home)
            accuracy = home_accuracy(confusion_matrix(truth, smoothed.argmax(axis=1), n_classes))
            rows.append(
                (setting, value, test_home, name, accuracy, log_loss(truth, smoothed, smallest=smallest))
            )
    return pd.DataFrame(rows, columns=list(COLUMNS))


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
