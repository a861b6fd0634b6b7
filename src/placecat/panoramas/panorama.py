"""A panorama of a home."""

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass

FLOOR = re.compile(r"[A-Za-z0-9_-]{1,50}")
"""Pattern of valid floor names in label files."""
_NUMBER = re.compile(r"[\s_-]*[0-9]+$")


@dataclass(frozen=True)
class Panorama:
    """The view in all directions from one point.

    `home` and `floor` are also folder names. `room` is unique on its floor, and `label` is its place
    category. `files` are the paths of one equirectangular image, or of the six faces of a cube in the order
    of `placecat.panoramas.cube.FACES`. They are POSIX paths relative to the source folder. `origin` states
    which file lists the panorama, and where in that file; it is used in messages.
    """

    home: str
    floor: str
    room: str
    label: str
    files: tuple[str, ...]
    origin: str


def kind(name: str) -> str:
    """Return a room's name without its number, in lower case, with its words joined by ``_``.

    Examples
    --------
    >>> kind("Living Room 2"), kind("walk-in closet"), kind("bedroom_1"), kind("12")
    ('living_room', 'walk_in_closet', 'bedroom', '12')
    """
    return re.sub(r"[\s_-]+", "_", _NUMBER.sub("", name.strip()) or name.strip()).casefold()


def labels_by_kind(labels: Mapping[str, Iterable[str]]) -> dict[str, str]:
    """Map every `kind` of room in the `labels` setting to its label."""
    named = {kind(name): label for label, names in labels.items() for name in names}
    return named | {kind(label): label for label in labels}
