"""Radiators, placed wherever the furniture leaves space."""

import numpy as np

from placecat_homes.furniture.radiator import radiator
from placecat_homes.placing.room import Room


def heat(room: Room, design: int, rng: np.random.Generator) -> None:
    """Put a radiator under a window, or against another part of the wall, if there is enough space.

    Parameters
    ----------
    room
        The furnished room.
    design
        Seed of the design that all radiators of a building share.
    rng
        Random number generator for the size and position.
    """
    for window in room.windows:
        if window.sill < 0.7:
            continue
        wide = min(max(window.width * float(rng.uniform(0.6, 0.95)), 0.5), 1.4)
        if _radiator(room, design, wide, min(0.6, window.sill - 0.28), window.wall, window.middle):
            return
    for wall in (int(k) for k in rng.permutation(4)):
        free = room.length(wall) - 0.9
        if free > 0.2 and _radiator(room, design, 0.7, 0.6, wall, 0.45 + float(rng.uniform(0, free))):
            return


def _radiator(room: Room, design: int, width: float, height: float, wall: int, at: float) -> bool:
    model = radiator(np.random.default_rng(design), room.style, width, height)
    probe = np.array([*room.point(wall, at - width / 2, 0.0), *room.point(wall, at + width / 2, 0.12)])
    low, high = np.minimum(probe[:2], probe[2:]), np.maximum(probe[:2], probe[2:])
    for thing in room.placed:
        box_of = thing.box()
        low_thing = box_of[4] < 0.12 + height and box_of[5] > 0.1
        if low_thing and np.all(box_of[:2] < high) and np.all(box_of[2:4] > low):
            return False
    return room.against(model, front=0.1, wall=wall, at=at, z=0.12) is not None
