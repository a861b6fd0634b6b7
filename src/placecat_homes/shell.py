"""The shell of a room: floor, ceiling, walls with holes for doors and windows, and skirting boards."""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from placecat_homes import palette
from placecat_homes.floorplan import OUTER_WALL
from placecat_homes.furniture.window import window
from placecat_homes.materials import Material, Texture
from placecat_homes.mesh import Mesh, from_arrays, join
from placecat_homes.placing.opening import Opening
from placecat_homes.placing.room import Room
from placecat_homes.shapes import box
from placecat_homes.style import Style

_CASING = 0.1
_WINDOW_DEPTH = 0.17

Hole = tuple[float, float, float, float]


@dataclass(frozen=True)
class Finish:
    """A room's surface finish, drawn from the same distributions for every kind of room.

    Attributes
    ----------
    floor, ceiling
        Materials.
    walls
        Materials of walls 0 to 3.
    dado
        Material that covers the lower part of the walls, if any.
    dado_height
        Metres.
    skirting, moulding
        Heights in metres of the boards along the floor and ceiling; 0 means no board.
    """

    floor: Material
    ceiling: Material
    walls: tuple[Material, Material, Material, Material]
    dado: Material | None
    dado_height: float
    skirting: float
    moulding: float

    @classmethod
    def draw(cls, rng: np.random.Generator, floor: Material, wall: Material) -> "Finish":
        """Draw the finish of a room.

        Parameters
        ----------
        rng
            Random number generator.
        floor, wall
            Materials used in most of the building's rooms.

        Returns
        -------
        Finish
            The finish of the room.
        """
        if rng.random() < 0.35:
            floor = palette.flooring(rng)
        if rng.random() < 0.6:
            wall = palette.wall(rng)
        walls = [wall] * 4
        if rng.random() < 0.12:
            walls[int(rng.integers(4))] = palette.wall(rng)
        dado, height = None, 0.0
        if rng.random() < 0.08:
            kinds = (palette.wood, palette.paint)
            dado = kinds[int(rng.integers(2))](rng)
            height = float(rng.choice([0.95, 1.2, 1.5, 2.0]))
        skirting = 0.0 if rng.random() < 0.15 else float(rng.uniform(0.05, 0.13))
        moulding = float(rng.uniform(0.03, 0.08)) if rng.random() < 0.2 else 0.0
        a, b, c, d = walls
        return cls(floor, _ceiling(rng), (a, b, c, d), dado, height, skirting, moulding)


def _ceiling(rng: np.random.Generator) -> Material:
    kind = rng.random()
    if kind < 0.8:
        value = float(rng.uniform(0.84, 0.93))
        base = (value, value * 0.995, value * 0.975)
    elif kind < 0.93:
        base = palette.colour(rng, 0.2, 0.75, 0.93)
    else:
        return palette.wood(rng)
    return Material(texture=Texture("plaster", (base,), (1.7, 1.7), int(rng.integers(1 << 30))))


def shell(room: Room, finish: Finish, corner: tuple[float, float] = (0.0, 0.0)) -> Mesh:
    """Build the floor, ceiling, walls, window reveals and boards of a room.

    Parameters
    ----------
    room
        The room. Only its size and openings are used.
    finish
        Finish of the surfaces.
    corner
        World coordinates x and y of the room's corner, so that floor patterns continue from room to room.

    Returns
    -------
    Mesh
        The shell in the frame of the room, without the parts inside door openings.
    """
    w, d, h = room.width, room.depth, room.height
    level = np.array([(0, 0), (w, 0), (w, d), (0, d)], dtype=np.float64)
    faces = np.array([[0, 1, 2], [0, 2, 3]])
    floor = from_arrays(np.c_[level, np.zeros(4)], faces, uv=level + corner).of(finish.floor)
    ceiling = from_arrays(np.c_[level, np.full(4, h)], faces[:, ::-1], uv=level + corner).of(finish.ceiling)
    parts = [floor, ceiling]
    for wall in range(4):
        openings = [opening for opening in room.openings if opening.wall == wall]
        side = [*_wall(room.length(wall), h, openings, finish, finish.walls[wall])]
        side += _boards(room.length(wall), h, openings, finish, room.style)
        side += _switches(openings)
        side += [_reveal(opening, finish.walls[wall]) for opening in openings if opening.kind == "window"]
        x, y = room.point(wall, 0.0, 0.0)
        parts.append(join(side).turned(90.0 * wall).moved(x, y))
    return join(parts)


