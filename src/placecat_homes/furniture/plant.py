"""Potted plants and flowers."""

import math
from collections.abc import Callable
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from placecat_homes import palette
from placecat_homes.furniture.blocks import backed, between, chance, choose
from placecat_homes.materials import Material
from placecat_homes.mesh import Mesh, from_arrays, join
from placecat_homes.shapes import box, lathe, superellipsoid, tube
from placecat_homes.style import Style

Points = NDArray[np.float64]

OVAL = (0.12, 0.8, 1.0, 0.75, 0.0)
"""Relative widths of a rubber plant leaf from stalk to tip."""

HEART = (0.55, 1.0, 0.85, 0.5, 0.0)
SWORD = (0.7, 0.9, 1.0, 0.8, 0.0)
GRASS = (0.6, 1.0, 0.9, 0.6, 0.0)


def leaves(
    foot: Points,
    direction: Points,
    length: Points,
    width: Points,
    bend: Points,
    outline: tuple[float, ...] = OVAL,
    crease: float = 0.25,
) -> Mesh:
    """Draw leaves.

    Parameters
    ----------
    foot
        (n, 3) starting points of the leaves in metres.
    direction
        (n, 3) directions of the leaves at their starting points.
    length, width
        (n,) sizes in metres.
    bend
        (n,) angles in radians by which the tips bend down.
    outline
        Widths from the stalk to the tip, relative to `width`.
    crease
        Depth of the fold along the middle, relative to `width`.

    Returns
    -------
    Mesh
        The leaves, as thin sheets.
    """
    n, rows = len(foot), len(outline)
    ahead = direction / np.maximum(np.linalg.norm(direction, axis=1, keepdims=True), 1e-9)
    level = np.linalg.norm(ahead[:, :2], axis=1)
    heading = np.arctan2(ahead[:, 1], ahead[:, 0])
    rise = np.arctan2(ahead[:, 2], level)
    side = np.stack([-np.sin(heading), np.cos(heading), np.zeros(n)], 1)
    vertices = np.zeros((n, rows, 3, 3))
    at = np.array(foot, float)
    for row, wide in enumerate(outline):
        angle = rise - bend * row / (rows - 1)
        forward = np.stack(
            [np.cos(angle) * np.cos(heading), np.cos(angle) * np.sin(heading), np.sin(angle)], 1
        )
        upward = np.cross(forward, side)
        if row:
            at = at + forward * (length / (rows - 1))[:, None]
        reach = (wide * width / 2)[:, None]
        vertices[:, row, 0] = at - side * reach + upward * reach * crease
        vertices[:, row, 1] = at
        vertices[:, row, 2] = at + side * reach + upward * reach * crease
    cells = []
    for row in range(rows - 1):
        for column in range(2):
            a, b = row * 3 + column, row * 3 + column + 1
            c, d = a + 3, b + 3
            cells += [(a, c, d), (a, d, b)] if row < rows - 2 else [(a, c, b)]
    faces = np.array(cells)[None] + (np.arange(n) * rows * 3)[:, None, None]
    uv = np.zeros((n, rows, 3, 2))
    uv[..., 0] = np.linspace(0, 1, rows)[None, :, None] * length[:, None, None]
    uv[..., 1] = np.array([0.0, 0.5, 1.0]) * width[:, None, None]
    return from_arrays(vertices.reshape(-1, 3), faces.reshape(-1, 3)[:, ::-1], uv=uv.reshape(-1, 2))


def _around(rng: np.random.Generator, n: int, low: float, high: float) -> Points:
    """Return directions all around the z axis, `low` to `high` degrees above the horizontal."""
    turn = np.arange(n) * 2.4 + rng.uniform(0, 6.28) + rng.normal(0, 0.25, n)
    rise = np.radians(rng.uniform(low, high, n))
    return np.stack([np.cos(turn) * np.cos(rise), np.sin(turn) * np.cos(rise), np.sin(rise)], 1)


