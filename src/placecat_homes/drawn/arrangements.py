"""Positions and connections of rooms. Plans are mirrored and rotated later."""

from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np

from placecat_homes.drawn.ranges import PlanRanges, Range, chosen
from placecat_homes.plan_parts import Rect

WALL = 0.12
"""Thickness of inner walls in metres."""

_DOOR = 1.2
_LONG = 7.0


@dataclass
class Sketch:
    """Rooms and their connections.

    Attributes
    ----------
    rooms
        Maps room names to (x0, y0, x1, y1) in metres.
    joined
        Pairs of rooms, each with "door" or "open" to say how they are joined. A door leaf swings into the
        second room.
    entrance
        Corridor with the home's front door.
    """

    rooms: dict[str, Rect] = field(default_factory=dict)
    joined: list[tuple[str, str, str]] = field(default_factory=list)
    entrance: str = ""

    def add(self, kind: str, x0: float, y0: float, x1: float, y1: float) -> str:
        """Add a room named after its kind, numbered from 1."""
        number = 1 + sum(name.rpartition("_")[0] == kind for name in self.rooms)
        self.rooms[f"{kind}_{number}"] = (x0, y0, x1, y1)
        return f"{kind}_{number}"

    def join(self, first: str, second: str, kind: str = "door") -> None:
        """Connect two rooms."""
        self.joined.append((first, second, kind))


def two_rows(rng: np.random.Generator, ranges: PlanRanges) -> Sketch:
    """Draw a corridor with a row of rooms on each side."""
    sketch = Sketch()
    south, north = _two_lists(rng, ranges)
    deep = [rng.uniform(*ranges.depth) for _ in range(2)]
    sizes = [
        [_in_row(rng, ranges, kind, depth) for kind in row]
        for row, depth in zip((south, north), deep, strict=True)
    ]
    wide = rng.uniform(*ranges.corridor)
    low, high = deep[0] + WALL, deep[0] + WALL + wide
    names: list[list[str]] = [[], []]
    reach = 0.0
    for side, row in enumerate((south, north)):
        x = 0.0
        for kind, (width, depth) in zip(row, sizes[side], strict=True):
            y = (low - WALL - depth, low - WALL) if side == 0 else (high + WALL, high + WALL + depth)
            names[side].append(sketch.add(kind, x, y[0], x + width, y[1]))
            reach = max(reach, x + (min(_DOOR, width) if kind != "bathroom" else width))
            x += width + WALL
    longest = max(sketch.rooms[row[-1]][2] for row in names)
    reach = min(longest, reach + float(rng.choice((0.0, 0.6, longest))))
    _corridor(rng, sketch, names[0] + names[1], (low, high), reach)
    _social(rng, sketch)
    _own_bathroom(rng, sketch, names[1])
    return sketch


def _two_lists(rng: np.random.Generator, ranges: PlanRanges) -> tuple[list[str], list[str]]:
    """Draw the kinds of room in both rows, in order. A corridor among them is the entrance."""
    bedrooms, bathrooms = chosen(rng, ranges.bedrooms), chosen(rng, ranges.bathrooms)
    south = ["living_room", "dining_room"]
    north: list[str] = []
    for k in range(bedrooms):
        north.append("bedroom")
        if k < bathrooms:
            north.append("bathroom")
    north += ["bathroom"] * max(0, bathrooms - bedrooms)
    if rng.random() < 0.6:
        south.append("kitchen")
    else:
        north.insert(int(rng.choice((0, len(north)))), "kitchen")
        if bedrooms > 1 and rng.random() < 0.6:
            north.remove("bedroom")
            south.append("bedroom")
    if rng.random() < 0.5:
        south.reverse()
    if rng.random() < 0.5:
        north.reverse()
    if rng.random() < 0.5:
        north.insert(int(rng.integers(0, len(north) + 1)), "corridor")
    return south, north


def _in_row(rng: np.random.Generator, ranges: PlanRanges, kind: str, deep: float) -> tuple[float, float]:
    """Draw the width and depth of a room in a row that is `deep` metres deep."""
    if kind == "corridor":
        return rng.uniform(*ranges.corridor), deep
    area = rng.uniform(*ranges.areas[kind])
    low, high = ranges.sides[kind]
    if kind == "bathroom":
        width = rng.uniform(low, high)
        return width, float(np.clip(area / width, low, deep))
    # The longer side may be up to 1.6 times the upper limit for the shorter side.
    return float(np.clip(area / deep, low, 1.6 * high)), deep


