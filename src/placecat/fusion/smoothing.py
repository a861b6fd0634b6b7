"""Smooth the decisions in a home with the hidden Markov model, and then the delay (thesis 3.4)."""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from placecat.errors import PlacecatError
from placecat.fusion.delay import Delay
from placecat.fusion.hmm import ForwardFilter, emission_matrix, likelihoods, transition_matrix

# Frame times are rounded, so a step counts as 1 if it differs from 1 by less than this.
_ROUNDING = 1e-6


@dataclass(frozen=True)
class SmoothingModel:
    """The statistics of the training homes, and the smoothing settings.

    `transition` and `emission` are (n_classes, n_classes). See `placecat.fusion.hmm` for these and for
    `evidence`. `evidence_seconds` is the longest time for which one frame counts as evidence (see
    :class:`Smoother`). `delay_seconds` is the time constant of :class:`placecat.fusion.delay.Delay`.
    `frame_rate` is the frame rate, in frames per second, to which the transitions apply.
    """

    transition: NDArray[np.float64]
    emission: NDArray[np.float64]
    evidence: str
    evidence_seconds: float
    delay_seconds: float
    frame_rate: float


class Smoother:
    """Smooth one sequence frame by frame. The result for frame t uses only frames up to t.

    Any frame rate works, even one that changes, because transitions, evidence and delay are measured in
    seconds. A frame counts as however many frames would fit into the time since the last one at the model's
    rate. Doubling the rate therefore adds no evidence, because the extra frames only repeat the same views. A
    single frame is not enough evidence for a long gap, so it counts for at most `evidence_seconds`, or for
    one frame at the model's rate if that is longer.
    """

    def __init__(self, model: SmoothingModel) -> None:
        self.model = model
        self._filter = ForwardFilter(model.transition)
        self._delay = Delay(model.delay_seconds)

    def step(
        self, proba: NDArray[np.float64], seconds: float | None = None
    ) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Return the filter's and the delay's distributions for the next frame.

        `proba` is the integrator's (n_classes,) distribution. `seconds` is the time since the last frame, or
        the duration of the first frame. A negative or non-finite time raises PlacecatError. None stands for
        the duration of one frame at the model's rate. Passing that duration explicitly has exactly the same
        effect.
        """
        steps = 1.0
        check_elapsed(seconds)
        if seconds is not None:
            steps = seconds * self.model.frame_rate
            if abs(steps - 1.0) < _ROUNDING:
                steps = 1.0
        likelihood = likelihoods(proba[None], self.model.emission, evidence=self.model.evidence)[0]
        most = max(1.0, self.model.evidence_seconds * self.model.frame_rate)
        filtered = self._filter.step(likelihood, steps=steps, weight=min(steps, most))
        return filtered, self._delay.step(filtered, steps / self.model.frame_rate)


def check_elapsed(seconds: float | None) -> None:
    """Raise PlacecatError if the time between two frames is negative or not finite."""
    if seconds is not None and not (math.isfinite(seconds) and seconds >= 0):
        raise PlacecatError(f"the time between two frames is {seconds:g} s: pass a finite number, 0 or more")


def fit(
    training_sequences: Sequence[NDArray[np.int16]],
    training_proba: NDArray[np.float64],
    training_truth: NDArray[np.int16],
    n_classes: int,
    *,
    training_frame_rates: Sequence[float],
    delay_seconds: float,
    evidence: str,
    evidence_seconds: float,
    reliability: str,
    transition_counts: float,
    emission_counts: float,
) -> SmoothingModel:
    """Estimate the statistics of the training homes.

    The transitions are estimated from `training_sequences`, the labels of the training homes in temporal
    order (-1 for unlabelled frames), and `training_frame_rates`, their frame rates in frames per second. The
    model uses the highest rate (see :func:`placecat.fusion.hmm.transition_matrix`). The emission is estimated
    from `training_proba`, the integrator's cross-validated outputs for the training frames, and
    `training_truth`, the classes of those frames. `delay_seconds` is as in
    :class:`placecat.fusion.delay.Delay`, and `evidence_seconds`, finite and above 0, is as in
    :class:`Smoother`. The other settings are as in `placecat.fusion.hmm`.
    """
    transition = transition_matrix(
        training_sequences, n_classes, frame_rates=training_frame_rates, smoothing=transition_counts
    )
    emission = emission_matrix(
        training_truth, training_proba, n_classes, reliability=reliability, smoothing=emission_counts
    )
    return SmoothingModel(
        transition,
        emission,
        evidence,
        float(evidence_seconds),
        float(delay_seconds),
        max(training_frame_rates),
    )


def apply(
    model: SmoothingModel,
    proba: NDArray[np.float64],
    sequences: Sequence[slice],
    *,
    frame_rate: float,
    times: NDArray[np.float64] | None = None,
) -> dict[str, NDArray[np.float64]]:
    """Smooth one home with a model.

    `proba` contains (frames, n_classes) distributions for all frames of the home, labelled or not.
    `sequences` contains one slice of frames per sequence, and the filter restarts with each slice.
    `frame_rate` is in frames per second. `times` contains (frames,) seconds since the start of the sequence,
    or is None if the frames are evenly spaced. Returns (frames, n_classes) distributions under the keys
    ``hmm`` and ``delayed``.
    """
    filtered, delayed = np.empty(proba.shape), np.empty(proba.shape)
    for part in sequences:
        smoother = Smoother(model)
        steps = np.full(len(proba[part]), 1.0 / frame_rate)
        if times is not None:
            steps[1:] = np.diff(times[part])
        for t, step in zip(range(len(proba))[part], steps.tolist(), strict=True):
            filtered[t], delayed[t] = smoother.step(proba[t], step)
    return {"hmm": filtered, "delayed": delayed}
