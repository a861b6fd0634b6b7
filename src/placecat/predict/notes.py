"""Notes on a prediction: damaged, turned or slow frames, and a home that the model was trained on."""

import math

import numpy as np

from placecat.categorizer import Categorizer
from placecat.predict.frame import Source
from placecat.predict.home import DataSetHome
from placecat.predict.prediction import Prediction

SLOW = 0.95
"""A frame rate below this share of the model's is slow; 4.995 instead of 5 frames/s is not. Our choice."""


def notes(source: Source, prediction: Prediction, categorizer: Categorizer) -> list[str]:
    """List warnings for the user, one line each; call this after reading all frames of the source."""
    found = [source.damage().note, _turned(prediction), _trained(source, categorizer)]
    return [note for note in [*found, _slow(prediction, categorizer)] if note]


def _turned(prediction: Prediction) -> str:
    if not prediction.turned:
        return ""
    return (
        f"{len(prediction.turned)} frames from frame {prediction.turned[0]} on have another size than the "
        "first (was the phone turned?): only their centre is used"
    )


def _trained(source: Source, categorizer: Categorizer) -> str:
    """Warn if the model was trained on this home; data sets with equal titles count as the same."""
    data = categorizer.card["data"]
    if not isinstance(source, DataSetHome) or source.title != data.get("title"):
        return ""
    if source.name not in map(str, data["homes"]):
        return ""
    return (
        f"{source.name} trained this model, so this accuracy says nothing about new homes; `placecat train "
        f"--without {source.name}` leaves it out"
    )


def _slow(prediction: Prediction, categorizer: Categorizer) -> str:
    """Warn if frames come more slowly than in training, since each then has more weight."""
    if len(prediction.seconds) < 2 or not 0 < categorizer.threshold < math.inf:
        return ""
    period = float(np.median(np.diff(prediction.seconds)))
    if period * categorizer.frame_rate * SLOW <= 1:
        return ""
    return (
        f"{1 / period:.3g} frames/s are used, but the confidence for `unknown` was chosen at "
        f"{categorizer.frame_rate:.3g}: each frame counts for more, so `unknown` is too rare"
    )
