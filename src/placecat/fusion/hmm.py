"""The hidden Markov model that smooths a sequence of decisions (thesis 3.4, equation 13)."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from placecat.fusion.transition_power import TransitionPower
from placecat.learning.products import sum_products

Float = NDArray[np.float64]


def transition_matrix(
    sequences: Sequence[NDArray[np.int16]],
    n_classes: int,
    *,
    frame_rates: Sequence[float] | None = None,
    smoothing: float = 1.0,
) -> Float:
    """Estimate transition probabilities at the highest frame rate of the training sequences.

    Transitions between successive labelled frames are counted. Unlabelled frames (-1) are skipped, so a walk
    from the kitchen through a corridor to the bedroom counts once as a transition from kitchen to bedroom. A
    sequence with a lower frame rate counts as if its frames were repeated: it has the same number of place
    changes, but proportionally more frames without one.

    Each of the `sequences` contains (frames,) class indices in temporal order, with -1 for unlabelled frames.
    `frame_rates` are in frames per second, above 0, or None if they are all equal. `smoothing` is added to
    every count, so that transitions not seen in training still have a probability above 0. The thesis does
    not specify its value. Returns an (n_classes, n_classes) matrix with p(l_t = q | l_{t-1} = q') in row q'
    and column q. Rows sum to 1.
    """
    counts = np.full((n_classes, n_classes), float(smoothing))
    rates = [1.0] * len(sequences) if frame_rates is None else frame_rates
    for labels, rate in zip(sequences, rates, strict=True):
        labelled = labels[labels >= 0].astype(np.int64)
        own = np.zeros((n_classes, n_classes))
        np.add.at(own, (labelled[:-1], labelled[1:]), 1.0)
        steps, stays = own.sum(axis=1), np.diagonal(own).copy()
        np.fill_diagonal(own, steps * (max(rates) / rate) - (steps - stays))
        counts += own
    return counts / counts.sum(axis=1, keepdims=True)


def emission_matrix(
    truth: NDArray[np.int16],
    proba: Float,
    n_classes: int,
    *,
    reliability: str = "hard",
    smoothing: float = 1.0,
) -> Float:
    """Estimate p(o | l), the probability of each decision o in each place l, from cross-validated outputs.

    `truth` contains the (n,) class indices of the training frames. `proba` contains the integrator's (n,
    n_classes) distributions, each from a model that saw neither the frame nor its home. If `reliability` is
    "hard", decisions (the most probable classes) are counted. If it is "soft", the distributions are summed.
    `smoothing`, above 0, is added to every count. The thesis specifies neither setting. Returns an
    (n_classes, n_classes) matrix with p(o | l = q) in row q and column o. Rows sum to 1.
    """
    if reliability == "hard":
        answers = np.eye(n_classes)[np.argmax(proba, axis=1)]
    else:
        answers = np.asarray(proba, dtype=np.float64)
    counts = np.full((n_classes, n_classes), float(smoothing))
    np.add.at(counts, truth.astype(np.int64), answers)
    return counts / counts.sum(axis=1, keepdims=True)


def likelihoods(proba: Float, emission: Float, *, evidence: str = "hard") -> Float:
    """Return the (frames, n_classes) likelihoods p(o_t | l_t = q) of the observations in each place.

    `proba` contains the integrator's (frames, n_classes) distributions, and `emission` comes from
    :func:`emission_matrix`. The result is positive wherever the emission is positive. If `evidence` is
    "hard", the observation is the decision, so p(o_t | q) = emission[q, argmax]. If it is "soft", the
    decision is uncertain, so p(o_t | q) = sum_o emission[q, o] proba[o]. Equation (6) treats the outputs of
    the two-class classifiers the same way. The thesis does not say which kind of evidence it uses.
    """
    if evidence == "hard":
        return emission.T[np.argmax(proba, axis=1)]
    return sum_products(np.asarray(proba, dtype=np.float64), emission)


class ForwardFilter:
    """Filter one sequence forwards, frame by frame, using equation (13).

    The result for frame t uses only frames up to t. `transition` contains the (n_classes, n_classes)
    transition probabilities from one frame to the next, at the frame rate for which they were estimated. Each
    row sums to 1. The initial distribution over places is uniform, because the thesis does not specify one.
    """

    def __init__(self, transition: Float) -> None:
        self._transitions = TransitionPower(transition)
        self._filtered: Float | None = None

    def step(self, likelihood: Float, *, steps: float = 1.0, weight: float = 1.0) -> Float:
        """Return the (n_classes,) distribution p(l_t = q | o_1 .. o_t) for the next frame.

        `likelihood` contains the (n_classes,) values p(o_t | l_t = q). None may be negative, and at least one
        must be positive. `steps` is the time since the last frame, 0 or more, in steps of the transition
        matrix P. The place changes according to P^steps. `weight`, 0 or more, is the number of frames that
        this one counts as. The likelihood is raised to this power. If `steps` and `weight` are both 1, this
        is exactly equation (13).
        """
        if self._filtered is None:
            predicted = np.full(len(likelihood), 1.0 / len(likelihood))
        else:
            predicted = self._filtered @ self._transitions(steps)
        if weight != 1.0:
            # Dividing by the maximum keeps high powers above 0.
            likelihood = (likelihood / likelihood.max()) ** weight
        joint = likelihood * predicted
        filtered: Float = joint / joint.sum()
        self._filtered = filtered
        return filtered