def glaze(room: Room, seed: int) -> Mesh:
    """Build the windows of a room, all with the same design.

    Parameters
    ----------
    room
        The room whose windows are built.
    seed
        Seed of the design.

    Returns
    -------
    Mesh
        The windows in the frame of the room.
    """
    parts = []
    for hole in room.windows:
        rng = np.random.default_rng(seed)
        size = (hole.width, hole.top - hole.sill)
        made = window(rng, room.style, *size, depth=_WINDOW_DEPTH, to_floor=hole.sill < 0.4)
        x, y = room.point(hole.wall, hole.middle, 0.0)
        parts.append(made.turned(90.0 * hole.wall).moved(x, y, hole.sill))
    return join(parts)


def passage(width: float, height: float, wall: float, sides: Material | None, floor: Material) -> Mesh:
    """Build the floor, sides and top of an opening in a wall.

    Parameters
    ----------
    width, height
        Width and height of the opening in metres.
    wall
        Thickness of the wall.
    sides, floor
        Materials; `sides` is None if a frame covers the sides and top.

    Returns
    -------
    Mesh
        The near face of the wall is at y = 0, the far face at y = -wall.
    """
    ground = _level(width, wall).of(floor)
    if sides is None:
        return ground
    return join(_tunnel((-width / 2, width / 2, 0.0, height), wall, floor=False).of(sides), ground)


def _wall(
    length: float, height: float, openings: Sequence[Opening], finish: Finish, material: Material
) -> list[Mesh]:
    """Build a wall along -x from its left end, as seen from +y, at the origin."""
    holes = [(opening.start, opening.end, opening.sill, opening.top) for opening in openings]
    along = sorted({0.0, length, *(value for hole in holes for value in hole[:2])})
    heights = {0.0, height, *(value for hole in holes for value in hole[2:])}
    if finish.dado is not None:
        heights.add(finish.dado_height)
    lower: list[Hole] = []
    upper: list[Hole] = []
    for a0, a1 in pairwise(along):
        for z0, z1 in pairwise(sorted(heights)):
            a, z = (a0 + a1) / 2, (z0 + z1) / 2
            if any(hole[0] < a < hole[1] and hole[2] < z < hole[3] for hole in holes):
                continue
            (lower if z < finish.dado_height else upper).append((a0, a1, z0, z1))
    parts = [_cells(upper).of(material)] if upper else []
    if lower and finish.dado is not None:
        parts.append(_cells(lower).of(finish.dado))
        spans = _between(length, [hole[:2] for hole in holes if hole[2] < finish.dado_height < hole[3]])
        profile = [(0.0, 0.0), (0.012, 0.0), (0.012, 0.02), (0.006, 0.026), (0.0, 0.026)]
        parts += [_strip(a, b, profile, finish.dado_height).of(finish.dado) for a, b in spans]
    return parts


def _cells(cells: Sequence[Hole]) -> Mesh:
    """Build rectangles in a wall. Neighbours share corners, so that the light varies smoothly across them."""
    numbers: dict[tuple[float, float], int] = {}
    faces = []
    for a0, a1, z0, z1 in cells:
        corners = ((a0, z0), (a1, z0), (a1, z1), (a0, z1))
        a, b, c, d = (numbers.setdefault(corner, len(numbers)) for corner in corners)
        faces += [(a, b, c), (a, c, d)]
    uv = np.array(list(numbers))
    points = np.stack([-uv[:, 0], np.zeros(len(uv)), uv[:, 1]], axis=1)
    return from_arrays(points, np.array(faces), uv=uv)


def _reveal(opening: Opening, material: Material) -> Mesh:
    slack = 0.002
    hole = (-opening.end - slack, -opening.start + slack, opening.sill - slack, opening.top + slack)
    return _tunnel(hole, OUTER_WALL, floor=True).of(material)


