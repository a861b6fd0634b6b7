"""Read the labels of footage, and compare a prediction with them."""

from collections.abc import Collection, Sequence
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from placecat.errors import PlacecatError, reading
from placecat.evaluation.accuracy import class_accuracies, confusion_matrix, home_accuracy
from placecat.evaluation.selection import decided, select
from placecat.footage.timing import Timing
from placecat.predict.prediction import Prediction
from placecat.sequences.labels import read_label_csv

UNSCORED = "transition"
"""Label for frames between places, allowed in any label file."""


def read(path: Path, timing: Timing, classes: Sequence[str], ignored: Collection[str]) -> NDArray[np.int16]:
    """Read the labels of all frames with `placecat.sequences.labels.read_label_csv`.

    Frames whose label is `UNSCORED` or in `ignored` are not scored. Returns (frames,) int16 indices into the
    model's `classes`, or -1 for unscored frames. Raises PlacecatError if the file is missing or does not
    match the frame times, or if a label is neither a class nor ignored.
    """
    with reading(path):
        if not path.is_file():
            raise PlacecatError(f"{path}: the label file is missing; correct --labels, or leave it out")
    labels, lines = read_label_csv(path, timing, "the footage")
    numbers = {UNSCORED: -1} | dict.fromkeys(ignored, -1) | {name: i for i, name in enumerate(classes)}
    for label, line in zip(labels, lines, strict=True):
        if label not in numbers:
            raise PlacecatError(
                f"{path} line {line}: {label!r} is not one of the model's places ({', '.join(classes)}): "
                f"correct the label, or exclude such frames from scoring with --ignore {label}"
            )
    return np.array([numbers[label] for label in labels], dtype=np.int16)


def agreement(prediction: Prediction, truth: NDArray[np.int16]) -> dict[str, object]:
    """Score the categorized frames the same way as the frames of a home (thesis 4.2).

    `truth` contains the (n,) class indices of these frames, or -1 for unscored frames.

    In the returned dictionary, ``accuracy`` is the accuracy of the decisions, and ``frame_accuracy`` is that
    of each frame alone. Both are means over the labelled places, in percent, or None if nothing is scored.
    ``by_place`` contains the percentage of correct frames for each place. ``confusion`` contains counts, with
    one row per true place. ``named`` is the percentage of scored frames that are not unknown, and
    ``named_wrongly`` is the percentage of these that are wrong. Both weight all places equally.
    """
    n_classes = len(prediction.classes)
    confusion = confusion_matrix(truth, prediction.decision, n_classes)
    alone = confusion_matrix(truth, prediction.frame_decision, n_classes)
    named = select([decided(truth, prediction.proba)], [prediction.threshold])
    places = zip(prediction.classes, class_accuracies(confusion).tolist(), strict=True)
    return {
        "accuracy": _rounded(home_accuracy(confusion)),
        "frame_accuracy": _rounded(home_accuracy(alone)),
        "by_place": {name: _rounded(value) for name, value in places},
        "confusion": confusion.tolist(),
        "named": _rounded(100 * named.coverage),
        "named_wrongly": _rounded(100 * named.risk),
    }


def _rounded(percent: float) -> float | None:
    return round(percent, 2) if np.isfinite(percent) else None
