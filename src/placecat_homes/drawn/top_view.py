"""Draw a furnished home from above, with the camera's path."""

from collections.abc import Sequence

import cv2
import numpy as np
from numpy.typing import NDArray

from placecat_homes.building import Building
from placecat_homes.placing.placed import Placed
from placecat_homes.plan_parts import SIDES
from placecat_homes.walking.walk import Walk

_MARGIN = 0.6
_BEHIND = 0.15
_COLOURS = {
    "living_room": (196, 226, 205),
    "dining_room": (188, 220, 245),
    "kitchen": (200, 212, 250),
    "bedroom": (240, 214, 214),
    "bathroom": (238, 226, 190),
}
_OTHER = (228, 228, 228)


def top_view(building: Building, walk: Walk | None = None, *, scale: float = 60.0) -> NDArray[np.uint8]:
    """Draw rooms, doors, windows, furniture and the camera's path.

    Parameters
    ----------
    building
        The furnished home.
    walk
        The walk whose path is drawn in red; if None, no path is drawn.
    scale
        Pixels per metre.

    Returns
    -------
    numpy.ndarray
        (height, width, 3) uint8 BGR; north is up.
    """
    plan = building.plan
    bounds = np.array([room.rect for room in plan.rooms])
    low, high = bounds[:, :2].min(axis=0) - _MARGIN, bounds[:, 2:].max(axis=0) + _MARGIN
    width, height = (int(value) for value in np.ceil((high - low) * scale))
    picture = np.full((height, width, 3), 255, np.uint8)

    def pixels(points: NDArray[np.float64] | Sequence[Sequence[float]]) -> NDArray[np.int32]:
        flat = (np.asarray(points, dtype=np.float64) - low) * scale
        return np.column_stack([flat[:, 0], height - flat[:, 1]]).round().astype(np.int32)

    def fill(rect: Sequence[float], colour: tuple[int, int, int], grow: float = 0.0) -> None:
        x0, y0, x1, y1 = rect[0] - grow, rect[1] - grow, rect[2] + grow, rect[3] + grow
        cv2.fillPoly(picture, [pixels([(x0, y0), (x1, y0), (x1, y1), (x0, y1)])], colour)

    for room in plan.rooms:
        fill(room.rect, (70, 70, 70), grow=_BEHIND)
    for room in plan.rooms:
        fill(room.rect, _COLOURS.get(room.label, _OTHER))
    for door in plan.doors:
        fill(plan.doorway(door).rect, (60, 110, 170) if door.kind == "closed" else _OTHER)
    for window in plan.windows:
        x0, y0, x1, y1 = plan.room(window.room).rect
        edge = (y0, x1, y1, x0)[SIDES.index(window.side)]
        along_x = window.side in ("south", "north")
        ends = [(at, edge) if along_x else (edge, at) for at in (window.start, window.end)]
        cv2.polylines(picture, [pixels(ends)], False, (230, 150, 60), max(2, round(scale * 0.08)))
    for room, things, furnished in zip(plan.rooms, building.things, building.rooms, strict=True):
        for thing in sorted(things, key=_top):
            standing = any(thing is other for other in furnished.blocking)
            corners = pixels(thing.corners() + room.rect[:2])
            if standing:
                cv2.fillPoly(picture, [corners], (165, 175, 185))
            cv2.polylines(
                picture, [corners], True, (90, 90, 90) if standing else (185, 185, 185), 1, cv2.LINE_AA
            )
    for leaf in building.leaves:
        cv2.polylines(picture, [pixels(leaf)], True, (60, 110, 170), 2, cv2.LINE_AA)
    if walk is not None:
        cv2.polylines(picture, [pixels(walk.position[:, :2])], False, (60, 60, 220), 1, cv2.LINE_AA)
    for room in plan.rooms:
        x0, y0, x1, y1 = room.rect
        for line, text in enumerate((room.name.replace("_", " "), f"{(x1 - x0) * (y1 - y0):.1f} m2")):
            x, y = (int(value) for value in pixels([(x0 + 0.08, y1 - 0.25 - 0.25 * line)])[0])
            cv2.putText(picture, text, (x, y), cv2.FONT_HERSHEY_SIMPLEX, 0.38, (0, 0, 0), 1, cv2.LINE_AA)
    return picture


def _top(thing: Placed) -> float:
    return float(thing.box()[5])
