"""Floor plans: rectangular rooms, doors between them and windows.

Sides of a room are south (y0), east (x1), north (y1) and west (x0); they are walls 0 to 3 of `Room`.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import combinations
from typing import Any

import numpy as np

from placecat.errors import PlacecatError
from placecat.seeds import derive
from placecat.settings import refuse_unknown
from placecat_homes.placing.opening import Opening

SIDES = ("south", "east", "north", "west")
"""Names of walls 0 to 3."""

OUTER_WALL = 0.3
"""Thickness of outer walls in metres."""

_THICKEST = 0.4
_VIEW = 2.0
_DOOR_KINDS = ("door", "open", "glass", "closed")

Rect = tuple[float, float, float, float]


@dataclass(frozen=True)
class RoomPlan:
    """A room.

    Attributes
    ----------
    name
        Unique.
    kind
        Which furniture it gets.
    rect
        x0, y0, x1, y1 of its inner faces in metres.
    label
        The place it is an example of.
    part
        Part of the building; "" if it has none.
    """

    name: str
    kind: str
    rect: Rect
    label: str
    part: str = ""

    @property
    def size(self) -> tuple[float, float]:
        """Width and depth in metres."""
        return self.rect[2] - self.rect[0], self.rect[3] - self.rect[1]

    def along(self, wall: int, low: float, high: float) -> tuple[float, float]:
        """Turn world coordinates along a wall into metres from the wall's left end, seen from inside."""
        x0, y0, x1, y1 = self.rect
        if wall == 0:
            return x1 - high, x1 - low
        if wall == 1:
            return y1 - high, y1 - low
        return (low - x0, high - x0) if wall == 2 else (low - y0, high - y0)


@dataclass(frozen=True)
class DoorPlan:
    """A door.

    Attributes
    ----------
    rooms
        Names of the two rooms it connects; the leaf swings into the last one. A closed door has one.
    kind
        "door", "open" (no leaf), "glass" (a leaf of glass) or "closed" (never opened, leads nowhere).
    position
        Of its middle along the shared wall, from 0 (south or west) to 1.
    width, height
        Metres.
    side
        Of a closed door: the side of the room.
    """

    rooms: tuple[str, ...]
    kind: str = "door"
    position: float = 0.5
    width: float = 0.85
    height: float = 2.05
    side: str = ""


@dataclass(frozen=True)
class WindowPlan:
    """A window.

    Attributes
    ----------
    room
        Name of its room.
    side
        "south", "east", "north" or "west".
    start, end
        World coordinates along the side, metres.
    sill, top
        Heights in metres.
    """

    room: str
    side: str
    start: float
    end: float
    sill: float
    top: float


@dataclass(frozen=True)
class Doorway:
    """Where a door is.

    Attributes
    ----------
    rect
        x0, y0, x1, y1 of the opening in the wall, from face to face, metres.
    walls
        The wall of each of its rooms.
    """

    rect: Rect
    walls: tuple[int, ...]

    @property
    def middle(self) -> tuple[float, float]:
        """World x and y."""
        x0, y0, x1, y1 = self.rect
        return (x0 + x1) / 2, (y0 + y1) / 2