def pot(rng: np.random.Generator, style: Style, radius: float, height: float) -> Mesh:
    """Draw a pot filled with soil.

    Parameters
    ----------
    rng
        Random number generator.
    style
        Style of the home.
    radius, height
        Radius and height in metres.

    Returns
    -------
    Mesh
        A pot centred on the z axis.
    """
    skin = choose(
        rng,
        (
            palette.ceramic(rng),
            palette.plastic(rng),
            palette.paint(rng),
            Material((0.62, 0.33, 0.2)),
            style.metal,
        ),
        (3, 1, 2, 3, 0.5),
    )
    soil = lathe([(radius * 0.9, height * 0.88), (0, height * 0.92)], 14).of(palette.soil(rng))
    r, h = radius, height
    inside = [(r * 0.92, h), (r * 0.86, h * 0.85)]
    profiles = (
        [(0, 0), (r * 0.72, 0), (r, h), *inside],
        [(0, 0), (r * 0.96, 0), (r, h * 0.1), (r, h), *inside],
        [(0, 0), (r * 0.68, 0), (r * 0.88, h * 0.78), (r, h * 0.78), (r, h), *inside],
        [(0, 0), (r * 0.6, 0), (r * 0.95, h * 0.3), (r * 1.05, h * 0.6), (r, h), *inside],
    )
    if chance(rng, 0.15):
        wide = radius * 1.8
        soil = box(wide * 0.9, wide * 0.9, 0.01, 0).moved(0, -wide * 0.45, h * 0.98).of(palette.soil(rng))
        return join(box(wide, wide, h, 0.004).moved(0, -wide / 2).of(skin), soil)
    return join(lathe(choose(rng, profiles), 18).of(skin), soil)


def plant(rng: np.random.Generator, style: Style, height: float | None = None) -> Mesh:
    """Draw a plant in a pot.

    Parameters
    ----------
    rng
        Random number generator.
    style
        Style of the home.
    height
        Height including the pot, in metres; a floor plant if None. Plants under 0.6 m suit a sill or table.

    Returns
    -------
    Mesh
        A mesh with its base at z = 0.
    """
    height = between(rng, 0.7, 1.8) if height is None else height
    if height < 0.6:
        radius = height * between(rng, 0.22, 0.3)
        kinds: tuple[Callable[[np.random.Generator, float, float], Mesh], ...] = (
            _bushy,
            _swords,
            _grassy,
            _flowering,
            _cactus,
            _trailing,
        )

        weights: tuple[float, ...] = (3, 1, 2, 3, 1, 2)
    else:
        radius = min(0.2, 0.1 + 0.06 * height) * between(rng, 0.85, 1.15)
        kinds = (_tree, _palm, _monstera, _swords, _grassy)
        weights = (3, 3, 2.5, 1.5 if height < 1.3 else 0.0, 1 if height < 1.2 else 0.0)
    tall = min(radius * between(rng, 1.4, 2.0), height * 0.5)
    vessel = pot(rng, style, radius, tall)
    green = choose(rng, kinds, weights)(rng, height - tall * 0.9, radius).moved(0, 0, tall * 0.9)
    limit = max(height * 0.95, 4 * radius) if height < 0.6 else 0.4 + 0.42 * height
    wide = float(max(green.size[:2]))
    if wide > limit:
        green = green.scaled(limit / wide, limit / wide, 1.0)
    vertices = green.vertices.copy()
    vertices[:, 2] = np.maximum(vertices[:, 2], 0.012)
    return backed(join(vessel, replace(green, vertices=vertices)))


def _bark() -> Material:
    return Material((0.36, 0.26, 0.18))


def _tree(rng: np.random.Generator, height: float, radius: float) -> Mesh:
    parts, feet, ways = [], [], []
    crown = height * between(rng, 0.35, 0.8)
    stems = int(rng.integers(1, 4))
    for k in range(stems):
        lean = rng.normal(0, 0.05, 2) * height + 0.25 * radius * np.array(
            [math.cos(k * 2.1), math.sin(k * 2.1)]
        )
        top = height * between(rng, 0.8, 0.92)
        bow = rng.normal(0, 0.03, 2)
        path = np.array(
            [
                [lean[0] * s + bow[0] * s * (1 - s) * 4, lean[1] * s + bow[1] * s * (1 - s) * 4, top * s]
                for s in np.linspace(0, 1, 6)
            ]
        )
        parts.append(tube([tuple(p) for p in path.tolist()], 0.008 + 0.006 * height, 6).of(_bark()))
        count = int(100 + 70 * height) // stems
        s = rng.uniform(1 - crown / height, 1.02, count)
        out = _around(rng, count, -25, 60)
        reach = rng.uniform(0.03, 0.2 * math.sqrt(height), count) * (1.15 - 0.6 * np.abs(s - 0.7))
        at = np.stack([np.interp(s, np.linspace(0, 1, 6), path[:, j]) for j in range(3)], 1)
        feet.append(at + out * reach[:, None])
        ways.append(out)
    foot, way = np.concatenate(feet), np.concatenate(ways)
    n = len(foot)
    size = between(rng, 0.09, 0.2) * (0.7 + 0.3 * height)
    length = size * rng.uniform(0.75, 1.2, n)
    green = leaves(foot, way, length, length * between(rng, 0.45, 0.7), rng.uniform(0.3, 1.3, n))
    return join(*parts, green.of(palette.foliage(rng)))


