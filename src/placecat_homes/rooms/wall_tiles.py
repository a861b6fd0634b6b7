"""Tiles on the lower parts of walls."""

from dataclasses import replace
from itertools import pairwise

import numpy as np

from placecat_homes.materials import Material
from placecat_homes.mesh import Mesh, join
from placecat_homes.placing.placed import Placed
from placecat_homes.placing.room import Room
from placecat_homes.shapes import box

THICKNESS = 0.008
"""Thickness of the tiles in metres."""

_CASING = 0.1


def tile_walls(
    room: Room,
    tiles: Material,
    height: float,
    *,
    walls: tuple[int, ...] = (0, 1, 2, 3),
    border: Material | None = None,
) -> None:
    """Tile walls up to a given height, around doors and windows.

    Parameters
    ----------
    room
        The room.
    tiles
        Material of the tiles.
    height
        Height in metres up to which walls are tiled.
    walls
        Numbers of the walls, from 0 to 3.
    border
        Material of a strip along the upper edge; if None, there is no strip.
    """
    for wall in walls:
        length = room.length(wall)
        cuts: list[tuple[float, float, float, float]] = []
        for opening in room.openings:
            if opening.wall == wall:
                low = 0.0 if opening.kind == "door" else opening.sill - 0.07
                cuts.append((opening.start - _CASING, opening.end + _CASING, low, opening.top + _CASING))
        edges = np.clip(sorted({0.0, length, *(edge for cut in cuts for edge in cut[:2])}), 0.0, length)
        panels: list[Mesh] = []
        for start, end in pairwise(edges):
            if end - start < 0.02:
                continue
            middle = (start + end) / 2
            holes = [cut for cut in cuts if cut[0] < middle < cut[1]]
            parts = [(0.0, height)]
            if holes:
                parts = [(0.0, min(height, holes[0][2])), (holes[0][3], height)]
            for low, high in parts:
                if high - low > 0.05:
                    panels.append(
                        _panel(tiles, border, length, (float(start), float(end)), (low, high), height)
                    )
        if panels:
            x, y = room.point(wall, length / 2, 0.001)
            room.placed.append(Placed(join(panels), x, y, 0.0, 90.0 * wall, None))


def _panel(
    tiles: Material,
    border: Material | None,
    length: float,
    ends: tuple[float, float],
    levels: tuple[float, float],
    height: float,
) -> Mesh:
    """Build a rectangle of tiles, with the origin at the middle of the wall's lower edge."""
    width = ends[1] - ends[0]
    x = length / 2 - (ends[0] + ends[1]) / 2
    panel = box(width, THICKNESS, levels[1] - levels[0], bevel=0.0)
    shifted = replace(panel, uv=panel.uv + np.array([x - width / 2, levels[0]], np.float32)).of(tiles)
    parts = [shifted.moved(x, 0, levels[0])]
    if border is not None and levels[1] == height:
        parts.append(box(width, THICKNESS + 0.006, 0.03, bevel=0.004).moved(x, 0, height).of(border))
    return join(parts)