@dataclass(frozen=True)
class FloorPlan:
    """One floor of a building.

    Attributes
    ----------
    name
        E.g. "home_1".
    height
        Of all ceilings, metres.
    rooms, doors, windows
        What it consists of. Rooms whose name occurs in no window get windows from `windowed`.
    windowless
        Names of rooms that get none.
    glazing
        How much of the outer walls `windowed` makes windows, 0 to 1.
    """

    name: str
    height: float
    rooms: tuple[RoomPlan, ...]
    doors: tuple[DoorPlan, ...]
    windows: tuple[WindowPlan, ...] = ()
    windowless: tuple[str, ...] = ()
    glazing: float = 0.4

    @classmethod
    def from_dict(cls, name: str, plan: Mapping[str, Any]) -> "FloorPlan":
        """Read a plan as it comes from YAML, and check it.

        Parameters
        ----------
        name
            Of the plan.
        plan
            `height`, `rooms` (by name: `kind`, `rect`, and optionally `label` and `part`), `doors` (`rooms`,
            optionally `kind`, `position`, `width`, `height`, `side`), and optionally `windows` (`room`,
            `side`, `width`, optionally `position`, `sill`, `top`), `windowless` (rooms without windows) and
            `glazing`.

        Returns
        -------
        FloorPlan
            Checked.

        Raises
        ------
        PlacecatError
            If the plan is impossible.
        """
        refuse_unknown(plan, ["name", "height", "rooms", "doors", "windows", "windowless", "glazing"], name)
        rooms = tuple(_room(name, key, value) for key, value in plan["rooms"].items())
        doors = tuple(_door(name, value) for value in plan["doors"])
        by_name = {room.name: room for room in rooms}
        windows = tuple(_window(name, by_name, value) for value in plan.get("windows", ()))
        windowless = tuple(str(room) for room in plan.get("windowless", ()))
        height, glazing = float(plan["height"]), float(plan.get("glazing", 0.4))
        made = cls(name, height, rooms, doors, windows, windowless, glazing)
        made.check()
        return made

    def room(self, name: str) -> RoomPlan:
        """Find a room by its name."""
        for room in self.rooms:
            if room.name == name:
                return room
        raise PlacecatError(f"{self.name} has no room {name!r}")

    def check(self) -> None:
        """Raise PlacecatError if rooms overlap, doors have no wall or room, or a room cannot be reached."""
        for room in self.rooms:
            if min(room.size) < 0.9:
                raise PlacecatError(f"{self.name}: {room.name} is narrower than 0.9 m")
        for a, b in combinations(self.rooms, 2):
            if _apart(a.rect, b.rect) < 0.05:
                raise PlacecatError(f"{self.name}: {a.name} and {b.name} overlap or share no wall of 0.05 m")
        taken: list[tuple[Rect, DoorPlan]] = []
        for door in self.doors:
            rect = self.doorway(door).rect
            for other, which in taken:
                if _apart(rect, other) < 0.1:
                    raise PlacecatError(f"{self.name}: doors {door.rooms} and {which.rooms} overlap")
            taken.append((rect, door))
        reached = {self.rooms[0].name}
        for _ in self.rooms:
            for door in self.doors:
                if door.kind != "closed" and reached & set(door.rooms):
                    reached |= set(door.rooms)
        for room in self.rooms:
            if room.name not in reached:
                raise PlacecatError(f"{self.name}: no way leads to {room.name}")

    def doorway(self, door: DoorPlan) -> Doorway:
        """Work out where a door is.

        Raises
        ------
        PlacecatError
            If there is no wall for it.
        """
        if door.kind == "closed":
            room, wall = self.room(door.rooms[0]), SIDES.index(door.side)
            low, high, face, _ = _side(room.rect, wall)
            low, high = self._between(door, low, high)
            beyond = face + (OUTER_WALL / 2 if wall in (1, 2) else -OUTER_WALL / 2)
            return Doorway(_rect(wall, low, high, face, beyond), (wall,))
        a, b = (self.room(name) for name in door.rooms)
        for wall in range(4):
            low_a, high_a, face_a, outwards = _side(a.rect, wall)
            low_b, high_b, face_b, _ = _side(b.rect, (wall + 2) % 4)
            low, high = max(low_a, low_b), min(high_a, high_b)
            if 0 < (face_b - face_a) * outwards <= _THICKEST and high - low > 0.5:
                low, high = self._between(door, low, high)
                return Doorway(_rect(wall, low, high, face_a, face_b), (wall, (wall + 2) % 4))
        raise PlacecatError(f"{self.name}: {a.name} and {b.name} share no wall for a door")

    def _between(self, door: DoorPlan, low: float, high: float) -> tuple[float, float]:
        margin = 0.08
        if high - low < door.width + 2 * margin:
            raise PlacecatError(
                f"{self.name}: the door {' - '.join(door.rooms)} needs {door.width + 2 * margin:.2f} m of "
                f"wall, there are {high - low:.2f} m"
            )
        start = low + margin + door.position * (high - low - 2 * margin - door.width)
        return start, start + door.width

    def openings(self, name: str, seed: int) -> tuple[Opening, ...]:
        """List the doors and windows of a room in its own frame.

        Parameters
        ----------
        name
            Of the room.
        seed
            Of the side on which doors have their hinges.

        Returns
        -------
        tuple[Opening, ...]
            Doors in the order of the plan, then windows.
        """
        room = self.room(name)
        found = []
        for door in self.doors:
            if name not in door.rooms:
                continue
            way = self.doorway(door)
            wall = way.walls[door.rooms.index(name)]
            start, end = room.along(wall, *_extent(way.rect, wall))
            leaf = door.kind in ("door", "glass") and name == door.rooms[-1]
            hinge = self.hinge(door, seed)
            passage = door.kind != "closed"
            found.append(Opening(wall, start, end, 0.0, door.height, "door", leaf, hinge, passage))
        for window in self.windows:
            if window.room == name:
                wall = SIDES.index(window.side)
                start, end = room.along(wall, window.start, window.end)
                found.append(Opening(wall, start, end, window.sill, window.top))
        return tuple(found)

    def hinge(self, door: DoorPlan, seed: int) -> str:
        """Tell the side of a door's hinge, as seen from the room it swings into: the nearer corner."""
        left, right = self._corners(door)
        if abs(left - right) < 0.3:
            return ("left", "right")[derive("hinge", self.name, *door.rooms, seed) % 2]
        return "left" if left < right else "right"

    def corner(self, door: DoorPlan, seed: int) -> float:
        """Give the metres from a door's hinge to the corner of the room it swings into."""
        return self._corners(door)[0 if self.hinge(door, seed) == "left" else 1]

    def _corners(self, door: DoorPlan) -> tuple[float, float]:
        """Metres from a door to the left and right corner of the room it swings into."""
        way, room = self.doorway(door), self.room(door.rooms[-1])
        wall = way.walls[-1]
        start, end = room.along(wall, *_extent(way.rect, wall))
        return start, room.size[wall % 2] - end

    def windowed(self, seed: int) -> "FloorPlan":
        """Add windows to the outer walls of rooms for which the plan gives none.

        Parameters
        ----------
        seed
            Of their sizes and places.

        Returns
        -------
        FloorPlan
            With all windows.
        """
        rng = np.random.default_rng(derive("windows", self.name, seed))
        sill, top = float(rng.uniform(0.8, 0.95)), min(float(rng.uniform(2.05, 2.3)), self.height - 0.18)
        width = float(rng.uniform(0.95, 1.5))
        given = {window.room for window in self.windows} | set(self.windowless)
        windows = list(self.windows)
        for room in self.rooms:
            if room.name not in given:
                draw = np.random.default_rng(derive("windows", self.name, room.name, seed))
                windows += self._windows(room, sill, top, width, draw)
        return replace(self, windows=tuple(windows))

    def _windows(
        self, room: RoomPlan, sill: float, top: float, width: float, rng: np.random.Generator
    ) -> list[WindowPlan]:
        stretches = [(wall, *stretch) for wall in range(4) for stretch in self._outer(room, wall)]
        stretches.sort(key=lambda stretch: stretch[1] - stretch[2])
        area = room.size[0] * room.size[1]
        small = area < 9.6
        windows = []
        for wall, low, high in stretches[: 1 if area < 13.0 else 2]:
            length = high - low
            count = max(1, round(self.glazing * length / width))
            if small:
                count = min(count, 1)
            wide = min(float(width * rng.uniform(0.85, 1.15)) * (0.7 if small else 1.0), length - 0.6)
            if wide < 0.45:
                continue
            count = min(count, int((length - 0.4) / (wide + 0.3)) or 1, 3 if length < 8 else 6)
            lift = 0.3 if small else (0.2 if room.label == "kitchen" else 0.0)
            step = length / count
            shift = float(rng.uniform(-0.5, 0.5)) * min(step - wide - 0.3, 1.0) if count == 1 else 0.0
            balcony = lift == 0.0 and count == 1 and self.glazing < 0.6 and rng.random() < 0.25
            for k in range(count):
                middle = low + (k + 0.5) * step + shift
                windows.append(
                    WindowPlan(
                        room.name,
                        SIDES[wall],
                        middle - wide / 2,
                        middle + wide / 2,
                        0.12 if balcony else sill + lift,
                        top,
                    )
                )
        return windows

    def _outer(self, room: RoomPlan, wall: int) -> list[tuple[float, float]]:
        """Stretches of a wall behind which nothing is built, and no closed door is."""
        low, high, face, outwards = _side(room.rect, wall)
        covered = []
        for other in self.rooms:
            if other.name == room.name:
                continue
            start, end, near, _ = _side(other.rect, (wall + 2) % 4)
            if 0 < (near - face) * outwards < _VIEW:
                covered.append((start - 0.3, end + 0.3))
        for door in self.doors:
            if door.kind == "closed" and door.rooms[0] == room.name and SIDES.index(door.side) == wall:
                start, end = _extent(self.doorway(door).rect, wall)
                covered.append((start - 0.15, end + 0.15))
        stretches, position = [], low
        for start, end in sorted((max(a, low), min(b, high)) for a, b in covered if a < high and b > low):
            if start - position > 1.0:
                stretches.append((position, start))
            position = max(position, end)
        if high - position > 1.0:
            stretches.append((position, high))
        return stretches


