"""The floor of a building as a lattice, including which cells a person or robot can be in."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

DOORWAY = -2
"""Index of a door opening in `Ground.room`."""


@dataclass(frozen=True, eq=False)
class Ground:
    """The floor of a building.

    Attributes
    ----------
    cell
        Width of a lattice cell in metres.
    origin
        World coordinates x, y of the corner of cell (0, 0). The centre of cell (i, j) is origin + (i + 0.5, j
        + 0.5) * cell.
    free
        (nx, ny), true for cells where a person with a radius of 0.25 m can stand. All free cells are
        connected.
    room
        (nx, ny), index into `names`; -1 outside and in walls, -2 in door openings.
    names
        Unique names of the rooms.
    kinds
        Labels of the rooms.
    rects
        Coordinates x0, y0, x1, y1 of each room.
    doors
        For each opening: room, other room, and world x and y of its middle.
    windows
        For each window: room, and world x and y of its middle.
    items
        For each larger piece of furniture: room, world x and y, and height.
    """

    cell: float
    origin: tuple[float, float]
    free: NDArray[np.bool_]
    room: NDArray[np.int16]
    names: tuple[str, ...]
    kinds: tuple[str, ...]
    rects: tuple[tuple[float, float, float, float], ...]
    doors: tuple[tuple[int, int, float, float], ...]
    windows: tuple[tuple[int, float, float], ...] = ()
    items: tuple[tuple[int, float, float, float], ...] = ()

    def cells(self, points: NDArray[np.float64]) -> NDArray[np.int64]:
        """Return the (n, 2) cells of (n, 2) points. Points outside the lattice are moved to its border."""
        indices = np.floor((np.asarray(points) - self.origin) / self.cell).astype(np.int64)
        return np.clip(indices, 0, np.array(self.free.shape) - 1)

    def points(self, cells: NDArray[np.int64]) -> NDArray[np.float64]:
        """Return the (n, 2) centres of (n, 2) cells."""
        return np.asarray(self.origin) + (np.asarray(cells) + 0.5) * self.cell

    def is_free(self, points: NDArray[np.float64]) -> NDArray[np.bool_]:
        """Return, for each of the (n, 2) points, whether a person can stand there."""
        i, j = self.cells(points).T
        return self.free[i, j]

    def room_at(self, points: NDArray[np.float64]) -> NDArray[np.int16]:
        """Return the room index of each of the (n, 2) points."""
        i, j = self.cells(points).T
        return self.room[i, j]

    def nearest_free(self, points: NDArray[np.float64]) -> NDArray[np.float64]:
        """Move those of the (n, 2) points that are not free to the centre of the nearest free cell."""
        moved = np.array(points, dtype=np.float64)
        blocked = np.flatnonzero(~self.is_free(moved))
        if len(blocked):
            middles = self.points(np.argwhere(self.free))
            for k in blocked:
                moved[k] = middles[np.argmin(((middles - moved[k]) ** 2).sum(axis=1))]
        return moved
