"""Cue integration by SVM-DAS or a vote (thesis 3.3.3), or by a logarithmic opinion pool (our addition).

SVM-DAS is the discriminative accumulation scheme of Nilsback and Caputo, and of Pronobis et al.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from placecat import cues
from placecat.cues import CueModel
from placecat.fusion import log_pool, votes
from placecat.fusion.temperature import temper

METHODS = ("das", "vote_distribution", "vote_decision", "log_pool")


def learns_from_held_out(method: str) -> bool:
    """Return whether a method is trained on frames from homes that the cues have not seen."""
    return method == "log_pool"


@dataclass
class Integrator:
    """A trained integration that uses one of `METHODS`.

    `model` is the classifier that SVM-DAS uses for integration. `weights` are the (cues,) weights of the
    logarithmic opinion pool, and `smallest` is the lower limit of its probabilities
    (:func:`placecat.fusion.log_pool.pool`). Each of these is None for other methods. `temperatures` are
    (cues,) numbers for tempering the cues' distributions before integration
    (:func:`placecat.fusion.temperature.temper`). If they are None, the distributions are used unchanged.
    """

    method: str
    model: CueModel | None
    temperatures: NDArray[np.float64] | None = None
    weights: NDArray[np.float64] | None = None
    smallest: float | None = None

    def predict_proba(self, proba: NDArray[np.float64]) -> NDArray[np.float64]:
        """Fuse (frames, cues, n_classes) distributions into (frames, n_classes); rows sum to 1."""
        if self.temperatures is not None:
            proba = temper(proba, self.temperatures)
        if self.weights is not None:
            return log_pool.pool(proba, self.weights, self.smallest or log_pool.SMALLEST)
        if self.model is None:
            return getattr(votes, self.method)(proba)
        return self.model.predict_proba(_joined(proba))


@dataclass(frozen=True)
class Trained:
    """A trained integration, and JSON-compatible facts about its training.

    `cross_validated` contains (n, n_classes) distributions for the training frames, home by home, or is None
    if they were not requested. Each comes from a model that saw neither the frame nor its home. `truth`
    contains the (n,) class indices of these frames.
    """

    integrator: Integrator
    cross_validated: NDArray[np.float64] | None
    truth: NDArray[np.int16]
    facts: dict[str, Any]


def fit(
    train: Mapping[str, NDArray[np.float64]],
    truth: Mapping[str, NDArray[np.int16]],
    classes: Sequence[str],
    *,
    method: str,
    classifier: Mapping[str, Any] | None = None,
    shrinkage: float = 0.0,
    smallest: float = log_pool.SMALLEST,
    temperatures: Sequence[float] | None = None,
    cross_validated: bool = True,
) -> Trained:
    """Train an integration on the cues' outputs for the training homes.

    Parameters
    ----------
    train
        Maps each home to the cues' (n, cues, n_classes) distributions for its training frames. If
        :func:`learns_from_held_out` is true for the method, the cues must not have seen the home.
    truth
        Maps each home to the (n,) class indices of the same frames. It may contain additional homes.
    classes, method
        Names of the places, and one of `METHODS`, where ``das`` stands for SVM-DAS.
    classifier
        Classifier for SVM-DAS, as in :func:`placecat.cues.fit`.
    shrinkage, smallest
        Settings for the logarithmic opinion pool, as in :func:`placecat.fusion.log_pool.fit_weights`.
    temperatures
        One per cue, as in :class:`Integrator`.
    cross_validated
        Whether to predict each home's frames with an integration trained on the other homes. The logarithmic
        opinion pool always does so.
    """
    together = np.concatenate(list(train.values()))
    labels = np.concatenate([truth[home] for home in train])
    own = None if temperatures is None else np.asarray(temperatures, dtype=np.float64)
    homes = np.concatenate([np.full(len(proba), home) for home, proba in train.items()])
    tempered = together if own is None else temper(together, own)
    if method == "log_pool":
        return _fit_pool(tempered, labels, homes, own, shrinkage, smallest)
    if method != "das":
        # Votes are not trained, so their statistics need no cross-validation.
        vote = Integrator(method, None, own)
        return Trained(vote, vote.predict_proba(together) if cross_validated else None, labels, {})
    assert classifier is not None
    frames = _joined(tempered)
    model = cues.fit(frames, labels, homes, classifier=classifier, classes=classes)
    held_out = None
    if cross_validated:
        held_out = cues.cross_validate(frames, labels, homes, classifier=classifier, classes=classes)
    return Trained(Integrator(method, model, own), held_out, labels, dict(model.facts))


def _joined(proba: NDArray[np.float64]) -> cues.Descriptors:
    """Reshape (frames, cues, n_classes) to (frames, cues * n_classes) float32, as input for SVM-DAS."""
    return cues.Descriptors(np.ascontiguousarray(proba.reshape(len(proba), -1), dtype=np.float32))


def _fit_pool(
    proba: NDArray[np.float64],
    labels: NDArray[np.int16],
    homes: NDArray[np.str_],
    temperatures: NDArray[np.float64] | None,
    shrinkage: float,
    smallest: float,
) -> Trained:
    """Fit a logarithmic opinion pool, and cross-validate each home using weights from the others."""
    settings = {"shrinkage": shrinkage, "smallest": smallest}
    weights = log_pool.fit_weights(proba, labels, homes, **settings)
    held_out = np.empty((len(proba), proba.shape[2]))
    for home in np.unique(homes):
        own = homes == home
        of_others = log_pool.fit_weights(proba[~own], labels[~own], homes[~own], **settings)
        held_out[own] = log_pool.pool(proba[own], of_others, smallest)
    integrator = Integrator("log_pool", None, temperatures, weights, smallest)
    return Trained(integrator, held_out, labels, {"weights": weights.tolist()})
