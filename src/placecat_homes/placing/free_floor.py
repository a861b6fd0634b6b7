"""Keep track of the free floor of a room, and check whether people can still walk through it."""

import numpy as np
from scipy import ndimage

from placecat_homes.placing.lattice import CELL, Bools, drawn, room_for_person
from placecat_homes.placing.opening import Opening
from placecat_homes.placing.placed import Floats, Placed
from placecat_homes.placing.walls import Walls

_WIDE = 0.28
_PAD = 8
_POCKET = 0.5


class FreeFloor:
    """The floor between four walls, and the doors that lead to it.

    Parameters
    ----------
    walls
        The walls around the floor.
    """

    def __init__(self, walls: Walls) -> None:
        self._walls = walls
        self._sills: list[tuple[int, int]] = []
        self._solid = self._empty()

    def block(self, thing: Placed) -> None:
        """Remove the footprint of an object from the free floor."""
        self._solid |= self._drawn(thing)

    def is_connected(self) -> bool:
        """Return whether all doors are connected by free floor."""
        return self._reached(self._solid)[0]

    def distances(self) -> Floats:
        """Return the distance from each cell between the walls to the nearest blocked cell, in cells."""
        distances = ndimage.distance_transform_edt(~self._solid)
        return np.asarray(distances[_PAD:-_PAD, _PAD:-_PAD])

    def allows(self, thing: Placed) -> bool:
        """Return whether adding an object keeps all doors connected and enough floor reachable."""
        if not self._sills:
            return True
        before, _ = self._reached(self._solid)
        solid = self._solid | self._drawn(thing)
        after, still = self._reached(solid)
        if not after:
            return not before
        lost = room_for_person(solid, _WIDE) & ~still
        inside = np.s_[_PAD:-_PAD, _PAD:-_PAD]
        least = 0.4 + 0.08 * self._walls.width * self._walls.depth
        if still[inside].sum() * CELL**2 < least:
            return False
        return bool(lost.sum() * CELL**2 < _POCKET)

    def _reached(self, solid: Bools) -> tuple[bool, Bools]:
        """Return whether all doors are connected, and which cells can be reached from the first door."""
        labels, _ = ndimage.label(room_for_person(solid, _WIDE))
        numbers = {int(labels[cell]) for cell in self._sills}
        if not numbers:
            return True, labels > 0
        connected = len(numbers) == 1 and 0 not in numbers
        return connected, labels == labels[self._sills[0]] if connected else np.zeros(solid.shape, bool)

    def _empty(self) -> Bools:
        nx, ny = (round(value / CELL) for value in (self._walls.width, self._walls.depth))
        solid = np.ones((nx + 2 * _PAD, ny + 2 * _PAD), bool)
        solid[_PAD : _PAD + nx, _PAD : _PAD + ny] = False
        for door in self._walls.doors:
            if not door.passage:
                continue
            ends = np.array([door.start]), np.array([door.end])
            x0, y0, x1, y1 = self._walls.strip(door.wall, *ends, -_PAD * CELL, CELL)[0]
            i, j = self._cell(x0, y0), self._cell(x1, y1)
            solid[max(i[0], 0) : j[0], max(i[1], 0) : j[1]] = False
            if door.leaf:
                solid |= drawn(self._swing(door), (-_PAD * CELL, -_PAD * CELL), solid.shape)
            cell = self._cell(*self._walls.point(door.wall, door.middle, -3 * CELL))
            self._sills.append((min(cell[0], solid.shape[0] - 1), min(cell[1], solid.shape[1] - 1)))
        return solid

    def _swing(self, door: Opening) -> Floats:
        """Return the counter-clockwise corners of the floor area that an open door leaf takes up."""
        inwards = 1.0 if door.hinge == "left" else -1.0
        hinge = door.start if door.hinge == "left" else door.end
        tips = [(hinge + inwards * side, door.width) for side in (0.1, -0.1)]
        foot = [(hinge + inwards * side, 0.0) for side in (0.0, 0.05)]
        points = np.array([self._walls.point(door.wall, along, deep) for along, deep in (*tips, *foot)])
        (ax, ay), (bx, by) = points[1] - points[0], points[2] - points[1]
        return points if ax * by - ay * bx > 0 else points[::-1]

    @staticmethod
    def _cell(x: float, y: float) -> tuple[int, int]:
        return round(x / CELL + 1e-6) + _PAD, round(y / CELL + 1e-6) + _PAD

    def _drawn(self, thing: Placed) -> Bools:
        return drawn(thing.corners(), (-_PAD * CELL, -_PAD * CELL), self._solid.shape)
