"""Towels on rails, rings, hooks and heated towel rails."""

import math

import numpy as np
from numpy.typing import NDArray

from placecat_homes import palette
from placecat_homes.materials import Material
from placecat_homes.mesh import Mesh, join
from placecat_homes.parts.lofts import hung
from placecat_homes.shapes import box, cylinder, sheet, tube
from placecat_homes.style import Style


def cloths(rng: np.random.Generator, style: Style, count: int) -> list[Material]:
    """Choose towel materials, which may or may not match."""
    first = palette.plain_fabric(rng)
    match = rng.random() < 0.5
    return [
        first
        if match or k == 0
        else palette.plain_fabric(rng)
        if rng.random() < 0.75
        else style.any_fabric(rng)
        for k in range(count)
    ]


def towel(rng: np.random.Generator, style: Style, *, kind: str | None = None) -> Mesh:
    """Draw towels on the wall.

    Parameters
    ----------
    rng
        Random number generator.
    style
        Style of the home.
    kind
        "rail", "double rail", "hooks" or "ring"; chosen at random if None.

    Returns
    -------
    Mesh
        Towels about 0.4 to 0.9 m high, with their lowest point at z = 0.
    """
    kind = kind or str(rng.choice(("rail", "double rail", "hooks", "ring"), p=(0.4, 0.15, 0.3, 0.15)))
    if kind == "hooks":
        mesh = _hooks(rng, style)
    elif kind == "ring":
        mesh = _ring(rng, style)
    else:
        mesh = _rail(rng, style, 2 if kind == "double rail" else 1)
    return mesh.moved(z=-float(mesh.low[2]))


def _rail(rng: np.random.Generator, style: Style, bars: int) -> Mesh:
    length = rng.uniform(0.5, 0.75)
    parts: list[Mesh] = []
    for bar in range(bars):
        y, z = 0.08 + 0.07 * bar, -0.08 * bar
        parts.append(tube([(-length / 2, y, z), (length / 2, y, z)], 0.009, 8).of(style.metal))
        count = 1 if rng.random() < 0.5 else 2
        wide = length * (0.75 if count == 1 else 0.43)
        for k, cloth in enumerate(cloths(rng, style, count)):
            x = (k - (count - 1) / 2) * length * 0.47
            drop = rng.uniform(0.4, 0.65)
            piece = hung(rng, wide, drop, drop * rng.uniform(0.7, 0.95), 0.016).of(cloth)
            parts.append(piece.moved(x, y, z))
    for x in (-length / 2, length / 2):
        parts.append(
            tube([(x, 0, 0), (x, 0.08 + 0.07 * (bars - 1), -0.08 * (bars - 1))], 0.011, 8).of(style.metal)
        )
    return join(parts)


def _gathered(rng: np.random.Generator, cloth: Material) -> Mesh:
    """Draw a towel hanging from a hook at the origin."""
    drop, spread, phase = rng.uniform(0.65, 0.9), rng.uniform(0.3, 0.42), rng.uniform(0, 6)

    def surface(s: NDArray[np.float64], t: NDArray[np.float64]) -> tuple[NDArray[np.float64], ...]:
        down = 1 - t
        angle = 2 * math.pi * s
        wide = spread / 2 * (0.12 + 0.88 * np.minimum(down * 1.6, 1.0) ** 0.7)
        x = wide * np.cos(angle) * (1 + 0.1 * np.sin(5 * angle + phase))
        y = 0.05 + (0.02 + 0.035 * np.minimum(down * 2, 1.0)) * np.sin(angle) * (
            1 + 0.3 * np.sin(4 * angle + phase)
        )
        z = -drop * down * (1 - 0.12 * np.cos(2 * angle + phase)) + 0.02
        return x, y + 0.02, z

    return sheet(surface, 22, 9, (0.9, drop)).of(cloth)


def _hooks(rng: np.random.Generator, style: Style) -> Mesh:
    count = int(rng.integers(2, 5))
    length = count * 0.24
    board = box(length, 0.018, 0.08, bevel=0.004).moved(z=-0.03).of(style.any_wood(rng))
    parts = [board]
    for k, cloth in enumerate(cloths(rng, style, count)):
        x = (k + 0.5) * 0.24 - length / 2
        hook = [(x, 0.015, 0.02), (x, 0.06, 0.01), (x, 0.075, 0.035)]
        parts.append(tube(hook, 0.006, 6).of(style.metal))
        if k == 0 or rng.random() < 0.7:
            parts.append(_gathered(rng, cloth).scaled(0.75, 1, 0.9).moved(x, 0, 0.0))
    return join(parts)


def _ring(rng: np.random.Generator, style: Style) -> Mesh:
    angle = np.linspace(0, 2 * math.pi, 17)
    circle = [(0.09 * math.sin(a), 0.045, -0.09 + 0.09 * math.cos(a)) for a in angle]
    piece = hung(rng, 0.17, rng.uniform(0.35, 0.5), rng.uniform(0.3, 0.4), 0.018)
    return join(
        cylinder(0.025, 0.04, 10).turned(-90, "x").of(style.metal),
        tube(circle, 0.006, 6).of(style.metal),
        piece.moved(0, 0.045, -0.175).of(cloths(rng, style, 1)[0]),
    )


def towel_radiator(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a heated towel rail: a ladder of bars with towels. Its lower edge is at z = 0."""
    width, height = rng.uniform(0.45, 0.6), rng.uniform(1.1, 1.6)
    metal = style.metal if rng.random() < 0.45 else Material((0.92, 0.92, 0.91), gloss=0.04)
    bars = np.arange(0.05, height, 0.06)
    groups = [z for k, z in enumerate(bars) if k % 7 < 5]
    y = 0.07
    parts = [
        tube([(x, y, 0), (x, y, height)], 0.017, 8).of(metal) for x in (-width / 2 + 0.02, width / 2 - 0.02)
    ]
    parts += [tube([(-width / 2 + 0.02, y, z), (width / 2 - 0.02, y, z)], 0.011, 6).of(metal) for z in groups]
    parts += [
        tube([(x, 0, z), (x, y, z)], 0.012, 6).of(metal)
        for x in (-width / 2 + 0.02, width / 2 - 0.02)
        for z in (0.15, height - 0.15)
    ]
    places = [height - 0.12, height * 0.52]
    for z, cloth in zip(places, cloths(rng, style, 2), strict=True):
        if z > height * 0.6 or rng.random() < 0.6:
            drop = rng.uniform(0.3, 0.45)
            piece = hung(rng, width * rng.uniform(0.6, 0.8), drop, drop * 0.9, 0.02).of(cloth)
            parts.append(piece.moved(rng.uniform(-0.03, 0.03), y, z))
    return join(parts)
