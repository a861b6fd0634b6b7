"""Cues, which turn a frame's descriptors into a distribution over places (thesis 3.3.1 and 3.3.2).

Each module defines one model, such as `one_against_all` (Figure 8, two-class classifiers), `knn` (Figure 8,
modified nearest neighbours) and `joint_probability` (Figure 10). The setting ``classifier.model`` of a cue
names its module. New modules do not need to be registered.
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

# Number of parts to split the frames into if homes cannot be left out.
_PARTS = 5
# Calibration needs at least this many training frames of each place in the other homes.
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
    """Train one cue on the descriptors of the training frames.

    `labels` are (n,) class indices in [0, len(classes)), and every class must occur. `homes` (n,) is the home
    of each frame. Cross-validation keeps the frames of a home together, because neighbouring frames are
    almost identical. In `classifier`, ``model`` names a module of this package, and the other keys are
    settings of that module. A model that needs clusters takes them from `codebook`, which must be trained on
    the same homes. Raises PlacecatError for an unknown model, unknown or invalid settings, or a class without
    training frames.
    """
    missing = sorted(set(range(len(classes))) - set(np.unique(labels).tolist()))
    if missing:
        raise PlacecatError(
            f"the training homes {', '.join(sorted(set(homes.tolist())))} have no training frames of "
            f"{classes[missing[0]]}: remove this place from dataset.classes, or add homes that contain it"
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
    """Predict the frames of each home with a cue trained on the other homes.

    Takes the same parameters and raises the same errors as :func:`fit`. Returns (n, n_classes) distributions.
    Everything, including calibration and scaling, is refitted for each home, so that distributions can be
    compared across homes. Only the codebook, which uses no labels, is shared. If there is only one home, or
    if leaving one out would leave fewer than two frames of a place, a warning is logged. In that case, the
    frames of each place are split into five consecutive parts, which are left out instead of homes.
    """
    index = labels.astype(np.intp)
    names = np.unique(homes)
    left = [np.bincount(index[homes != home], minlength=len(classes)).min() for home in names]
    if len(names) > 1 and min(left) >= _LEAST:
        folds = make_folds(index, homes, CENTRED, _PARTS)
    else:
        logger.warning(
            "%s: homes cannot be left out, because too few of them contain every place; consecutive frames "
            "are left out instead",
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
