"""Smoothing of a home's decisions: the hidden Markov model, then the delay (thesis 3.4)."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from placecat.fusion.delay import Delay
from placecat.fusion.hmm import ForwardFilter, emission_matrix, likelihoods, transition_matrix


@dataclass(frozen=True)
class SmoothingModel:
    """The statistics of training homes that the smoothing needs.

    Attributes
    ----------
    transition, emission
        (n_classes, n_classes), see `placecat.fusion.hmm`.
    evidence
        See :func:`placecat.fusion.hmm.likelihoods`.
    delay_step
        h of equation (16).
    """

    transition: NDArray[np.float64]
    emission: NDArray[np.float64]
    evidence: str
    delay_step: float


class Smoother:
    """Smooth one sequence, frame by frame; frame t uses frames up to t only."""

    def __init__(self, model: SmoothingModel) -> None:
        self.model = model
        self._filter = ForwardFilter(model.transition)
        self._delay = Delay(model.delay_step)

    def step(self, proba: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Take the next frame's distribution (n_classes,); give those of the filter and of the delay."""
        likelihood = likelihoods(proba[None], self.model.emission, evidence=self.model.evidence)[0]
        filtered = self._filter.step(likelihood)
        return filtered, self._delay.step(filtered)


def fit(
    training_sequences: Sequence[NDArray[np.int16]],
    training_proba: NDArray[np.float64],
    training_truth: NDArray[np.int16],
    n_classes: int,
    *,
    delay_step: float,
    evidence: str,
    reliability: str,
    transition_counts: float,
    emission_counts: float,
) -> SmoothingModel:
    """Count the statistics of training homes.

    Parameters
    ----------
    training_sequences
        Labels of the training homes in order of time, -1 for unlabelled: the transitions are counted on them.
    training_proba, training_truth
        Cross-validated outputs of the integrator on training frames: the emission is counted on them.
    delay_step
        h of equation (16).
    evidence, reliability, transition_counts, emission_counts
        See `placecat.fusion.hmm`.
    """
    transition = transition_matrix(training_sequences, n_classes, smoothing=transition_counts)
    emission = emission_matrix(
        training_truth, training_proba, n_classes, reliability=reliability, smoothing=emission_counts
    )
    return SmoothingModel(transition, emission, evidence, delay_step)


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
    training_sequences, training_proba, training_truth, delay_step, evidence, reliability, \
transition_counts, emission_counts
        As for :func:`fit`.

    Returns
    -------
    dict
        ``hmm`` and ``delayed``, each (frames, n_classes); rows sum to 1.
    """
    model = fit(
        training_sequences,
        training_proba,
        training_truth,
        n_classes,
        delay_step=delay_step,
        evidence=evidence,
        reliability=reliability,
        transition_counts=transition_counts,
        emission_counts=emission_counts,
    )
    filtered, delayed = np.empty(proba.shape), np.empty(proba.shape)
    for part in sequences:
        smoother = Smoother(model)
        for t in range(len(proba))[part]:
            filtered[t], delayed[t] = smoother.step(proba[t])
    return {"hmm": filtered, "delayed": delayed}