def _corridor(
    rng: np.random.Generator, sketch: Sketch, others: list[str], across: Range, reach: float
) -> None:
    """Add a corridor from x = 0 to `reach`, in two parts if it is long, and join all rooms to it."""
    low, high = across
    parts = [sketch.add("corridor", 0.0, low, reach, high)]
    if reach > _LONG and rng.random() < 0.7:
        cut = reach * rng.uniform(0.4, 0.6)
        sketch.rooms[parts[0]] = (0.0, low, cut, high)
        parts.append(sketch.add("corridor", cut + WALL, low, reach, high))
        sketch.join(parts[0], parts[1], "open")
    for name in others:
        part = max(parts, key=lambda part: _shared(sketch.rooms[part], sketch.rooms[name]))
        if name.startswith("corridor"):
            sketch.join(part, name, "open")
            sketch.entrance = name
        else:
            sketch.join(part, name)
    sketch.entrance = sketch.entrance or parts[int(rng.integers(len(parts)))]


def _shared(a: Rect, b: Rect) -> float:
    """Return the overlap of two rooms along x in metres."""
    return min(a[2], b[2]) - max(a[0], b[0])


def _social(rng: np.random.Generator, sketch: Sketch) -> None:
    """Join neighbouring dining rooms, living rooms and kitchens, and remove some of their other doors."""
    dining = "dining_room_1"
    for other in ("living_room_1", "kitchen_1"):
        if not _adjacent(sketch.rooms[dining], sketch.rooms[other]):
            continue
        if other == "living_room_1" or rng.random() < 0.7:
            kind = "open" if rng.random() < (0.75 if other == "living_room_1" else 0.5) else "door"
            sketch.join(other, dining, kind)
            if rng.random() < 0.4:
                spared = dining if other == "living_room_1" else other
                sketch.joined = [way for way in sketch.joined if not _to(way, spared)]


def _to(way: tuple[str, str, str], room: str) -> bool:
    return way[0].startswith("corridor") and way[1] == room


def _adjacent(a: Rect, b: Rect) -> bool:
    """Return whether two rooms are next to each other in a row."""
    beside = min(abs(a[0] - b[2]), abs(b[0] - a[2])) < WALL + 0.01
    return beside and min(a[3], b[3]) - max(a[1], b[1]) > _DOOR


def _own_bathroom(rng: np.random.Generator, sketch: Sketch, row: list[str]) -> None:
    """Sometimes join the second bathroom to the bedroom beside it instead of the corridor."""
    if "bathroom_2" not in row or rng.random() < 0.4:
        return
    place = row.index("bathroom_2")
    beside = [row[k] for k in (place - 1, place + 1) if 0 <= k < len(row) and row[k].startswith("bedroom")]
    if beside:
        sketch.joined = [way for way in sketch.joined if not _to(way, "bathroom_2")]
        sketch.join(beside[int(rng.integers(len(beside)))], "bathroom_2")


