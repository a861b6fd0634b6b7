"""Integration of cues by one of the ways of thesis 3.3.3: SVM-DAS, or a plain vote."""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from placecat.errors import PlacecatError
from placecat.fusion import das, votes

METHODS = ("das", "vote_distribution", "vote_decision")


def integrate(
    train: Mapping[str, NDArray[np.float64]],
    truth: Mapping[str, NDArray[np.int16]],
    test: NDArray[np.float64],
    classes: Sequence[str],
    *,
    method: str,
    classifier: Mapping[str, Any] | None = None,
) -> dict[str, Any]:
    """Train an integration on the cues' outputs for training homes; apply it to a test home.

    Parameters
    ----------
    train
        Home to (n, cues, n_classes) distributions of the cues for its training frames.
    truth
        Home to (n,) class indices of the same frames; may hold more homes.
    test
        (frames, cues, n_classes).
    classes
        Names of the places.
    method
        ``das`` (SVM-DAS), ``vote_distribution`` or ``vote_decision``.
    classifier
        Of SVM-DAS, as for :func:`placecat.cues.fit`.

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
    if method not in METHODS:
        raise PlacecatError(f"integrator.method {method!r} does not exist: use one of {', '.join(METHODS)}")
    together = np.concatenate(list(train.values()))
    labels = np.concatenate([truth[home] for home in train])
    if method != "das":
        vote = getattr(votes, method)
        # A vote has nothing to train, so that its statistics need no cross-validation of its own.
        return {
            "facts": {},
            "test": vote(test),
            "cross_validated": vote(together),
            "cross_validated_truth": labels,
        }
    if classifier is None:
        raise PlacecatError("integrator.classifier is missing: SVM-DAS needs one, such as nu_svm")
    home_of_frame = np.concatenate([np.full(len(proba), home) for home, proba in train.items()])
    model = das.fit(together, labels, home_of_frame, classes, classifier=classifier)
    assert model.cross_validated is not None
    return {
        "facts": dict(model.facts),
        "test": das.predict_proba(model, test),
        "cross_validated": model.cross_validated,
        "cross_validated_truth": labels,
    }