def _tunnel(hole: Hole, depth: float, *, floor: bool) -> Mesh:
    """Build the inner faces of a hole (x0, x1, z0, z1) in a wall, from y = 0 to -depth."""
    x0, x1, z0, z1 = hole
    d = -depth
    quads = [
        ([(x0, 0, z0), (x0, d, z0), (x0, d, z1), (x0, 0, z1)], z1 - z0, (1.0, 0.0, 0.0)),
        ([(x1, d, z0), (x1, 0, z0), (x1, 0, z1), (x1, d, z1)], z1 - z0, (-1.0, 0.0, 0.0)),
        ([(x0, 0, z1), (x0, d, z1), (x1, d, z1), (x1, 0, z1)], x1 - x0, (0.0, 0.0, -1.0)),
    ]
    if floor:
        quads.append(([(x0, d, z0), (x0, 0, z0), (x1, 0, z0), (x1, d, z0)], x1 - x0, (0.0, 0.0, 1.0)))
    parts = []
    for points, tall, normal in quads:
        corners = np.array(points, dtype=np.float64)
        faces = np.array([[0, 1, 2], [0, 2, 3]])
        if np.dot(np.cross(corners[1] - corners[0], corners[2] - corners[0]), normal) < 0:
            faces = faces[:, ::-1]
        uv = np.array([(0, 0), (depth, 0), (depth, tall), (0, tall)])
        parts.append(from_arrays(corners, faces, normals=np.tile(normal, (4, 1)), uv=uv))
    return join(parts)


def _level(width: float, depth: float) -> Mesh:
    x = width / 2
    points = np.array([(-x, -depth, 0.0), (x, -depth, 0.0), (x, 0.0, 0.0), (-x, 0.0, 0.0)])
    return from_arrays(points, np.array([[0, 1, 2], [0, 2, 3]]))


def _boards(
    length: float, height: float, openings: Sequence[Opening], finish: Finish, style: Style
) -> list[Mesh]:
    parts = []
    if finish.skirting > 0:
        gaps = [
            (opening.start - _CASING, opening.end + _CASING)
            if opening.kind == "door"
            else (opening.start, opening.end)
            for opening in openings
            if opening.sill < finish.skirting
        ]
        tall = finish.skirting
        profile = [(0.014, 0.0), (0.014, tall - 0.006), (0.008, tall), (0.0, tall)]
        parts += [_strip(a, b, profile, 0.0).of(style.trim) for a, b in _between(length, gaps)]
    if finish.moulding > 0:
        size = finish.moulding
        angles = np.linspace(0, np.pi / 2, 5)
        cove = [(size * (1 - np.cos(angle)), size * np.sin(angle)) for angle in angles]
        parts.append(_strip(0.0, length, cove, height - size).of(palette.WHITE))
    return parts


def _strip(start: float, end: float, profile: Sequence[tuple[float, float]], z: float) -> Mesh:
    """Build a backless board along a wall. Its profile lists (inwards, upwards) points, lowest first."""
    parts = []
    for (y0, z0), (y1, z1) in pairwise(profile):
        points = [(-start, y0, z0 + z), (-end, y0, z0 + z), (-end, y1, z1 + z), (-start, y1, z1 + z)]
        tall = float(np.hypot(y1 - y0, z1 - z0))
        uv = [(start, z0), (end, z0), (end, z0 + tall), (start, z0 + tall)]
        parts.append(from_arrays(np.array(points), np.array([[0, 1, 2], [0, 2, 3]]), uv=np.array(uv)))
    for x, sign in ((-start, 1), (-end, -1)):
        corners = np.array([(x, 0.0, profile[0][1] + z), *((x, y, h + z) for y, h in profile)])
        fan = np.array([(0, k, k + 1) for k in range(1, len(corners) - 1)])
        if np.cross(corners[2] - corners[0], corners[-1] - corners[0])[0] * sign < 0:
            fan = fan[:, ::-1]
        normals = np.tile([float(sign), 0.0, 0.0], (len(corners), 1))
        parts.append(from_arrays(corners, fan, normals=normals, uv=corners[:, 1:]))
    return join(parts)


def _between(length: float, gaps: Sequence[tuple[float, ...]]) -> list[tuple[float, float]]:
    spans, position = [], 0.0
    for start, end in sorted(gaps):
        if start - position > 0.02:
            spans.append((position, start))
        position = max(position, end)
    if length - position > 0.02:
        spans.append((position, length))
    return spans


def _switches(openings: Sequence[Opening]) -> list[Mesh]:
    """Build a light switch beside each door, on the handle side."""
    parts = []
    for opening in openings:
        if opening.kind == "door" and opening.passage:
            along = opening.end + 0.18 if opening.hinge == "left" else opening.start - 0.18
            plate = box(0.08, 0.008, 0.08, 0.003)
            rocker = box(0.05, 0.006, 0.05, 0.0).moved(0, 0.006, 0.015)
            parts.append(join(plate, rocker).moved(-along, -0.002, 1.05).of(palette.WHITE))
    return parts
