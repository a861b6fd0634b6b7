"""Find faults in the plan, furniture or walk of a drawn home."""

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from placecat_homes.building import Building
from placecat_homes.drawn.ranges import KINDS
from placecat_homes.placing.placed import Placed
from placecat_homes.placing.room import Room
from placecat_homes.plan_parts import RoomPlan
from placecat_homes.walking.walk import Walk

LARGEST = {"bedroom": 1.2, "living_room": 0.9, "dining_room": 0.6, "kitchen": 0.3, "bathroom": 0.3}
"""Minimum floor area in square metres of the largest object in a room, such as a bed or sofa."""
STANDING = {"bedroom": 2, "living_room": 3, "dining_room": 1, "kitchen": 3, "bathroom": 3}
"""Minimum number of objects on the floor of a room."""
COVERED = 0.08
"""Minimum share of a room's floor that furniture must cover."""
LEAST_FRAMES = 5
"""Minimum number of frames in a room that must show one of its two largest objects."""

_BEYOND = 0.06
_AIM = np.radians(30)
_NEAREST = 0.7


def faults(building: Building, walk: Walk) -> Iterator[str]:
    """List what is wrong with a home.

    Parameters
    ----------
    building
        The furnished home.
    walk
        A walk through all its rooms.

    Yields
    ------
    str
        A fault, such as "bedroom_1 is nearly empty".
    """
    yield from of_rooms(building)
    ground = building.ground()
    if not ground.is_free(walk.position[:, :2]).all():
        yield "the walk leads through furniture or walls"
    where = ground.room_at(walk.position[:, :2])
    labels = np.array(walk.label)
    for k, (plan, room) in enumerate(zip(building.plan.rooms, building.rooms, strict=True)):
        seen = (where == k) & (labels == plan.label) & _looks(walk, plan, room)
        if plan.kind in KINDS and seen.sum() < LEAST_FRAMES:
            yield f"the walk hardly shows {plan.name}"


def of_rooms(building: Building) -> Iterator[str]:
    """List faults in the furniture, ignoring the walk."""
    for plan, room in zip(building.plan.rooms, building.rooms, strict=True):
        yield from _of_room(building, plan, room)


def _looks(walk: Walk, plan: RoomPlan, room: Room) -> NDArray[np.bool_]:
    """Return, for each frame, whether the camera looks at one of the two largest objects in a room."""
    largest = sorted(room.blocking, key=_area, reverse=True)[:2]
    looks = np.zeros(len(walk.yaw), bool)
    for thing in largest:
        x, y = (thing.corners().mean(axis=0) + plan.rect[:2] - walk.position[:, :2]).T
        aside = np.abs((np.arctan2(y, x) - walk.yaw + np.pi) % (2 * np.pi) - np.pi)
        looks |= (aside < _AIM) & (np.hypot(x, y) > _NEAREST)
    return looks


def _of_room(building: Building, plan: RoomPlan, room: Room) -> Iterator[str]:
    width, depth = plan.size
    boxes = [thing.box() for thing in room.blocking]
    if any(max(-box[0], -box[1], box[2] - width, box[3] - depth) > _BEYOND for box in boxes):
        yield f"an object in {plan.name} overlaps a wall"
    for other in building.plan.rooms:
        if other is not plan and any(_reaches(thing, plan, other) for thing in room.placed):
            yield f"an object in {plan.name} extends into {other.name}"
    if not room.walkable():
        yield f"furniture blocks a door of {plan.name}"
    if plan.kind not in KINDS:
        return
    areas = [_area(thing) for thing in room.blocking]
    if len(areas) < STANDING[plan.kind] or sum(areas) < COVERED * width * depth:
        yield f"{plan.name} is nearly empty"
    elif max(areas) < LARGEST[plan.kind]:
        yield f"the largest piece of furniture in {plan.name} is too small"


def _reaches(thing: Placed, plan: RoomPlan, other: RoomPlan) -> bool:
    x, y = plan.rect[:2]
    x0, y0, x1, y1 = other.rect
    box = thing.box()
    wide = min(x + box[2], x1) - max(x + box[0], x0)
    deep = min(y + box[3], y1) - max(y + box[1], y0)
    return bool(min(wide, deep) > _BEYOND)


def _area(thing: Placed) -> float:
    sides = np.ptp(thing.corners(), axis=0)
    return float(sides[0] * sides[1])