def around_living_room(rng: np.random.Generator, ranges: PlanRanges) -> Sketch:
    """Draw rooms on three sides of the living room."""
    sketch = Sketch()
    wide = rng.uniform(4.4, 5.6)
    deep = float(np.clip(rng.uniform(*ranges.areas["living_room"]) / wide, 4.5, 5.8))
    living = sketch.add("living_room", 0.0, 0.0, wide, deep)
    # The kitchen and the dining room are to the west.
    column = rng.uniform(3.1, 3.7)
    split = float(np.clip(rng.uniform(*ranges.areas["kitchen"]) / column, 2.4, deep - 1.7))
    kitchen = sketch.add("kitchen", -WALL - column, 0.0, -WALL, split)
    end = split + WALL + float(np.clip(rng.uniform(*ranges.areas["dining_room"]) / column, 2.9, 4.2))
    dining = sketch.add("dining_room", -WALL - column, split + WALL, -WALL, end)
    # A bedroom and a bathroom are to the east.
    column = rng.uniform(3.1, 3.9)
    split = float(np.clip(rng.uniform(*ranges.areas["bedroom"]) / column, 2.9, deep - 1.3))
    bedroom = sketch.add("bedroom", wide + WALL, 0.0, wide + WALL + column, split)
    narrow = rng.uniform(1.9, 2.6)
    top = split + WALL + float(np.clip(rng.uniform(*ranges.areas["bathroom"]) / narrow, 1.9, 3.0))
    bathroom = sketch.add("bathroom", wide + WALL, split + WALL, wide + WALL + narrow, top)
    # The entrance is to the north, beside any second bedroom.
    hall = rng.uniform(*ranges.corridor)
    depth = rng.uniform(3.2, 3.9)
    north = deep + WALL
    corridor = sketch.add("corridor", 0.0, north, hall, north + depth)
    sketch.join(corridor, living, "open" if rng.random() < 0.6 else "door")
    sketch.join(living, kitchen)
    sketch.join(living, dining, "open" if rng.random() < 0.7 else "door")
    if rng.random() < 0.7:
        sketch.join(kitchen, dining)
    sketch.join(living, bedroom)
    sketch.join(living, bathroom)
    if chosen(rng, ranges.bedrooms) > 1:
        second = sketch.add("bedroom", hall + WALL, north, max(wide, hall + WALL + 2.9), north + depth)
        sketch.join(corridor if rng.random() < 0.5 else living, second)
    if chosen(rng, ranges.bathrooms) > 1:
        low = max(north, end + WALL)
        sketch.join(corridor, sketch.add("bathroom", -WALL - rng.uniform(1.9, 2.5), low, -WALL, low + 2.4))
    sketch.entrance = corridor
    return sketch


def angled(rng: np.random.Generator, ranges: PlanRanges) -> Sketch:
    """Draw rooms along a corridor that turns a corner."""
    sketch = Sketch()
    deep, wide = rng.uniform(*ranges.depth), rng.uniform(*ranges.corridor)
    x = 0.0
    row: list[str] = []
    for kind in ("bedroom", "living_room", "dining_room"):
        width, _ = _in_row(rng, ranges, kind, deep)
        row.append(sketch.add(kind, x, 0.0, x + width, deep))
        x += width + WALL
    bedroom, living, dining = row
    turn = sketch.rooms[dining][0] - rng.uniform(0.1, 0.5)
    low, high = deep + WALL, deep + WALL + wide
    bend = rng.uniform(*ranges.corridor)
    # The kitchen, behind the dining room, and a bathroom are east of the second part.
    east = turn + bend + WALL
    width = float(np.clip(sketch.rooms[dining][2] - east, *ranges.sides["kitchen"]))
    top = low + float(np.clip(rng.uniform(*ranges.areas["kitchen"]) / width, 2.9, 4.4))
    kitchen = sketch.add("kitchen", east, low, east + width, top)
    narrow = rng.uniform(2.0, 2.7)
    end = top + WALL + float(np.clip(rng.uniform(*ranges.areas["bathroom"]) / narrow, 1.9, 3.0))
    bathroom = sketch.add("bathroom", east, top + WALL, east + narrow, end)
    first = sketch.add("corridor", 0.0, low, turn - WALL, high)
    second = sketch.add("corridor", turn, low, turn + bend, end)
    sketch.join(first, second, "open")
    sketch.join(first, bedroom)
    sketch.join(first, living)
    sketch.join(living, dining, "open" if rng.random() < 0.6 else "door")
    sketch.join(dining, kitchen, "open" if rng.random() < 0.6 else "door")
    sketch.join(second, kitchen)
    sketch.join(second, bathroom)
    # The second bedroom and the second bathroom, if any, are west of it.
    west = turn - WALL
    if chosen(rng, ranges.bedrooms) > 1:
        depth = rng.uniform(3.2, 4.2)
        width = float(np.clip(rng.uniform(*ranges.areas["bedroom"]) / depth, 2.8, 4.4))
        another = sketch.add("bedroom", west - width, high + WALL, west, high + WALL + depth)
        sketch.join(first if rng.random() < 0.5 else second, another)
        west -= width + WALL
    if chosen(rng, ranges.bathrooms) > 1:
        width = rng.uniform(1.9, 2.4)
        sketch.join(first, sketch.add("bathroom", west - width, high + WALL, west, high + WALL + 2.5))
    sketch.entrance = first if rng.random() < 0.5 else second
    return sketch


ALL: dict[str, Callable[[np.random.Generator, PlanRanges], Sketch]] = {
    "two_rows": two_rows,
    "around_living_room": around_living_room,
    "angled": angled,
}
"""The arrangements, by name in conf/drawn.yaml."""
