"""A room with the objects already in it, and checks for whether another one fits."""

from collections.abc import Sequence

import numpy as np

from placecat_homes.mesh import Mesh, join
from placecat_homes.placing.free_floor import FreeFloor
from placecat_homes.placing.lattice import Bools
from placecat_homes.placing.opening import Opening
from placecat_homes.placing.placed import Floats, Placed
from placecat_homes.placing.walls import Walls

# Heights in metres. Objects entirely above HEAD or below FLAT are not in the way.
HEAD = 1.9
FLAT = 0.08

_SHALLOW = 0.15


class Occupied(Walls):
    """Four walls with objects between them.

    Attributes
    ----------
    placed
        All objects placed in the room so far.
    blocking
        The objects that people must walk around.
    """

    def __init__(self, size: tuple[float, float, float], openings: Sequence[Opening]) -> None:
        """Start without objects. `size` is width, depth and height."""
        super().__init__(size, openings)
        self.placed: list[Placed] = []
        self.blocking: list[Placed] = []
        self._boxes: list[Floats] = []
        self._fronts: list[Floats] = []
        self._zones = [self._zone(door) for door in self.doors]
        self._floor = FreeFloor(self)

    def mesh(self) -> Mesh:
        """All placed objects in the frame of the room."""
        return join(thing.mesh() for thing in self.placed)

    def walkable(self) -> bool:
        """Return whether all doors are connected by free floor."""
        return self._floor.is_connected()

    def _keep(self, thing: Placed, blocks: bool | None = None) -> Placed:
        self.placed.append(thing)
        self._boxes.append(self._bulk(thing))
        if self._blocks(thing) if blocks is None else blocks:
            self.blocking.append(thing)
            self._floor.block(thing)
        return thing

    def _walkable_with(self, thing: Placed) -> bool:
        return not self._blocks(thing) or self._floor.allows(thing)

    @staticmethod
    def _clear(rects: Floats, z0: float, z1: float, boxes: Sequence[Floats]) -> Bools:
        """Return which of the (n, 4) rectangles, extended from height z0 to z1, touch no box."""
        if len(boxes) == 0:
            return np.ones(len(rects), bool)
        b = np.array(boxes)
        b = b[(b[:, 4] < z1 - 0.005) & (z0 < b[:, 5] - 0.005)]
        r, slack = rects[:, None, :], 0.008
        meets = (
            (r[..., 0] < b[:, 2] - slack)
            & (b[:, 0] < r[..., 2] - slack)
            & (r[..., 1] < b[:, 3] - slack)
            & (b[:, 1] < r[..., 3] - slack)
        )
        return np.asarray(~meets.any(axis=1))

    def _bulk(self, thing: Placed) -> Floats:
        """Return an object's box, at least 0.12 m deep for objects on walls, so that nothing hides them."""
        box = thing.box()
        if thing.wall is not None and thing.z > 0.3:
            near = min(max(self.back(thing, thing.wall), 0.0), 0.12)
            side = (1, 2, 3, 0)[thing.wall]
            if near < 0.05:
                box[side] = (0.0, self.width, self.depth, 0.0)[thing.wall]
                far = (3, 0, 1, 2)[thing.wall]
                inner = box[side] + (0.12 if thing.wall in (0, 3) else -0.12)
                box[far] = max(box[far], inner) if thing.wall in (0, 3) else min(box[far], inner)
        return box

    def _zone(self, door: Opening) -> Floats:
        """Return the floor area in front of a door that must be kept free."""
        deep = 0.1 if not door.passage else (door.width + 0.05 if door.leaf else 0.6)
        start, end = door.start - 0.05, door.end + 0.05
        if door.leaf and door.hinge == "left":
            start -= 0.2
        elif door.leaf:
            end += 0.2
        rect = self.strip(door.wall, np.array([start]), np.array([end]), 0.0, deep)[0]
        return np.r_[rect, 0.0, 2.1]

    @staticmethod
    def _blocks(thing: Placed) -> bool:
        """Return whether people must walk around an object."""
        z0, z1 = thing.z + float(thing.model.low[2]), thing.z + float(thing.model.high[2])
        shallow = thing.wall is not None and float(thing.model.size[1]) < _SHALLOW
        return z0 < HEAD and z1 > FLAT and not shallow
