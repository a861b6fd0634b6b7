"""Floor plans with rectangular rooms, doors between them, and windows."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from itertools import combinations
from typing import Any

import numpy as np

from placecat.errors import PlacecatError
from placecat.seeds import derive
from placecat.settings import refuse_unknown
from placecat_homes import plan_parts
from placecat_homes.placing.opening import Opening
from placecat_homes.plan_parts import SIDES, DoorPlan, Doorway, Rect, RoomPlan, WindowPlan, apart, extent
from placecat_homes.plan_reading import read_door, read_room, read_window

OUTER_WALL = 0.3
"""Thickness of outer walls in metres."""

_THICKEST = 0.4
_VIEW = 2.0


@dataclass(frozen=True)
class FloorPlan:
    """One floor of a building.

    Attributes
    ----------
    name
        Name of the plan, such as "home_1".
    height
        Height of all ceilings in metres.
    rooms, doors, windows
        The parts of the plan. `windowed` adds windows to rooms that have none.
    windowless
        Names of rooms to which `windowed` adds no windows.
    glazing
        Share of the outer walls that `windowed` fills with windows, from 0 to 1.
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
        """Create a plan from YAML data and check it.

        Parameters
        ----------
        name
            Name of the plan.
        plan
            `height`, `rooms` by name, `doors`, and optionally `windows`, `windowless` (names of rooms) and
            `glazing`. A room has `kind`, `rect`, and optionally `label` and `part`. A door has `rooms`, and
            optionally `kind`, `position`, `width`, `height` and `side`. A window has `room`, `side`, `width`,
            and optionally `position`, `sill` and `top`.

        Returns
        -------
        FloorPlan
            The checked plan.

        Raises
        ------
        PlacecatError
            If the plan is invalid.
        """
        refuse_unknown(plan, ["name", "height", "rooms", "doors", "windows", "windowless", "glazing"], name)
        rooms = tuple(read_room(name, key, value) for key, value in plan["rooms"].items())
        doors = tuple(read_door(name, value) for value in plan["doors"])
        by_name = {room.name: room for room in rooms}
        windows = tuple(read_window(name, by_name, value) for value in plan.get("windows", ()))
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
        """Raise PlacecatError if rooms overlap, a door lacks a wall or room, or a room is unreachable."""
        for room in self.rooms:
            if min(room.size) < 0.9:
                raise PlacecatError(f"{self.name}: {room.name} is narrower than 0.9 m")
        for a, b in combinations(self.rooms, 2):
            if apart(a.rect, b.rect) < 0.05:
                raise PlacecatError(
                    f"{self.name}: {a.name} and {b.name} overlap or are less than 0.05 m apart"
                )
        taken: list[tuple[Rect, DoorPlan]] = []
        for door in self.doors:
            rect = self.doorway(door).rect
            for other, which in taken:
                if apart(rect, other) < 0.1:
                    raise PlacecatError(f"{self.name}: doors {door.rooms} and {which.rooms} overlap")
            taken.append((rect, door))
        reached = {self.rooms[0].name}
        for _ in self.rooms:
            for door in self.doors:
                if door.kind != "closed" and reached & set(door.rooms):
                    reached |= set(door.rooms)
        for room in self.rooms:
            if room.name not in reached:
                raise PlacecatError(f"{self.name}: no door leads to {room.name}")

    def doorway(self, door: DoorPlan) -> Doorway:
        """Find the position of a door.

        Raises
        ------
        PlacecatError
            If no wall has room for the door.
        """
        if door.kind == "closed":
            room, wall = self.room(door.rooms[0]), SIDES.index(door.side)
            low, high, face, _ = plan_parts.side(room.rect, wall)
            low, high = self._between(door, low, high)
            beyond = face + (OUTER_WALL / 2 if wall in (1, 2) else -OUTER_WALL / 2)
            return Doorway(plan_parts.rect(wall, low, high, face, beyond), (wall,))
        a, b = (self.room(name) for name in door.rooms)
        for wall in range(4):
            low_a, high_a, face_a, outwards = plan_parts.side(a.rect, wall)
            low_b, high_b, face_b, _ = plan_parts.side(b.rect, (wall + 2) % 4)
            low, high = max(low_a, low_b), min(high_a, high_b)
            if 0 < (face_b - face_a) * outwards <= _THICKEST and high - low > 0.5:
                low, high = self._between(door, low, high)
                return Doorway(plan_parts.rect(wall, low, high, face_a, face_b), (wall, (wall + 2) % 4))
        raise PlacecatError(f"{self.name}: {a.name} and {b.name} share no wall with space for a door")

    def _between(self, door: DoorPlan, low: float, high: float) -> tuple[float, float]:
        margin = 0.08
        if high - low < door.width + 2 * margin:
            raise PlacecatError(
                f"{self.name}: the door {' - '.join(door.rooms)} needs {door.width + 2 * margin:.2f} m of "
                f"wall, but only {high - low:.2f} m is free"
            )
        start = low + margin + door.position * (high - low - 2 * margin - door.width)
        return start, start + door.width

    def openings(self, name: str, seed: int) -> tuple[Opening, ...]:
        """List the doors and windows of a room in the room's frame.

        Parameters
        ----------
        name
            Name of the room.
        seed
            Seed that determines which side each door is hinged on.

        Returns
        -------
        tuple[Opening, ...]
            The doors in the order of the plan, followed by the windows.
        """
        room = self.room(name)
        found = []
        for door in self.doors:
            if name not in door.rooms:
                continue
            way = self.doorway(door)
            wall = way.walls[door.rooms.index(name)]
            start, end = room.along(wall, *extent(way.rect, wall))
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
        """Return the hinge side of a door, seen from the room it swings into: the side closer to a corner."""
        left, right = self._corners(door)
        if abs(left - right) < 0.3:
            return ("left", "right")[derive("hinge", self.name, *door.rooms, seed) % 2]
        return "left" if left < right else "right"

    def corner(self, door: DoorPlan, seed: int) -> float:
        """Return the distance in metres from a door's hinge to the corner of the room it swings into."""
        return self._corners(door)[0 if self.hinge(door, seed) == "left" else 1]

    def _corners(self, door: DoorPlan) -> tuple[float, float]:
        """Return how far, in metres, a door is from the left and right corners of the room it swings into."""
        way, room = self.doorway(door), self.room(door.rooms[-1])
        wall = way.walls[-1]
        start, end = room.along(wall, *extent(way.rect, wall))
        return start, room.size[wall % 2] - end

    def windowed(self, seed: int) -> "FloorPlan":
        """Add windows to the outer walls of all rooms that have none in the plan.

        Parameters
        ----------
        seed
            Seed for the sizes and positions of the windows.

        Returns
        -------
        FloorPlan
            The plan with all windows.
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
        """Return the stretches of a wall that have no room behind them and no closed door in them."""
        low, high, face, outwards = plan_parts.side(room.rect, wall)
        covered = []
        for other in self.rooms:
            if other.name == room.name:
                continue
            start, end, near, _ = plan_parts.side(other.rect, (wall + 2) % 4)
            if 0 < (near - face) * outwards < _VIEW:
                covered.append((start - 0.3, end + 0.3))
        for door in self.doors:
            if door.kind == "closed" and door.rooms[0] == room.name and SIDES.index(door.side) == wall:
                start, end = extent(self.doorway(door).rect, wall)
                covered.append((start - 0.15, end + 0.15))
        stretches, position = [], low
        for start, end in sorted((max(a, low), min(b, high)) for a, b in covered if a < high and b > low):
            if start - position > 1.0:
                stretches.append((position, start))
            position = max(position, end)
        if high - position > 1.0:
            stretches.append((position, high))
        return stretches
