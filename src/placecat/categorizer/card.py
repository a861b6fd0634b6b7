"""The model card: what a person should know before trusting a trained system."""

import platform
from importlib.metadata import version
from typing import Any

from placecat import __version__
from placecat.categorizer.model_file import FORMAT

# What the last bits of a result may depend on.
LIBRARIES = ("numpy", "opencv-python-headless", "scikit-learn", "scipy")


def make_card(**known: Any) -> dict[str, Any]:
    """Write a card.

    Parameters
    ----------
    **known
        JSON types only. ``title``: what the system is. ``data``: ``title``, ``version`` (DVC's checksum),
        ``homes`` that trained it, ``left_out``, and the number of training ``frames`` of the cues and of the
        integration. ``classes``, ``frame_sizes``, ``fps``: places; (width, height) and frames/s of the
        training footage. ``accuracy``: percent by home, each measured by a system of the same settings that
        had not seen the home; may be empty. ``settings``: all that the system was trained with.

    Returns
    -------
    dict
        With the versions of this project and of `LIBRARIES`.
    """
    versions = {"python": platform.python_version()} | {name: version(name) for name in LIBRARIES}
    return {"format": FORMAT, "placecat": __version__} | known | {"versions": versions}
