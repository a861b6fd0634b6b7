"""Objects placed in a room."""

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from placecat_homes.mesh import Mesh

Floats = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Placed:
    """An object that stands, hangs or lies in a room.

    Attributes
    ----------
    model
        The object in the frame of its mesh.
    x, y, z
        Position of the object's origin in the frame of the room, in metres.
    turn
        Angle in degrees, counter-clockwise as seen from above.
    wall
        The wall that it stands against or hangs on; None if it is free-standing.
    """

    model: Mesh
    x: float
    y: float
    z: float
    turn: float
    wall: int | None = None

    def mesh(self) -> Mesh:
        """Return the object in the frame of the room."""
        return self.model.turned(self.turn).moved(self.x, self.y, self.z)

    def corners(self) -> Floats:
        """Return the (4, 2) counter-clockwise corners of its footprint in the frame of the room."""
        (x0, y0), (x1, y1) = self.model.low[:2], self.model.high[:2]
        local = np.array([(x0, y0), (x1, y0), (x1, y1), (x0, y1)], dtype=np.float64)
        return local @ rotation(self.turn).T + (self.x, self.y)

    def box(self) -> Floats:
        """Return its bounding box in the frame of the room, as x0, y0, x1, y1, z0, z1."""
        corners = self.corners()
        z0, z1 = float(self.model.low[2]) + self.z, float(self.model.high[2]) + self.z
        return np.array([*corners.min(axis=0), *corners.max(axis=0), z0, z1])


def rotation(degrees: float) -> Floats:
    """Return the (2, 2) matrix of a counter-clockwise rotation."""
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    if degrees % 90 == 0:
        c, s = round(c), round(s)
    return np.array([[c, -s], [s, c]], dtype=np.float64)
