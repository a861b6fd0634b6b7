"""Integration of cues: SVM-DAS, a plain vote (thesis 3.3.3) or, an addition, a logarithmic opinion pool."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from placecat import cues
from placecat.cues import CueModel
from placecat.errors import PlacecatError
from placecat.fusion import das, log_pool, votes
from placecat.fusion.temperature import temper

METHODS = ("das", "vote_distribution", "vote_decision", "log_pool")


def learns_from_held_out(method: str) -> bool:
    """Tell whether a method learns from outputs for homes that the cues have not seen."""
    return method == "log_pool"


@dataclass
class Integrator:
    """A trained integration.

    Attributes
    ----------
    method
        One of `METHODS`.
    model
        The integrating classifier of SVM-DAS; None for the others.
    temperatures
        (cues,) what the cues' distributions are tempered with before, see
        :func:`placecat.fusion.temperature.temper`; None to take them as they are.
    weights
        (cues,) of the logarithmic opinion pool; None for the others.
    """

    method: str
    model: CueModel | None
    temperatures: NDArray[np.float64] | None = None
    weights: NDArray[np.float64] | None = None

    def predict_proba(self, proba: NDArray[np.float64]) -> NDArray[np.float64]:
        """Fuse (frames, cues, n_classes) distributions to (frames, n_classes); rows sum to 1."""
        if self.temperatures is not None:
            proba = temper(proba, self.temperatures)
        if self.weights is not None:
            return log_pool.pool(proba, self.weights)
        if self.model is None:
            return getattr(votes, self.method)(proba)
        return self.model.predict_proba(das.frames_of(proba))


@dataclass(frozen=True)
class Trained:
    """An integration and what its training has to say.

    Attributes
    ----------
    integrator
        To be applied.
    cross_validated, truth
        (n, n_classes) distributions of the training frames by a model that saw neither the frame nor its
        home, None if not asked for, and their (n,) classes; home after home.
    facts
        JSON types only.
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
    temperatures: Sequence[float] | None = None,
    cross_validated: bool = True,
) -> Trained:
    """Train an integration on the cues' outputs for training homes.

    Parameters
    ----------
    train
        Home to (n, cues, n_classes) distributions of the cues for its training frames. A method for which
        :func:`learns_from_held_out` is true needs those of cues that have not seen the home.
    truth
        Home to (n,) class indices of the same frames; may hold more homes.
    classes
        Names of the places.
    method
        ``das`` (SVM-DAS), ``vote_distribution``, ``vote_decision`` or ``log_pool``.
    classifier
        Of SVM-DAS, as for :func:`placecat.cues.fit`.
    shrinkage
        Of the logarithmic opinion pool, as for :func:`placecat.fusion.log_pool.fit_weights`.
    temperatures
        Of each cue, as for :class:`Integrator`.
    cross_validated
        Whether each home's frames are judged by an integration of the others as well.

    Raises
    ------
    PlacecatError
        An unknown method.
    """
    if method not in METHODS:
        raise PlacecatError(f"integrator.method {method!r} does not exist: use one of {', '.join(METHODS)}")
    together = np.concatenate(list(train.values()))
    labels = np.concatenate([truth[home] for home in train])
    own = None if temperatures is None else np.asarray(temperatures, dtype=np.float64)
    homes = np.concatenate([np.full(len(proba), home) for home, proba in train.items()])
    if method == "log_pool":
        return _fit_pool(together if own is None else temper(together, own), labels, homes, own, shrinkage)
    if method != "das":
        # A vote has nothing to train, so that its statistics need no cross-validation of its own.
        vote = Integrator(method, None, own)
        return Trained(vote, vote.predict_proba(together) if cross_validated else None, labels, {})
    if classifier is None:
        raise PlacecatError("integrator.classifier is missing: SVM-DAS needs one, such as nu_svm")
    frames = das.frames_of(together if own is None else temper(together, own))
    model = cues.fit(frames, labels, homes, classifier=classifier, classes=classes)
    held_out = None
    if cross_validated:
        held_out = cues.cross_validate(frames, labels, homes, classifier=classifier, classes=classes)
    return Trained(Integrator(method, model, own), held_out, labels, dict(model.facts))


def _fit_pool(
    proba: NDArray[np.float64],
    labels: NDArray[np.int16],
    homes: NDArray[np.str_],
    temperatures: NDArray[np.float64] | None,
    shrinkage: float,
) -> Trained:
    """A logarithmic opinion pool; each home's frames are judged by the weights of the others."""
    weights = log_pool.fit_weights(proba, labels, homes, shrinkage=shrinkage)
    held_out = np.empty((len(proba), proba.shape[2]))
    for home in np.unique(homes):
        own = homes == home
        of_others = log_pool.fit_weights(proba[~own], labels[~own], homes[~own], shrinkage=shrinkage)
        held_out[own] = log_pool.pool(proba[own], of_others)
    integrator = Integrator("log_pool", None, temperatures, weights)
    return Trained(integrator, held_out, labels, {"weights": weights.tolist()})
