"""Integration of cues by one of the ways of thesis 3.3.3: SVM-DAS, or a plain vote."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from placecat.cues import CueModel
from placecat.errors import PlacecatError
from placecat.fusion import das, votes

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
    """

    method: str
    model: CueModel | None

    def predict_proba(self, proba: NDArray[np.float64]) -> NDArray[np.float64]:
        """Fuse (frames, cues, n_classes) distributions to (frames, n_classes); rows sum to 1."""
        if self.model is None:
            return getattr(votes, self.method)(proba)
        return das.predict_proba(self.model, proba)


@dataclass(frozen=True)
class Trained:
    """An integration and what its training has to say.

    Attributes
    ----------
    integrator
        To be applied.
    cross_validated, truth
        (n, n_classes) distributions of the training frames by a model that saw neither the frame nor its
        home, and their (n,) classes; home after home.
    facts
        JSON types only.
    """

    integrator: Integrator
    cross_validated: NDArray[np.float64]
    truth: NDArray[np.int16]
    facts: dict[str, Any]


def fit(
    train: Mapping[str, NDArray[np.float64]],
    truth: Mapping[str, NDArray[np.int16]],
    classes: Sequence[str],
    *,
    method: str,
    classifier: Mapping[str, Any] | None = None,
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

    Raises
    ------
    PlacecatError
        An unknown method.
    """
    if method not in METHODS:
        raise PlacecatError(f"integrator.method {method!r} does not exist: use one of {', '.join(METHODS)}")
    together = np.concatenate(list(train.values()))
    labels = np.concatenate([truth[home] for home in train])
    if method != "das":
        # A vote has nothing to train, so that its statistics need no cross-validation of its own.
        vote = Integrator(method, None)
        return Trained(vote, vote.predict_proba(together), labels, {})
    if classifier is None:
        raise PlacecatError("integrator.classifier is missing: SVM-DAS needs one, such as nu_svm")
    home_of_frame = np.concatenate([np.full(len(proba), home) for home, proba in train.items()])
    model = das.fit(together, labels, home_of_frame, classes, classifier=classifier)
    assert model.cross_validated is not None
    return Trained(Integrator(method, model), model.cross_validated, labels, dict(model.facts))


def integrate(
    train: Mapping[str, NDArray[np.float64]],
    truth: Mapping[str, NDArray[np.int16]],
    test: NDArray[np.float64],
    classes: Sequence[str],
    *,
    method: str,
    classifier: Mapping[str, Any] | None = None,
) -> dict[str, Any]:
    """Train an integration as :func:`fit` does and apply it to a test home.

    Parameters
    ----------
    train, truth, classes, method, classifier
        As for :func:`fit`.
    test
        (frames, cues, n_classes).

    Returns
    -------
    dict
        ``test`` (frames, n_classes); ``cross_validated`` and ``cross_validated_truth`` of the training
        frames, home after home; ``facts`` of the training, JSON types only.

    Raises
    ------
    PlacecatError
        An unknown method.
    """
    trained = fit(train, truth, classes, method=method, classifier=classifier)
    return {
        "facts": trained.facts,
        "test": trained.integrator.predict_proba(test),
        "cross_validated": trained.cross_validated,
        "cross_validated_truth": trained.truth,
    }
