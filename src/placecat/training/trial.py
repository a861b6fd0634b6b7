"""Train cues according to a plan, and count their decisions on the test sequence."""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from placecat.cues import Codebook, Descriptors
from placecat.errors import NotComputable
from placecat.evaluation.accuracy import confusion_matrix
from placecat.learning.memory import remembering
from placecat.training import store
from placecat.training.cue import Cue, TrainingFrames, cluster, fit, read_frames
from placecat.training.plan import Plan

# Decision counts (rows are true places), or the reason why they are missing, and facts about the model.
Outcome = tuple[NDArray[np.int64] | str, Mapping[str, Any]]
# (frames, classes) distributions, or the reason why they are missing, and facts about the model.
Prediction = tuple[NDArray[np.float64] | str, Mapping[str, Any]]


def of_settings(settings: Mapping[str, Any]) -> Cue:
    """Read a trial's settings: ``descriptor``, ``classifier`` and, if there is one, ``codebook``."""
    return Cue(settings["descriptor"], settings["classifier"], settings.get("codebook"))


def judge(plan: Plan, cues: Sequence[Cue], seed: int | None) -> list[Outcome]:
    """Train cues that share a descriptor and clusters, and count their decisions on the test sequence.

    See :func:`predict` for the parameters.
    """
    truth, predictions = predict(plan, cues, seed)
    count = len(plan.classes)
    return [
        (found if isinstance(found, str) else confusion_matrix(truth, found.argmax(axis=1), count), facts)
        for found, facts in predictions
    ]


def predict(plan: Plan, cues: Sequence[Cue], seed: int | None) -> tuple[NDArray[np.int16], list[Prediction]]:
    """Train cues that share a descriptor and codebook settings, and apply them to the test sequence.

    The plan must have exactly one test sequence. Returns the true classes of the scored frames, and the
    distributions of each cue for these frames. The labelled frames of the sequence are scored or, with a
    region variant, only those that have a descriptor. `seed` is one of ``protocol.seeds``, or None if the
    cues have no clusters.
    """
    descriptor = cues[0].descriptor
    frames = read_frames(plan.cues, descriptor)
    (tested,) = plan.tested
    scored = store.described(tested.home, descriptor, tested.chosen()[0])
    truth, test = tested.labels()[scored], store.read_descriptors(tested.home, descriptor, scored)
    codebook = None
    if seed is not None:
        numbers = [cue.classifier["clusters"] for cue in cues]
        codebook = cluster(frames, plan, cues[0], seed, numbers=numbers)
    with remembering():
        return truth, [_predict(cue, frames, codebook, test, plan.classes) for cue in cues]


def _predict(
    cue: Cue,
    frames: TrainingFrames,
    codebook: Codebook | None,
    test: Descriptors,
    classes: Sequence[str],
) -> Prediction:
    try:
        model = fit(frames, cue, classes, codebook).model
        return model.predict_proba(test), model.facts
    except NotComputable as error:
        return str(error), {}
