"""The floor as a lattice of cells, with footprints of objects and free space for people."""

import numpy as np
from numpy.typing import NDArray
from scipy import ndimage

from placecat_homes.placing.placed import Floats

CELL = 0.05
"""Edge length of the floor lattice's cells in metres."""

PERSON = 0.25
"""Radius in metres of a person walking."""

Bools = NDArray[np.bool_]


def room_for_person(solid: Bools, radius: float = PERSON) -> Bools:
    """Return the cells, with edge length `CELL`, where a person with this radius can stand."""
    return np.asarray(ndimage.distance_transform_edt(~solid) >= radius / CELL)


def drawn(corners: Floats, origin: tuple[float, float], shape: tuple[int, int]) -> Bools:
    """Draw a convex polygon on a lattice whose cells have edge length `CELL`.

    Parameters
    ----------
    corners
        (n, 2) metres, counter-clockwise.
    origin
        Position of the lattice's first corner.
    shape
        Shape of the lattice.

    Returns
    -------
    NDArray[bool]
        Cells whose centres are inside the polygon.
    """
    mask = np.zeros(shape, bool)
    low = np.floor((corners.min(axis=0) - origin) / CELL).astype(int).clip(0, shape)
    high = np.ceil((corners.max(axis=0) - origin) / CELL).astype(int).clip(0, shape)
    x = origin[0] + (np.arange(low[0], high[0]) + 0.5)[:, None] * CELL
    y = origin[1] + (np.arange(low[1], high[1]) + 0.5)[None, :] * CELL
    inside = np.ones((high[0] - low[0], high[1] - low[1]), bool)
    for (ax, ay), (bx, by) in zip(corners, np.roll(corners, -1, axis=0), strict=True):
        inside &= (bx - ax) * (y - ay) - (by - ay) * (x - ax) >= -1e-9
    mask[low[0] : high[0], low[1] : high[1]] = inside
    return mask
