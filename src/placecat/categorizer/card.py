"""The model card: what a person should know before trusting a trained system."""

import platform
from collections.abc import Mapping, Sequence
from importlib.metadata import version
from typing import Any

from placecat import __version__
from placecat.categorizer.model_file import FORMAT

# What the last bits of a result may depend on.
LIBRARIES = ("numpy", "opencv-python-headless", "scikit-learn", "scipy")


def make_card(
    *,
    title: str,
    data: Mapping[str, Any],
    classes: Sequence[str],
    frame_sizes: Sequence[Sequence[int]],
    fps: Sequence[float],
    accuracy: Mapping[str, float],
    settings: Mapping[str, Any],
) -> dict[str, Any]:
    """Write a card.

    Parameters
    ----------
    title
        What the system is.
    data
        ``title``, ``version`` (DVC's checksum), ``homes`` that trained it, ``left_out``, and the number of
        training ``frames`` of the cues and of the integration.
    classes, frame_sizes, fps
        Places; (width, height) and frames/s of the training footage.
    accuracy
        Percent by home, each measured by a system of the same settings that had not seen the home; may be
        empty.
    settings
        All settings that the system was trained with.

    Returns
    -------
    dict
        JSON types only.
    """
    return {
        "format": FORMAT,
        "placecat": __version__,
        "title": title,
        "data": dict(data),
        "classes": list(classes),
        "frame_sizes": [list(size) for size in frame_sizes],
        "fps": list(fps),
        "accuracy": dict(accuracy),
        "settings": dict(settings),
        "versions": {"python": platform.python_version()} | {name: version(name) for name in LIBRARIES},
    }