def _side(rect: Rect, wall: int) -> tuple[float, float, float, int]:
    """Where a side starts and ends, where it is across, and the sign of outwards."""
    x0, y0, x1, y1 = rect
    return ((x0, x1, y0, -1), (y0, y1, x1, 1), (x0, x1, y1, 1), (y0, y1, x0, -1))[wall]


def _rect(wall: int, low: float, high: float, face: float, beyond: float) -> Rect:
    near, far = min(face, beyond), max(face, beyond)
    return (low, near, high, far) if wall % 2 == 0 else (near, low, far, high)


def _extent(rect: Rect, wall: int) -> tuple[float, float]:
    return (rect[0], rect[2]) if wall % 2 == 0 else (rect[1], rect[3])


def _apart(a: Rect, b: Rect) -> float:
    """Gap between two rectangles along an axis, negative if they overlap."""
    return max(a[0] - b[2], b[0] - a[2], a[1] - b[3], b[1] - a[3])


def _room(plan: str, name: str, value: Mapping[str, Any]) -> RoomPlan:
    where = f"{plan}, room {name}"
    refuse_unknown(value, ["kind", "rect", "label", "part"], where)
    rect = _numbers(value["rect"], where)
    if not (rect[0] < rect[2] and rect[1] < rect[3]):
        raise PlacecatError(f"{where}: rect must be [x0, y0, x1, y1] with x0 < x1 and y0 < y1")
    kind = str(value["kind"])
    return RoomPlan(name, kind, rect, str(value.get("label", kind)), str(value.get("part", "")))


