"""Cues, which turn a frame's descriptors into a distribution over places (thesis 3.3.1 and 3.3.2).

Each module is one model, such as `one_against_all` (Figure 8, two-class classifiers), `knn` (Figure 8,
modified nearest neighbours) and `joint_probability` (Figure 10). A cue's setting ``classifier.model`` names
its module; a new module needs no registration.
"""

import logging
from collections.abc import Mapping, Sequence
from types import ModuleType
from typing import Any

import numpy as np
from numpy.typing import NDArray

from placecat import lookup, settings
from placecat.cues.codebook import Codebook
from placecat.cues.descriptors import CueModel, Descriptors
from placecat.errors import PlacecatError
from placecat.learning.calibration import CENTRED, CONSECUTIVE, make_folds

logger = logging.getLogger(__name__)

__all__ = ["Codebook", "CueModel", "Descriptors", "cross_validate", "fit", "of_regions_only"]

# Number of parts if frames are left out instead of homes.
_PARTS = 5
# Minimum number of training frames per place in the other homes; calibration needs them.
_LEAST = 2


def fit(
    train: Descriptors,
    labels: NDArray[np.int16],
    homes: NDArray[np.str_],
    *,
    classifier: Mapping[str, Any],
    classes: Sequence[str],
    codebook: Codebook | None = None,
) -> CueModel:
    """Train one cue on the descriptors of training frames.

    `labels` are (n,) class indices in [0, len(classes)); every class must be present. `homes` is (n,), each
    frame's home: cross-validation keeps a home's frames together, since neighbouring frames are
    near-duplicates. ``model`` in `classifier` names a module of this package; the other keys are its
    settings. `codebook` holds clusters from the same training homes, for models that need them. Raises
    PlacecatError for an unknown model, unknown or invalid settings, or a class without training frames.
    """
    missing = sorted(set(range(len(classes))) - set(np.unique(labels).tolist()))
    if missing:
        raise PlacecatError(
            f"training homes {', '.join(sorted(set(homes.tolist())))} have no training frame of "
            f"{classes[missing[0]]}: remove it from dataset.classes, or add homes that show it"
        )
    module = _load(str(settings.get(classifier, "model")))
    options = {name: value for name, value in classifier.items() if name != "model"}
    given, where = (train, labels, homes, codebook, classes), f"classifier {classifier['model']}"
    return settings.call(module.fit, *given, settings=options, where=where)


def cross_validate(
    train: Descriptors,
    labels: NDArray[np.int16],
    homes: NDArray[np.str_],
    *,
    classifier: Mapping[str, Any],
    classes: Sequence[str],
    codebook: Codebook | None = None,
) -> NDArray[np.float64]:
    """Return (n, n_classes) distributions; a cue trained on the other homes predicts each home's frames.

    Parameters and errors are as in :func:`fit`. Everything is refitted for each home, including calibration
    and scaling, so the homes' distributions are comparable. Only the codebook, which uses no labels, is
    shared. If the other homes have fewer than two frames of a place, or there is only one home, a warning is
    logged, and five parts of consecutive frames of each place are left out in turn instead of homes.
    """
    index = labels.astype(np.intp)
    names = np.unique(homes)
    left = [np.bincount(index[homes != home], minlength=len(classes)).min() for home in names]
    if len(names) > 1 and min(left) >= _LEAST:
        folds = make_folds(index, homes, CENTRED, _PARTS)
    else:
        logger.warning(
            "%s: the homes cannot be left out one by one without losing a place; consecutive frames are "
            "left out instead",
            ", ".join(names.tolist()),
        )
        folds = make_folds(index, None, CONSECUTIVE, _PARTS)
    proba = np.empty((len(train), len(classes)))
    for kept, held_out in folds:
        inputs = train.take(kept), labels[kept], homes[kept]
        model = fit(*inputs, classifier=classifier, classes=classes, codebook=codebook)
        proba[held_out] = model.predict_proba(train.take(held_out))
    return proba


def of_regions_only(name: str) -> bool:
    """Return whether a model accepts only sets of regions, never whole frames."""
    return bool(getattr(_load(name), "OF_REGIONS_ONLY", False))


def _load(name: str) -> ModuleType:
    return lookup.module(__name__, name, "classifier.model", "fit")
