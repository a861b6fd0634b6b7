"""Train a cue on frames of homes, from the descriptors that the stages left."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from placecat import cues, listing, store
from placecat.evaluation import protocol


@dataclass(frozen=True)
class CueTraining:
    """A trained cue, and its training frames.

    Attributes
    ----------
    model
        The trained cue.
    truth, home_of_frame
        (n,) class and home of its training frames, home after home.
    cross_validated
        (n, n_classes) distributions of them by :func:`placecat.cues.cross_validate`, if asked for.
    """

    model: cues.CueModel
    truth: NDArray[np.int16]
    home_of_frame: NDArray[np.str_]
    cross_validated: NDArray[np.float64] | None


def train(
    homes: tuple[str, ...],
    descriptor: Mapping[str, Any],
    *,
    classifier: Mapping[str, Any],
    codebook: cues.Codebook | None,
    frames: Mapping[str, int],
    classes: Sequence[str],
    cross_validate: bool = False,
) -> CueTraining:
    """Train one cue.

    Parameters
    ----------
    homes
        The training homes.
    descriptor
        As for :func:`placecat.cue_input.check`.
    classifier, codebook, classes
        As for :func:`placecat.cues.fit`.
    frames
        ``offset`` and ``step``: which frames train, see :func:`placecat.evaluation.protocol.select_frames`.
    cross_validate
        Whether each home's frames are judged by a cue trained on the others as well.
    """
    labels = {home: listing.read_labels(home) for home in homes}
    chosen = protocol.select_training(labels, **frames)
    truth = np.concatenate([labels[home][chosen[home]] for home in homes])
    home_of_frame = np.concatenate([np.full(len(chosen[home]), home) for home in homes])
    described = store.read_training(homes, descriptor, chosen)
    options: dict[str, Any] = {"classifier": classifier, "classes": classes, "codebook": codebook}
    held_out = cues.cross_validate(described, truth, home_of_frame, **options) if cross_validate else None
    model = cues.fit(described, truth, home_of_frame, **options)
    return CueTraining(model, truth, home_of_frame, held_out)
