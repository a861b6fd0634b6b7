"""Smoothing of a home's decisions: the hidden Markov model, then the delay (thesis 3.4)."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from placecat.fusion.delay import delay
from placecat.fusion.hmm import emission_matrix, forward_filter, likelihoods, transition_matrix


def smooth(
    proba: NDArray[np.float64],
    sequences: Sequence[slice],
    *,
    training_sequences: Sequence[NDArray[np.int16]],
    training_proba: NDArray[np.float64],
    training_truth: NDArray[np.int16],
    n_classes: int,
    delay_step: float,
    evidence: str,
    reliability: str,
    transition_counts: float,
    emission_counts: float,
) -> dict[str, NDArray[np.float64]]:
    """Smooth one home with statistics of its training homes.

    Parameters
    ----------
    proba
        (frames, n_classes) distributions for every frame of the home, labelled or not.
    sequences
        Stretches of frames without a cut; the filter starts anew at each.
    training_sequences
        Labels of the training homes in order of time, -1 for unlabelled: the transitions are counted on them.
    training_proba, training_truth
        Cross-validated outputs of the integrator on training frames: the emission is counted on them.
    delay_step
        h of equation (16).
    evidence, reliability, transition_counts, emission_counts
        See `placecat.fusion.hmm`.

    Returns
    -------
    dict
        ``hmm`` and ``delayed``, each (frames, n_classes); rows sum to 1.
    """
    transition = transition_matrix(training_sequences, n_classes, smoothing=transition_counts)
    emission = emission_matrix(
        training_truth, training_proba, n_classes, reliability=reliability, smoothing=emission_counts
    )
    likelihood = likelihoods(proba, emission, evidence=evidence)
    filtered = np.empty_like(likelihood)
    delayed = np.empty_like(likelihood)
    for part in sequences:
        filtered[part] = forward_filter(likelihood[part], transition)
        delayed[part] = delay(filtered[part], step=delay_step)
    return {"hmm": filtered, "delayed": delayed}
