"""Train a cue on frames of homes, from the descriptors that the stages left."""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from placecat import cues, listing, store
from placecat.evaluation import protocol


def train(
    homes: tuple[str, ...],
    descriptor: Mapping[str, Any],
    *,
    classifier: Mapping[str, Any],
    codebook: cues.Codebook | None,
    frames: Mapping[str, int],
    classes: Sequence[str],
) -> tuple[cues.CueModel, NDArray[np.int16], NDArray[np.str_]]:
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

    Returns
    -------
    model
        The trained cue.
    truth, home_of_frame
        (n,) class and home of its training frames, home after home.
    """
    labels = {home: listing.read_labels(home) for home in homes}
    chosen = protocol.select_training(labels, **frames)
    truth = np.concatenate([labels[home][chosen[home]] for home in homes])
    home_of_frame = np.concatenate([np.full(len(chosen[home]), home) for home in homes])
    model = cues.fit(
        store.read_training(homes, descriptor, chosen),
        truth,
        home_of_frame,
        classifier=classifier,
        classes=classes,
        codebook=codebook,
    )
    return model, truth, home_of_frame
