"""The two simple voting schemes from thesis 3.3.3, as baselines for the SVM integration."""

import numpy as np
from numpy.typing import NDArray


def vote_distribution(proba: NDArray[np.float64]) -> NDArray[np.float64]:
    """Average the cues' distributions, so that every cue votes with its full distribution.

    `proba` is (frames, cues, n_classes); the result is (frames, n_classes).
    """
    return np.asarray(proba, dtype=np.float64).mean(axis=1)


def vote_decision(proba: NDArray[np.float64]) -> NDArray[np.float64]:
    """Let every cue vote only for its most probable class, weighted by the probability of that class.

    `proba` is (frames, cues, n_classes); the result is (frames, n_classes), and its rows sum to 1.
    """
    proba = np.asarray(proba, dtype=np.float64)
    decided = np.eye(proba.shape[2])[np.argmax(proba, axis=2)]
    votes = (decided * proba.max(axis=2, keepdims=True)).sum(axis=1)
    return votes / votes.sum(axis=1, keepdims=True)
