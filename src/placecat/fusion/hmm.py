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
    """Estimate transition probabilities from training sequences, at the highest of their frame rates.

    Transitions between successive labelled frames are counted. Unlabelled frames (-1) are skipped, so a walk
    from the kitchen through a corridor to the bedroom counts once as kitchen to bedroom. A sequence with a
    lower frame rate counts as if its frames were repeated: the camera changes place as often but stays for
    proportionally more frames.

    `sequences` holds (frames,) class indices in temporal order, -1 for unlabelled frames. `frame_rates` are
    in frames per second, above 0; None if they are all equal. `smoothing` (not given in the thesis) is added
    to every count; without it, a transition never seen in training could never happen. Returns (n_classes,
    n_classes): row q', column q is p(l_t = q | l_{t-1} = q'). Rows sum to 1.
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
    """Estimate p(o | l), how the integrator decides in each place, from its cross-validated outputs.

    `truth` holds the (n,) class indices of training frames. `proba` holds the integrator's (n, n_classes)
    distributions, each from a model that saw neither the frame nor its home. `reliability` "hard" counts the
    decisions (arg-max), "soft" adds up the distributions; `smoothing`, above 0, is added to every count. The
    thesis gives neither setting. Returns (n_classes, n_classes): row q, column o is p(o | l = q). Rows sum to
    1.
    """
    if reliability == "hard":
        answers = np.eye(n_classes)[np.argmax(proba, axis=1)]
    else:
        answers = np.asarray(proba, dtype=np.float64)
    counts = np.full((n_classes, n_classes), float(smoothing))
    np.add.at(counts, truth.astype(np.int64), answers)
    return counts / counts.sum(axis=1, keepdims=True)


def likelihoods(proba: Float, emission: Float, *, evidence: str = "hard") -> Float:
    """Return each observation's likelihood in each place, p(o_t | l_t = q): (frames, n_classes).

    `proba` holds the integrator's (frames, n_classes) distributions; `emission` comes from
    :func:`emission_matrix`. The result is positive wherever the emission is positive. With `evidence` "hard"
    the observation is the decision, p(o_t | q) = emission[q, argmax]. With "soft" the decision is uncertain,
    p(o_t | q) = sum_o emission[q, o] proba[o], as equation (6) treats the outputs of the two-class
    classifiers. The thesis does not say which it uses.
    """
    if evidence == "hard":
        return emission.T[np.argmax(proba, axis=1)]
    return sum_products(np.asarray(proba, dtype=np.float64), emission)


class ForwardFilter:
    """Filter one sequence forwards, frame by frame: equation (13). Frame t uses only frames up to t.

    `transition` is (n_classes, n_classes), from one frame to the next at its frame rate; rows sum to 1. The
    distribution of the first place is uniform (not given in the thesis).
    """

    def __init__(self, transition: Float) -> None:
        self._transitions = TransitionPower(transition)
        self._filtered: Float | None = None

    def step(self, likelihood: Float, *, steps: float = 1.0, weight: float = 1.0) -> Float:
        """Return p(l_t = q | o_1 .. o_t), (n_classes,), for the next frame.

        `likelihood` is (n_classes,) p(o_t | l_t = q), 0 or more, at least one above 0. `steps` is the time
        since the last frame, 0 or more, in steps of the transition matrix: places change with P^steps.
        `weight`, the likelihood's exponent, is the number of frames that this frame counts as, 0 or more.
        With `steps` and `weight` 1, this is exactly equation (13).
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
