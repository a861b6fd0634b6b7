"""The model card: facts that a person should know before trusting a trained system."""

import platform
from collections.abc import Mapping
from importlib.metadata import version
from typing import Any

from placecat import __version__

# Of the model file. Raise it when stored values change their meaning.
FORMAT = 5
# The last bits of a result may depend on these.
LIBRARIES = ("numpy", "opencv-python-headless", "scikit-learn", "scipy")


def make_card(**known: Any) -> dict[str, Any]:
    """Write a card.

    Parameters
    ----------
    **known
        JSON types only. ``title``: of the system. ``data``: ``title``, a ``note`` on it or None, ``version``
        (DVC's checksum), ``homes`` that trained it, those ``left_out``, and the number of training ``frames``
        of the cues and of the integration. ``classes``, ``frame_sizes``, ``fps``: places; (width, height) and
        frames/s of the training footage. ``accuracy``: percent by home, each measured by a system of the same
        settings that had not seen the home; may be empty. ``unknown``: from
        :func:`placecat.categorizer.held_out.unknown`; None if that was not measured. ``settings``: all those
        of the training.

    Returns
    -------
    dict
        With the versions of this project and of `LIBRARIES`.
    """
    versions = {"python": platform.python_version()} | {name: version(name) for name in LIBRARIES}
    return {"format": FORMAT, "placecat": __version__} | known | {"versions": versions}


def unknown_text(card: Mapping[str, Any]) -> str:
    """Say in a line when the system says `unknown`, with the measurements of that."""
    unknown = card.get("unknown")
    if unknown is None:
        return "It never says `unknown`: how often it is wrong in homes that it has not seen is not measured."
    risk = f"at most {100 * unknown['risk']:g}% of its decisions in left-out training homes were wrong"
    if unknown["threshold"] is None:
        return (
            f"It always says `unknown`, since there is no confidence above which {risk}. The most probable "
            "place is reported beside it; a higher model.risk may help."
        )
    (own,) = (row for row in unknown["measured"] if row["risk"] == unknown["risk"])
    wrong = "" if own["wrong"] is None else f", {own['wrong']:.1%} of these wrongly"
    return (
        f"It says `unknown` below a confidence of {unknown['threshold']:.3f}, above which {risk}. In homes "
        f"that did not influence this confidence it names {own['coverage']:.1%} of the frames{wrong}."
    )
