"""Rooms, doors and windows of a floor plan, and their positions.

The sides of a room are south (y0), east (x1), north (y1) and west (x0). They correspond to walls 0 to 3 of
`Room`.
"""

from dataclasses import dataclass

SIDES = ("south", "east", "north", "west")
"""Names of walls 0 to 3."""

Rect = tuple[float, float, float, float]


@dataclass(frozen=True)
class RoomPlan:
    """A room.

    Attributes
    ----------
    name
        Unique name of the room.
    kind
        Kind of room, which determines its furniture.
    rect
        x0, y0, x1, y1 of its inner faces in metres.
    label
        Label of the frames in this room.
    part
        Part of the building where the room is; "" if the building has no parts.
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
        """Convert world coordinates along a wall to metres from its left end, as seen from inside."""
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
        Names of the two rooms that it connects. The leaf swings into the second. A closed door has only one
        room.
    kind
        "door", "open" (no leaf), "glass" (a glass leaf) or "closed" (never opened; leads nowhere).
    position
        Position of its middle along the shared wall, from 0 (south or west) to 1.
    width, height
        Metres.
    side
        For a closed door, the side of the room where it is.
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
        Name of the room.
    side
        "south", "east", "north" or "west".
    start, end
        World coordinates along the side in metres.
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
    """Position of a door.

    Attributes
    ----------
    rect
        x0, y0, x1, y1 of the opening in the wall, from face to face, in metres.
    walls
        For each of the door's rooms, the number of the wall that contains the door.
    """

    rect: Rect
    walls: tuple[int, ...]

    @property
    def middle(self) -> tuple[float, float]:
        """World coordinates x and y of the middle of the opening."""
        x0, y0, x1, y1 = self.rect
        return (x0 + x1) / 2, (y0 + y1) / 2


def side(rect: Rect, wall: int) -> tuple[float, float, float, int]:
    """Return both ends of a side, its position on the other axis, and the sign of the outward direction."""
    x0, y0, x1, y1 = rect
    return ((x0, x1, y0, -1), (y0, y1, x1, 1), (x0, x1, y1, 1), (y0, y1, x0, -1))[wall]


def rect(wall: int, low: float, high: float, face: float, beyond: float) -> Rect:
    """Return the rectangle from `low` to `high` along a wall, and from `face` to `beyond` across it."""
    near, far = min(face, beyond), max(face, beyond)
    return (low, near, high, far) if wall % 2 == 0 else (near, low, far, high)


def extent(rect: Rect, wall: int) -> tuple[float, float]:
    """Return the start and end of a rectangle along a wall."""
    return (rect[0], rect[2]) if wall % 2 == 0 else (rect[1], rect[3])


def apart(a: Rect, b: Rect) -> float:
    """Return the gap between two rectangles along x or y, whichever is larger; negative if they overlap."""
    return max(a[0] - b[2], b[0] - a[2], a[1] - b[3], b[1] - a[3])
