"""The interface of a trained cue."""

from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from placecat.cues.descriptors import Descriptors


class CueModel(Protocol):
    """A trained cue; `facts` describes its training, e.g. the feasible nu, with JSON types only."""

    facts: dict[str, Any]

    def predict_proba(self, frames: Descriptors) -> NDArray[np.float64]:
        """Return (n, n_classes) distributions over places; rows sum to 1."""
        ...


def product_of_rows(
    log_proba: NDArray[np.float64], frame_of_row: NDArray[np.int64], n_frames: int
) -> NDArray[np.float64]:
    """Multiply and normalise the distributions of each frame's regions (thesis 3.3.1 and 4.4.1).

    `log_proba` holds the (rows, n_classes) log-probabilities of the regions, and `frame_of_row` the (rows,)
    frame index of each region. Returns (n_frames, n_classes); uniform for a frame without regions.
    """
    total = np.zeros((n_frames, log_proba.shape[1]))
    np.add.at(total, frame_of_row, log_proba)
    return normalize_log(total)


def normalize_log(log_proba: NDArray[np.float64]) -> NDArray[np.float64]:
    """Exponentiate and normalise rows of log-probabilities without underflow."""
    proba = np.exp(log_proba - log_proba.max(axis=1, keepdims=True))
    return proba / proba.sum(axis=1, keepdims=True)