def _palm(rng: np.random.Generator, height: float, radius: float) -> Mesh:
    count = int(rng.integers(9, 15))
    green = palette.foliage(rng)
    out = _around(rng, count, 58, 86)
    parts, feet, ways, lengths = [], [], [], []
    for k in range(count):
        long = height * between(rng, 0.75, 1.15)
        droop = between(rng, 0.7, 1.5) * (1.1 - 0.5 * out[k, 2])
        heading = math.atan2(out[k, 1], out[k, 0])
        rise = math.asin(out[k, 2])
        path = [np.array([0.25 * radius * math.cos(heading), 0.25 * radius * math.sin(heading), 0.0])]
        for step in range(8):
            angle = rise - droop * (step / 7) ** 1.6
            path.append(
                path[-1]
                + long
                / 8
                * np.array(
                    [
                        math.cos(angle) * math.cos(heading),
                        math.cos(angle) * math.sin(heading),
                        math.sin(angle),
                    ]
                )
            )
        line = np.array(path)
        parts.append(tube([tuple(p) for p in line.tolist()], 0.005, 4).of(green))
        for s in np.linspace(0.3, 1.0, 15):
            at = np.array([np.interp(s * 8, np.arange(9), line[:, j]) for j in range(3)])
            ahead = line[min(int(s * 8) + 1, 8)] - line[min(int(s * 8), 7)]
            ahead = ahead / np.linalg.norm(ahead)
            across = np.array([-math.sin(heading), math.cos(heading), 0.0])
            for side in (-1, 1):
                feet.append(at)
                ways.append(
                    ahead * 0.75 + side * across * (1.0 if s < 0.97 else 0.2) + np.array([0, 0, 0.25])
                )
                lengths.append(long * 0.24 * (1.25 - 0.75 * abs(s - 0.6) * 1.6))
    n = len(feet)
    length = np.array(lengths) * rng.uniform(0.85, 1.1, n)
    blades = leaves(
        np.array(feet), np.array(ways), length, length * 0.17, rng.uniform(0.5, 1.1, n), (0.5, 1.0, 0.0)
    )
    mesh = join(*parts, blades.of(green))
    return mesh.scaled(1.0, 1.0, height / max(float(mesh.high[2]), 0.1))


def _swords(rng: np.random.Generator, height: float, radius: float) -> Mesh:
    n = int(rng.integers(8, 16))
    out = _around(rng, n, 74, 88)
    foot = out * np.array([1, 1, 0]) * radius * 2.2
    length = height * rng.uniform(0.55, 1.0, n)
    width = np.full(n, 0.05 + 0.03 * height)
    return leaves(foot, out, length, width, rng.uniform(-0.1, 0.15, n), SWORD, 0.5).of(palette.foliage(rng))


def _grassy(rng: np.random.Generator, height: float, radius: float) -> Mesh:
    n = int(rng.integers(30, 50))
    out = _around(rng, n, 40, 88)
    length = height * rng.uniform(0.9, 1.5, n)
    bend = rng.uniform(0.9, 2.2, n)
    foot = out * np.array([1, 1, 0]) * radius * 0.6
    mesh = leaves(foot, out, length, np.full(n, 0.012 + 0.018 * height), bend, GRASS, 0.4)
    return mesh.of(palette.foliage(rng)).scaled(1, 1, height / max(float(mesh.high[2]), 0.05))


def _monstera(rng: np.random.Generator, height: float, radius: float) -> Mesh:
    n = int(rng.integers(11, 20))
    green = palette.foliage(rng)
    out = _around(rng, n, 48, 84)
    long = height * rng.uniform(0.45, 0.95, n)
    tip = out * long[:, None] * np.array([0.8, 0.8, 1.0])
    parts = []
    for k in range(n):
        middle = tip[k] * 0.5 + np.array([0, 0, 0.08 * height])
        parts.append(tube([(0, 0, 0), tuple(middle.tolist()), tuple(tip[k].tolist())], 0.005, 5))
    size = between(rng, 0.2, 0.3) * (0.6 + 0.4 * height) * rng.uniform(0.75, 1.1, n)
    way = out * np.array([1, 1, 0]) + np.array([0, 0, 0.15])
    blades = leaves(tip, way, size, size * between(rng, 0.7, 0.95), rng.uniform(0.5, 1.2, n), HEART, 0.15)
    return join(*parts, blades).of(green)