def _numbers(values: Sequence[Any], where: str) -> Rect:
    if len(values) != 4:
        raise PlacecatError(f"{where}: rect needs four numbers")
    x0, y0, x1, y1 = (float(value) for value in values)
    return x0, y0, x1, y1


def _door(plan: str, value: Mapping[str, Any]) -> DoorPlan:
    rooms = tuple(str(room) for room in value["rooms"])
    where = f"{plan}, door {' - '.join(rooms)}"
    refuse_unknown(value, ["rooms", "kind", "position", "width", "height", "side"], where)
    door = DoorPlan(rooms, **{key: part for key, part in value.items() if key != "rooms"})
    if door.kind not in _DOOR_KINDS:
        raise PlacecatError(f"{where}: kind must be one of {', '.join(_DOOR_KINDS)}")
    if len(rooms) != (1 if door.kind == "closed" else 2):
        raise PlacecatError(f"{where}: a closed door has one room, any other two")
    if door.kind == "closed" and door.side not in SIDES:
        raise PlacecatError(f"{where}: side must be one of {', '.join(SIDES)}")
    if not (0.0 <= door.position <= 1.0 and door.width >= 0.7):
        raise PlacecatError(f"{where}: position must be in [0, 1], and width at least 0.7")
    return door


def _window(plan: str, rooms: Mapping[str, RoomPlan], value: Mapping[str, Any]) -> WindowPlan:
    name = str(value["room"])
    where = f"{plan}, window of {name}"
    refuse_unknown(value, ["room", "side", "width", "position", "sill", "top"], where)
    if name not in rooms or value["side"] not in SIDES:
        raise PlacecatError(f"{where}: no such room or side")
    low, high, _, _ = _side(rooms[name].rect, SIDES.index(value["side"]))
    width, margin = float(value["width"]), 0.15
    if width > high - low - 2 * margin:
        raise PlacecatError(f"{where} is wider than its wall")
    start = low + margin + float(value.get("position", 0.5)) * (high - low - 2 * margin - width)
    sill, top = float(value.get("sill", 0.9)), float(value.get("top", 2.15))
    return WindowPlan(name, str(value["side"]), start, start + width, sill, top)
