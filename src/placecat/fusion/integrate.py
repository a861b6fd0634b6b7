"""Integration of cues by one of the ways of thesis 3.3.3: SVM-DAS, or a plain vote."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from placecat import cues
from placecat.cues import CueModel
from placecat.errors import PlacecatError
from placecat.fusion import das, votes
from placecat.fusion.temperature import temper

METHODS = ("das", "vote_distribution", "vote_decision")


@dataclass
class Integrator:
    """A trained integration.

    Attributes
    ----------
    method
        One of `METHODS`.
    model
        The integrating classifier of SVM-DAS; None for a vote.
    temperatures
        (cues,) what the cues' distributions are tempered with before, see
        :func:`placecat.fusion.temperature.temper`; None to take them as they are.
    """

    method: str
    model: CueModel | None
    temperatures: NDArray[np.float64] | None = None

    def predict_proba(self, proba: NDArray[np.float64]) -> NDArray[np.float64]:
        """Fuse (frames, cues, n_classes) distributions to (frames, n_classes); rows sum to 1."""
        if self.temperatures is not None:
            proba = temper(proba, self.temperatures)
        if self.model is None:
            return getattr(votes, self.method)(proba)
        return self.model.predict_proba(das.frames_of(proba))


@dataclass(frozen=True)
class Trained:
    """An integration and facts of its training.

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
    temperatures: Sequence[float] | None = None,
    cross_validated: bool = True,
) -> Trained:
    """Train an integration on the cues' outputs for training homes.

    Parameters
    ----------
    train
        Home to (n, cues, n_classes) distributions of the cues for its training frames.
    truth
        Home to (n,) class indices of the same frames; may hold more homes.
    classes
        Names of the places.
    method
        ``das`` (SVM-DAS), ``vote_distribution`` or ``vote_decision``.
    classifier
        Of SVM-DAS, as for :func:`placecat.cues.fit`.
    temperatures
        Of each cue, as for :class:`Integrator`.
    cross_validated
        Whether to judge each home's frames by an integration of the others as well.
    """
    if method not in METHODS:
        raise PlacecatError(f"integrator.method {method!r} does not exist: use one of {', '.join(METHODS)}")
    together = np.concatenate(list(train.values()))
    labels = np.concatenate([truth[home] for home in train])
    own = None if temperatures is None else np.asarray(temperatures, dtype=np.float64)
    if method != "das":
        # A vote has nothing to train, so its statistics need no cross-validation.
        vote = Integrator(method, None, own)
        return Trained(vote, vote.predict_proba(together) if cross_validated else None, labels, {})
    if classifier is None:
        raise PlacecatError("integrator.classifier is missing: SVM-DAS needs one, such as nu_svm")
    homes = np.concatenate([np.full(len(proba), home) for home, proba in train.items()])
    frames = das.frames_of(together if own is None else temper(together, own))
    model = cues.fit(frames, labels, homes, classifier=classifier, classes=classes)
    held_out = None
    if cross_validated:
        held_out = cues.cross_validate(frames, labels, homes, classifier=classifier, classes=classes)
    return Trained(Integrator(method, model, own), held_out, labels, dict(model.facts))
