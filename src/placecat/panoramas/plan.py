"""Plan a walk through a home floor by floor, with the view direction of each frame."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from placecat.footage.names import natural
from placecat.panoramas.gaze import gaze
from placecat.panoramas.panorama import Panorama
from placecat.panoramas.walk import Room, walk
from placecat.seeds import derive

_OF_WALK = ("fps", "visits", "ways", "stays", "other_stays", "shortest_stay", "longest_look")
_OF_GAZE = ("fps", "fov", "tilt", "turn", "speed", "rest")


@dataclass(frozen=True, eq=False)
class Look:
    """Consecutive frames that show one panorama.

    On each floor, stays are numbered from 0 and frames from 1: `stay` is the stay that these frames belong
    to, and `first` is the first frame. `path` is (frames, 3) float64: pan, tilt and horizontal field of view
    in degrees.
    """

    panorama: Panorama
    stay: int
    first: int
    path: NDArray[np.float64]

    @property
    def last(self) -> int:
        """The number of the last frame, counted from 1 on each floor."""
        return self.first + len(self.path) - 1


Plans = Mapping[str, Mapping[str, Sequence[Look]]]
"""The looks on each floor of each home."""


def plan(panoramas: Sequence[Panorama], settings: Mapping[str, Any]) -> dict[str, list[Look]]:
    """Plan the walk through a home from its panoramas and the settings of conf/panoramas.yaml.

    Returns the looks of each floor in order, with the floors in natural order. The seed depends on the home
    name, the floor name and the `walk` setting.
    """
    of_walk = {name: settings[name] for name in _OF_WALK}
    of_gaze = {name: settings[name] for name in _OF_GAZE}
    floors: dict[str, list[Look]] = {}
    for floor in sorted({one.floor for one in panoramas}, key=natural):
        here = [one for one in panoramas if one.floor == floor]
        numbers: dict[tuple[str, str], list[int]] = {}
        for number, one in enumerate(here):
            numbers.setdefault((one.room, one.label), []).append(number)
        rooms = [Room(label, tuple(own)) for (_, label), own in numbers.items()]
        rng = np.random.default_rng(seed(here[0].home, floor, settings["walk"]))
        first, floors[floor] = 1, []
        for part in walk(rooms, **of_walk, rng=rng):
            path = gaze(part.frames, **of_gaze, rng=rng)
            floors[floor].append(Look(here[part.panorama], part.stay, first, path))
            first += part.frames
    return floors


def unseen(panoramas: Sequence[Panorama], plans: Plans) -> list[Panorama]:
    """Return the panoramas that do not appear in any look, in their original order."""
    shown = {look.panorama for floors in plans.values() for looks in floors.values() for look in looks}
    return [one for one in panoramas if one not in shown]


def seed(home: str, floor: str, number: int) -> int:
    """Derive the seed of a walk from the home name, the floor name and the walk number."""
    return derive("panoramas", home, floor, number)
