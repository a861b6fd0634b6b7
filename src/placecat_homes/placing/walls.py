"""The walls of a room, with their openings and positions along them.

Walls are numbered from 0 to 3. An object with its back to wall k is rotated by 90 k degrees. Wall 0 is y = 0,
wall 1 is x = width, wall 2 is y = depth, and wall 3 is x = 0. Positions along a wall are measured in metres
from its left end, as seen from inside.
"""

from collections.abc import Sequence

import numpy as np

from placecat_homes.mesh import Mesh
from placecat_homes.placing.opening import Opening
from placecat_homes.placing.placed import Floats, Placed


class Walls:
    """Four walls around a floor.

    Attributes
    ----------
    width, depth, height
        Metres; x runs from 0 to width, y from 0 to depth.
    openings
        Doors and windows.
    """

    def __init__(self, size: tuple[float, float, float], openings: Sequence[Opening]) -> None:
        """Build the walls. `size` is width, depth and height."""
        self.width, self.depth, self.height = (float(value) for value in size)
        self.openings = tuple(openings)

    @property
    def windows(self) -> list[Opening]:
        """The windows."""
        return [opening for opening in self.openings if opening.kind == "window"]

    @property
    def doors(self) -> list[Opening]:
        """The doors."""
        return [opening for opening in self.openings if opening.kind == "door"]

    def length(self, wall: int) -> float:
        """Length of a wall from corner to corner, in metres."""
        return self.width if wall % 2 == 0 else self.depth

    def point(self, wall: int, along: float, inwards: float) -> tuple[float, float]:
        """Return the point (x, y) at a position along a wall and `inwards` metres away from it."""
        w, d = self.width, self.depth
        return (
            (w - along, inwards),
            (w - inwards, d - along),
            (along, d - inwards),
            (inwards, along),
        )[wall]

    def along(self, wall: int, x: float, y: float) -> float:
        """Return the position along a wall that is nearest to x, y."""
        return float((self.width - x, self.depth - y, x, y)[wall])

    def back(self, thing: Placed, wall: int) -> float:
        """Return the distance from a wall to an object's back, which is negative beyond the wall."""
        box = thing.box()
        return float((box[1], self.width - box[2], self.depth - box[3], box[0])[wall])

    def ends(self, thing: Placed, wall: int) -> tuple[float, float]:
        """Return the positions along a wall where an object starts and ends."""
        box = thing.box()
        a, b = self.along(wall, box[0], box[1]), self.along(wall, box[2], box[3])
        return min(a, b), max(a, b)

    def strip(self, wall: int, start: Floats, end: Floats, near: float, far: float) -> Floats:
        """Return (n, 4) rectangles in front of a wall."""
        w, d = self.width, self.depth
        low, high = np.full_like(start, near), np.full_like(start, far)
        columns = (
            (w - end, low, w - start, high),
            (w - high, d - end, w - low, d - start),
            (start, d - high, end, d - low),
            (low, start, high, end),
        )[wall]
        return np.stack(columns, axis=1)

    def at_wall(self, model: Mesh, wall: int, place: float, z: float, gap: float) -> Placed:
        """Place an object with its middle at a position along a wall, and its back `gap` metres from it."""
        along = place + float(model.low[0] + model.high[0]) / 2
        x, y = self.point(wall, along, gap - float(model.low[1]))
        return Placed(model, x, y, z, 90.0 * wall, wall)

    def on_wall(self, wall: int) -> list[Opening]:
        """Return the openings in a wall."""
        return [opening for opening in self.openings if opening.wall == wall]

    def covers_opening(
        self, wall: int, ends: tuple[float, float], z0: float, z1: float, margin: float
    ) -> bool:
        """Return whether a stretch of wall, from height z0 to z1, comes within `margin` of an opening."""
        return any(
            opening.start - margin < ends[1]
            and ends[0] < opening.end + margin
            and opening.sill < z1
            and z0 < opening.top + margin
            for opening in self.on_wall(wall)
        )
