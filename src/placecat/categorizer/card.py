"""The model card: what to know before trusting a trained system."""

import platform
from collections.abc import Mapping
from importlib.metadata import version
from typing import Any

from placecat import __version__

# Version of the model file format. Increment it when the meaning of stored values changes.
FORMAT = 5
# The last bits of a result may depend on the versions of these libraries.
LIBRARIES = ("numpy", "opencv-python-headless", "scikit-learn", "scipy")


def make_card(**known: Any) -> dict[str, Any]:
    """Build a card from the `known` facts and the versions of placecat, Python and `LIBRARIES`.

    The facts contain only JSON types. ``title`` is the name of the system. ``data`` contains the ``title`` of
    the data set, its ``note`` (or None), and its ``version``, which is DVC's checksum. It also contains the
    training ``homes``, the ``left_out`` homes, and the number of training ``frames`` used for the cues and
    for integration. ``classes`` lists the names of the places. ``frame_sizes`` lists every (width, height) in
    the training footage, and ``fps`` lists every frame rate.

    ``accuracy`` maps each home to a percentage, measured with a system that has the same settings but was not
    trained on that home. It may be empty. ``unknown`` comes from
    :func:`placecat.categorizer.held_out.unknown`, or is None if it was not measured. ``settings`` contains
    all training settings.
    """
    versions = {"python": platform.python_version()} | {name: version(name) for name in LIBRARIES}
    return {"format": FORMAT, "placecat": __version__} | known | {"versions": versions}


def unknown_text(card: Mapping[str, Any]) -> str:
    """Describe in one line when the system says `unknown`, and how often its other decisions were wrong."""
    unknown = card.get("unknown")
    if unknown is None:
        return "It never says `unknown`, because its errors in unseen homes were not measured."
    risk = f"at most {100 * unknown['risk']:g}% of its decisions in held-out training homes were wrong"
    if unknown["threshold"] is None:
        return (
            f"It always says `unknown`, because there is no confidence above which {risk}. The most probable "
            "place is reported too. A higher model.risk may help."
        )
    (own,) = (row for row in unknown["measured"] if row["risk"] == unknown["risk"])
    wrong = "" if own["wrong"] is None else f", and {own['wrong']:.1%} of these names are wrong"
    return (
        f"It says `unknown` if its confidence is below {unknown['threshold']:.3f}. Above this confidence, "
        f"{risk}. In homes that did not influence the choice of this confidence, it names the place in "
        f"{own['coverage']:.1%} of the frames{wrong}."
    )