def _bushy(rng: np.random.Generator, height: float, radius: float) -> Mesh:
    n = int(rng.integers(45, 80))
    out = _around(rng, n, 0, 85)
    foot = out * rng.uniform(0.15, 0.75, n)[:, None] * height * np.array([0.7, 0.7, 1.0])
    length = height * rng.uniform(0.25, 0.42, n)
    wide = length * between(rng, 0.45, 0.8)
    return leaves(foot, out, length, wide, rng.uniform(0.3, 1.2, n), choose(rng, (OVAL, HEART))).of(
        palette.foliage(rng)
    )


def _flowering(rng: np.random.Generator, height: float, radius: float) -> Mesh:
    green = palette.foliage(rng)
    n = int(rng.integers(10, 22))
    out = _around(rng, n, 5, 60)
    length = height * rng.uniform(0.35, 0.6, n)
    parts = [leaves(out * radius * 0.3, out, length, length * 0.45, rng.uniform(0.5, 1.3, n)).of(green)]
    petal = Material(palette.colour(rng, 0.95, 0.6, 1.0))
    for way in _around(rng, int(rng.integers(3, 9)), 55, 88):
        tip = way * height * between(rng, 0.8, 1.0)
        parts.append(tube([(0, 0, 0), tuple(tip.tolist())], 0.003, 4).of(green))
        parts.append(blossom(rng, height * 0.16, petal).moved(*tip.tolist()))
    return join(parts)


def blossom(rng: np.random.Generator, size: float, petal: Material) -> Mesh:
    """Draw a flower.

    Parameters
    ----------
    rng
        Random number generator.
    size
        Diameter in metres.
    petal
        Material of the petals.

    Returns
    -------
    Mesh
        An upward-facing flower at the origin.
    """
    if chance(rng, 0.4):
        return superellipsoid(size * 0.8, size * 0.8, size, 0.9, 1, 10).moved(0, 0, -size * 0.3).of(petal)
    n = int(rng.integers(5, 9))
    out = _around(rng, n, 5, 45)
    turn = np.arange(n) * 2 * math.pi / n
    out[:, 0], out[:, 1] = np.cos(turn), np.sin(turn)
    ones = np.ones(n)
    petals = leaves(np.zeros((n, 3)), out, ones * size * 0.55, ones * size * 0.4, ones * 0.4, (0.4, 1.0, 0.7))
    heart = superellipsoid(size * 0.22, size * 0.22, size * 0.15, 1, 1, 8).of(Material((0.85, 0.65, 0.15)))
    return join(petals.of(petal), heart)


def _cactus(rng: np.random.Generator, height: float, radius: float) -> Mesh:
    green = palette.foliage(rng)
    parts = [superellipsoid(radius * 1.1, radius * 1.1, height, 0.7, 1, 12)]
    for side in (-1, 1):
        if chance(rng, 0.5):
            x, z = side * radius * 0.9, height * between(rng, 0.3, 0.5)
            parts.append(tube([(0, 0, z), (x, 0, z), (x * 1.05, 0, z + height * 0.3)], radius * 0.25, 8))
    return join(parts).of(green)


def _strands(rng: np.random.Generator, radius: float, drop: float, count: int, size: float) -> Mesh:
    feet, ways = [], []
    for _ in range(count):
        turn, long = rng.uniform(0, 2 * math.pi), drop * rng.uniform(0.3, 1.0)
        steps = max(int((long + radius) / (size * 0.7)), 2)
        for s in np.linspace(0, 1, steps):
            run = s * (long + radius)
            r, z = (
                (run, 0.04 * math.sin(run / radius * 3.1))
                if run < radius * 1.1
                else (radius * 1.1, -(run - radius * 1.1))
            )
            wiggle = rng.normal(0, 0.008, 2)
            feet.append([r * math.cos(turn) + wiggle[0], r * math.sin(turn) + wiggle[1], z])
            side = turn + rng.choice([-1.2, 0.0, 1.2])
            ways.append([math.cos(side), math.sin(side), rng.uniform(-0.6, 0.4)])
    n = len(feet)
    length = size * rng.uniform(0.7, 1.2, n)
    return leaves(
        np.array(feet), np.array(ways), length, length * 0.8, rng.uniform(0.2, 1, n), (0.5, 1.0, 0.0)
    )


def _trailing(rng: np.random.Generator, height: float, radius: float) -> Mesh:
    top = _bushy(rng, height * 0.6, radius)
    strands = _strands(rng, radius, height * 0.45, 9, height * 0.16)
    return join(top, strands.of(top.materials[0]))
