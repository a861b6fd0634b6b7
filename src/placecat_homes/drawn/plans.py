"""Draw a floor plan from a home's name: rooms are arranged, mirrored, rotated and joined by doors."""

from collections.abc import Mapping
from typing import Any

import numpy as np

from placecat.errors import PlacecatError
from placecat.seeds import derive
from placecat_homes import plan_parts
from placecat_homes.drawn.arrangements import ALL, Sketch
from placecat_homes.drawn.ranges import KINDS, PlanRanges, chosen
from placecat_homes.floorplan import FloorPlan
from placecat_homes.plan_parts import SIDES, Rect

_TALL = 2.65
_PLACES = ((0.08, 0.25), (0.75, 0.92), (0.35, 0.65))
_TRIES = 30
# Maximum share of the floor area for corridors, equal to that of the long corridor in conf/plan/home_2.yaml.
_CORRIDORS = 0.22


def draw(name: str, number: int, ranges: PlanRanges) -> dict[str, Any]:
    """Draw a floor plan.

    Parameters
    ----------
    name
        Name of the home, such as "home 7 of seed 1". For given ranges, the plan depends only on the name and
        number.
    number
        Number of the plan, from 1. Different numbers give different plans.
    ranges
        Ranges for sizes, and odds for arrangements and numbers of rooms.

    Returns
    -------
    dict
        The plan, with the same structure as the files in conf/plan.

    Raises
    ------
    PlacecatError
        If no plan fits the ranges.
    """
    arrangement = chosen(np.random.default_rng(derive("arrangement", name, number)), ranges.arrangements)
    for attempt in range(_TRIES):
        rng = np.random.default_rng(derive("floor plan", name, number, attempt))
        plan = _attempt(name, ALL[arrangement](rng, ranges), rng, ranges)
        if plan is not None:
            return plan
    raise PlacecatError(f"{name}: no plan fits the ranges of sizes; widen the ranges")


def read(plan: Mapping[str, Any]) -> FloorPlan:
    """Read and check a plan made by :func:`draw`. An invalid plan raises PlacecatError."""
    name = str(plan["name"])
    return FloorPlan.from_dict(name, plan)


def _attempt(
    name: str, sketch: Sketch, rng: np.random.Generator, ranges: PlanRanges
) -> dict[str, Any] | None:
    sketch.rooms = _placed(rng, sketch.rooms)
    height = round(rng.uniform(*ranges.height), 2)
    doors = []
    for first, second, kind in sketch.joined:
        door = _door(rng, ranges, sketch, first, second, kind, height)
        if door is None:
            return None
        doors.append(door)
    plan: dict[str, Any] = {
        "name": name,
        "height": height,
        "glazing": round(rng.uniform(*ranges.glazing), 2),
        "rooms": {
            room: {"kind": room.rpartition("_")[0], "rect": list(rect)} for room, rect in sketch.rooms.items()
        },
        "doors": doors,
    }
    if not all(_fits(room["kind"], room["rect"], ranges) for room in plan["rooms"].values()):
        return None
    if _corridors(sketch.rooms) > _CORRIDORS:
        return None
    for side in rng.permutation(SIDES):
        entrance = {
            "rooms": [sketch.entrance],
            "kind": "closed",
            "side": str(side),
            "position": round(rng.uniform(0.2, 0.8), 2),
            "width": 0.9,
        }
        complete = plan | {"doors": [entrance, *doors]}
        if _possible(complete):
            return complete
    return None


def _fits(kind: str, rect: Rect, ranges: PlanRanges) -> bool:
    """Return whether a room's size is allowed for its kind."""
    if kind not in KINDS:
        return True
    x0, y0, x1, y1 = rect
    area, side = (x1 - x0) * (y1 - y0), min(x1 - x0, y1 - y0)
    (least, most), (shortest, longest) = ranges.areas[kind], ranges.sides[kind]
    return least - 0.1 <= area <= most + 0.1 and shortest - 0.02 <= side <= longest + 0.02


def _corridors(rooms: Mapping[str, Rect]) -> float:
    """Return the share of the floor area that corridors take up."""
    areas = {name: (x1 - x0) * (y1 - y0) for name, (x0, y0, x1, y1) in rooms.items()}
    return sum(area for name, area in areas.items() if name.startswith("corridor")) / sum(areas.values())


def _possible(content: Mapping[str, Any]) -> bool:
    """Return whether a plan is valid, its entrance leads outside, and only its corridors lack windows."""
    try:
        plan = read(content)
    except PlacecatError:
        return False
    entrance = plan.doors[0]
    x0, y0, x1, y1 = plan.doorway(entrance).rect
    beyond = {
        "south": (x0, y0 - 1.5, x1, y0),
        "north": (x0, y1, x1, y1 + 1.5),
        "west": (x0 - 1.5, y0, x0, y1),
        "east": (x1, y0, x1 + 1.5, y1),
    }[entrance.side]
    inside = plan.room(entrance.rooms[0])
    if any(plan_parts.apart(beyond, room.rect) < 0.05 for room in plan.rooms if room is not inside):
        return False
    lit = {window.room for window in plan.windowed(0).windows}
    return all(room.name in lit or room.kind == "corridor" for room in plan.rooms)


def _placed(rng: np.random.Generator, rooms: Mapping[str, Rect]) -> dict[str, Rect]:
    """Mirror the rooms and swap x and y at random, shift them to x, y >= 0, and round to centimetres."""
    east, north, turned = rng.random(3) < 0.5
    corners = {}
    for name, (x0, y0, x1, y1) in rooms.items():
        xs, ys = ((-x1, -x0) if east else (x0, x1)), ((-y1, -y0) if north else (y0, y1))
        corners[name] = (ys, xs) if turned else (xs, ys)
    left = min(xs[0] for xs, _ in corners.values())
    low = min(ys[0] for _, ys in corners.values())
    return {
        name: (
            round(xs[0] - left, 2),
            round(ys[0] - low, 2),
            round(xs[1] - left, 2),
            round(ys[1] - low, 2),
        )
        for name, (xs, ys) in corners.items()
    }


def _door(
    rng: np.random.Generator,
    ranges: PlanRanges,
    sketch: Sketch,
    first: str,
    second: str,
    kind: str,
    height: float,
) -> dict[str, Any] | None:
    """Draw the width and position of a door. Return None if the rooms do not share enough wall."""
    a, b = sketch.rooms[first], sketch.rooms[second]
    shared = max(min(a[2], b[2]) - max(a[0], b[0]), min(a[3], b[3]) - max(a[1], b[1]))
    room = shared - 0.2
    tall = 0.1 if height > _TALL else 0.0
    if kind == "open":
        width = min(rng.uniform(*ranges.opening), room)
        if width < 0.9:
            kind = "door"
    if kind == "door":
        width = rng.uniform(*ranges.door)
        if second.startswith("bathroom"):
            width = min(width, 0.8)
        if width > room:
            return None
    low, high = _PLACES[int(rng.choice(3, p=[0.4, 0.4, 0.2]))]
    door = {
        "rooms": [first, second],
        "position": round(rng.uniform(low, high), 2),
        "width": round(width - 0.005, 2),
    }
    if kind == "open":
        return door | {"kind": "open", "height": round(rng.uniform(2.05, 2.15) + tall, 2)}
    return door | {"height": round(2.05 + tall, 2)}
