"""Toys."""

import math

import numpy as np

from placecat_homes import palette
from placecat_homes.furniture.blocks import between, block, chance, choose
from placecat_homes.furniture.box import storage_box
from placecat_homes.materials import Material
from placecat_homes.mesh import Mesh, join
from placecat_homes.parts.arrange import grounded
from placecat_homes.shapes import box, cylinder, superellipsoid
from placecat_homes.style import Style

DARK = Material((0.05, 0.04, 0.04), gloss=0.04)


def _bright(rng: np.random.Generator) -> Material:
    return Material(palette.colour(rng, 1.0, 0.6, 1.0), gloss=0.03)


def teddy(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a seated teddy bear."""
    tone = between(rng, 0.6, 1.15)
    fur = Material((0.62 * tone, 0.44 * tone, 0.27 * tone)) if chance(rng, 0.7) else palette.plain_fabric(rng)
    pale = Material((0.8, 0.68, 0.52))

    def ball(x: float, y: float, z: float, w: float, d: float, h: float) -> Mesh:
        return superellipsoid(w, d, h, 1, 1, 12).moved(x, y, z - h / 2)

    body = [ball(0, 0, 0.11, 0.18, 0.15, 0.21), ball(0, 0.01, 0.28, 0.16, 0.15, 0.15)]
    for side in (-1, 1):
        body.append(ball(side * 0.065, -0.005, 0.35, 0.055, 0.03, 0.055))
        body.append(ball(side * 0.1, 0.05, 0.15, 0.06, 0.13, 0.06))
        body.append(ball(side * 0.07, 0.12, 0.04, 0.075, 0.17, 0.075))
    face = [
        ball(0, 0.08, 0.26, 0.07, 0.05, 0.06).of(pale),
        ball(0, 0.105, 0.27, 0.022, 0.015, 0.016).of(DARK),
    ]
    face += [ball(side * 0.032, 0.073, 0.3, 0.014, 0.014, 0.014).of(DARK) for side in (-1, 1)]
    return grounded(join(body).of(fur), join(face)).scaled(between(rng, 0.8, 1.4))


def car(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a toy car."""
    skin = _bright(rng)
    parts = [
        box(0.12, 0.24, 0.05, 0.012).moved(0, 0, 0.025).of(skin),
        box(0.1, 0.13, 0.05, 0.015).moved(0, 0.05, 0.075).of(skin),
    ]
    parts.append(block(palette.BLACK_GLASS, (0.102, 0.11, 0.025), (0, 0.06, 0.088)))
    wheel = cylinder(0.032, 0.025, 12, 0.003).turned(90, "y")
    for side in (-1, 1):
        for y in (0.05, 0.19):
            parts.append(wheel.moved(side * 0.06 - 0.0125, y, 0.032).of(DARK))
    return join(parts)


def bricks(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw toy building bricks, some of them stacked."""
    colours = [_bright(rng) for _ in range(5)]
    edge = between(rng, 0.04, 0.07)
    parts = []
    for _ in range(int(rng.integers(5, 12))):
        size = (edge * choose(rng, (1, 1, 2)), edge, edge)
        x, y = rng.normal(0, 0.16, 2)
        parts.append(
            block(choose(rng, colours), size).turned(between(rng, 0, 90)).moved(float(x), float(y), 0)
        )
    for k in range(int(rng.integers(2, 6))):
        brick = block(choose(rng, colours), (edge, edge, edge), (0, -edge / 2, k * edge))
        parts.append(brick.turned(rng.normal(0, 10)).moved(0.12, 0.12))
    return grounded(join(parts))


def toys(rng: np.random.Generator, style: Style, count: int | None = None) -> Mesh:
    """Draw toys scattered across the floor.

    Parameters
    ----------
    rng
        Random number generator.
    style
        Style of the home.
    count
        Number of toys; chosen at random if None.

    Returns
    -------
    Mesh
        Toys standing on z = 0, within an area about one metre square.
    """
    count = int(rng.integers(2, 5)) if count is None else count
    parts = []
    start = between(rng, 0, 6)
    for k in range(count):
        thing = choose(rng, (teddy, car, bricks, ball, chest))(rng, style).turned(between(rng, -50, 50))
        a = start + k * 2 * math.pi / count
        parts.append(thing.moved(0.36 * math.cos(a), 0.36 * math.sin(a), 0))
    return grounded(join(parts))


def ball(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a ball."""
    size = between(rng, 0.14, 0.26)
    half = superellipsoid(size, size, size, 1, 1, 16)
    belt = cylinder(size * 0.505, size * 0.15, 18, 0.004).moved(0, 0, size * 0.425)
    return grounded(half.of(_bright(rng)), belt.of(_bright(rng)))


def chest(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw an open box full of toys."""
    parts = [storage_box(rng, style, 0.45, 0.34, 0.28)]
    for k in range(5):
        size = between(rng, 0.08, 0.15)
        thing = superellipsoid(size, size, size, choose(rng, (1.0, 0.2)), choose(rng, (1.0, 0.2)), 10)
        parts.append(thing.moved((k - 2) * 0.075, between(rng, 0.1, 0.24), 0.2).of(_bright(rng)))
    parts.append(teddy(rng, style).moved(0.05, 0.02, 0.24))
    return grounded(join(parts))
