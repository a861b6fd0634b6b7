"""SVM-DAS, the discriminative accumulation scheme (thesis 3.3.3; Nilsback and Caputo, Pronobis et al.)."""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from placecat import cues
from placecat.cues import CueModel, Descriptors


def concatenate_cues(proba: NDArray[np.float64]) -> NDArray[np.float32]:
    """Lay the cues' distributions side by side.

    Parameters
    ----------
    proba
        (frames, cues, n_classes).

    Returns
    -------
    (frames, cues * n_classes), the descriptor of the integrating classifier.
    """
    return np.ascontiguousarray(proba.reshape(len(proba), -1), dtype=np.float32)


def fit(
    proba: NDArray[np.float64],
    labels: NDArray[np.int16],
    homes: NDArray[np.str_],
    classes: Sequence[str],
    *,
    classifier: Mapping[str, Any],
) -> CueModel:
    """Train the integrating multi-class SVM on the outputs of the cues.

    Parameters
    ----------
    proba
        (n, cues, n_classes) distributions of the cues for training frames.
    labels, homes
        (n,) class index and home of each frame.
    classes
        Names of the places.
    classifier
        As for :func:`placecat.cues.fit`; nu-SVM in the parallel scheme in the thesis.

    Returns
    -------
    CueModel
        Its ``cross_validated`` holds the statistics from which the smoothing takes its emission.
    """
    frames = Descriptors(concatenate_cues(proba))
    return cues.fit(frames, labels, homes, classifier=classifier, classes=classes)


def predict_proba(model: CueModel, proba: NDArray[np.float64]) -> NDArray[np.float64]:
    """Integrate frames: (frames, cues, n_classes) distributions to (frames, n_classes)."""
    return model.predict_proba(Descriptors(concatenate_cues(proba)))
