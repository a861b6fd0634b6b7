"""A panorama of a home."""

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass

_NUMBER = re.compile(r"[\s_-]*[0-9]+$")


@dataclass(frozen=True)
class Panorama:
    """The view from one point in all directions.

    Attributes
    ----------
    home, floor
        Names of folders.
    room
        Name of the room, unique on its floor.
    label
        Place category of the room.
    files
        One equirectangular picture, or six faces of a cube in the order of `placecat.panoramas.cube.FACES`:
        POSIX paths relative to the folder of the source.
    origin
        File, and line if any, that lists the panorama; for messages.
    """

    home: str
    floor: str
    room: str
    label: str
    files: tuple[str, ...]
    origin: str


def kind(name: str) -> str:
    """Return the name of a room without its number, in lower case, with words joined by ``_``.

    Examples
    --------
    >>> kind("Living Room 2"), kind("walk-in closet"), kind("bedroom_1"), kind("12")
    ('living_room', 'walk_in_closet', 'bedroom', '12')
    """
    return re.sub(r"[\s_-]+", "_", _NUMBER.sub("", name.strip()) or name.strip()).casefold()


def labels_by_kind(labels: Mapping[str, Iterable[str]]) -> dict[str, str]:
    """Return the label of every `kind` of room that the setting `labels` names."""
    named = {kind(name): label for label, names in labels.items() for name in names}
    return named | {kind(label): label for label in labels}
