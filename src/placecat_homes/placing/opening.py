"""Doors and windows in the walls of a room, and free stretches of wall."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Opening:
    """A door or window in a wall of a room.

    Attributes
    ----------
    wall
        0 to 3.
    start, end
        Metres along the wall.
    sill, top
        Heights in metres; the sill of a door is 0.
    kind
        "window" or "door".
    leaf
        Whether a door leaf swings into this room.
    hinge
        Hinge side of a door leaf, as seen from inside this room: "left" or "right".
    passage
        Whether people can walk through it; false for windows and doors that stay closed.
    """

    wall: int
    start: float
    end: float
    sill: float
    top: float
    kind: str = "window"
    leaf: bool = False
    hinge: str = "left"
    passage: bool = False

    @property
    def width(self) -> float:
        """Metres along the wall."""
        return self.end - self.start

    @property
    def middle(self) -> float:
        """Position of the middle in metres along the wall."""
        return (self.start + self.end) / 2


@dataclass(frozen=True)
class Span:
    """A free stretch of wall.

    Attributes
    ----------
    wall
        0 to 3.
    start, length
        Metres along the wall.
    """

    wall: int
    start: float
    length: float
