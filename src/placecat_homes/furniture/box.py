"""Boxes and baskets."""

import math

import numpy as np

from placecat_homes import palette
from placecat_homes.furniture.blocks import backed, between, block, chance, choose
from placecat_homes.materials import Material
from placecat_homes.mesh import Mesh, join
from placecat_homes.shapes import lathe, quad, tube
from placecat_homes.style import Style

TAPE = Material((0.72, 0.6, 0.38), gloss=0.04)


def cardboard(
    rng: np.random.Generator,
    style: Style,
    width: float | None = None,
    depth: float | None = None,
    height: float | None = None,
) -> Mesh:
    """Draw a cardboard box, either taped shut or open with its flaps up.

    Parameters
    ----------
    rng
        Random number generator.
    style
        Style of the home.
    width, depth, height
        Size in metres; chosen at random if None.

    Returns
    -------
    Mesh
        A mesh with its base at z = 0.
    """
    w = between(rng, 0.3, 0.6) if width is None else width
    d = w * between(rng, 0.6, 0.85) if depth is None else depth
    h = w * between(rng, 0.4, 0.8) if height is None else height
    tone = between(rng, 0.85, 1.1)
    card = Material((0.66 * tone, 0.5 * tone, 0.34 * tone))
    if depth is None and chance(rng, 0.3):
        return _open(card, w, d, h)
    parts = [block(card, (w, d, h), (0, 0, 0), 0.004)]
    parts.append(block(TAPE, (w * 1.002, 0.05, 0.001), (0, d / 2 - 0.025, h)))
    parts.append(block(TAPE, (0.05, 0.001, h * 0.25), (0, d, h * 0.75)))
    if chance(rng, 0.6):
        label = quad(w * 0.3, h * 0.25).moved(between(rng, -0.2, 0.2) * w, d + 0.002, h * 0.35)
        parts.append(label.of(palette.paper(rng)))
    return join(parts)


def _open(card: Material, w: float, d: float, h: float) -> Mesh:
    t = 0.005
    parts = [block(card, (w, d, t))]
    for side in (-1, 1):
        parts.append(block(card, (t, d, h), (side * (w - t) / 2, 0, 0)))
        flap = block(card, (t, d, w * 0.4), (0, 0, 0)).turned(side * 50, "y")
        parts.append(flap.moved(side * (w - t) / 2, 0, h))
    for y in (0, d - t):
        parts.append(block(card, (w, t, h), (0, y, 0)))
    lifted = block(card, (w, t, d * 0.4)).turned(-50, "x").moved(0, d, h)
    return backed(join(*parts, lifted))


def storage_box(
    rng: np.random.Generator,
    style: Style,
    width: float | None = None,
    depth: float | None = None,
    height: float | None = None,
) -> Mesh:
    """Draw a cloth, plastic or cardboard storage box for a shelf, with a lid or a handle.

    Parameters
    ----------
    rng
        Random number generator.
    style
        Style of the home.
    width, depth, height
        Size in metres; chosen at random if None.

    Returns
    -------
    Mesh
        A mesh with its base at z = 0.
    """
    w = between(rng, 0.25, 0.42) if width is None else width
    d = between(rng, 0.25, 0.36) if depth is None else depth
    h = between(rng, 0.14, 0.3) if height is None else height
    skin = choose(rng, (palette.fabric(rng), palette.plastic(rng), palette.paint(rng)))
    kind = choose(rng, ("lid", "handle", "hole"))
    if kind == "lid":
        lid = min(0.05, h * 0.25)
        cap = choose(rng, (skin, palette.plastic(rng)))
        return join(
            block(skin, (w - 0.012, d - 0.012, h - lid), (0, 0.006, 0), 0.006),
            block(cap, (w, d, lid), (0, 0, h - lid), 0.006),
        )
    parts = [_hollow(skin, w, d, h)]
    if kind == "handle":
        strap = tube(
            [
                (-0.05, d, h * 0.6),
                (-0.03, d + 0.015, h * 0.5),
                (0.03, d + 0.015, h * 0.5),
                (0.05, d, h * 0.6),
            ],
            0.006,
            6,
        )
        parts.append(strap.of(style.metal if chance(rng, 0.5) else palette.leather(rng)))
    else:
        parts.append(block(palette.RUBBER, (0.08, 0.002, 0.025), (0, d, h * 0.72)))
    return join(parts)


def _hollow(skin: Material, w: float, d: float, h: float) -> Mesh:
    t = 0.008
    sides = [block(skin, (t, d, h), (s * (w - t) / 2, 0, 0)) for s in (-1, 1)]
    walls = [block(skin, (w, t, h), (0, y, 0)) for y in (0, d - t)]
    return join(sides, walls, block(skin, (w, d, h * 0.55)))


def basket(rng: np.random.Generator, style: Style, height: float | None = None) -> Mesh:
    """Draw a round woven basket or bin.

    Parameters
    ----------
    rng
        Random number generator.
    style
        Style of the home.
    height
        Height in metres; chosen at random if None.

    Returns
    -------
    Mesh
        A mesh with its base at z = 0.
    """
    h = between(rng, 0.2, 0.45) if height is None else height
    r = h * between(rng, 0.4, 0.7)
    tone = between(rng, 0.6, 1.1)
    cane = Material((0.72 * tone, 0.54 * tone, 0.33 * tone))
    if chance(rng, 0.3):
        cane = palette.fabric(rng)
    rings = 9
    outside = []
    for k in range(rings + 1):
        z = h * k / rings
        bulge = r * (0.82 + 0.18 * math.sin(math.pi * 0.7 * k / rings))
        outside += [(bulge, z), (bulge + 0.008, z + h / rings / 2)]
    outside = outside[:-1]
    profile = [(0, 0), *outside, (r * 0.86, h), (r * 0.8, h * 0.3), (0, h * 0.3)]
    return backed(lathe(profile, 18).of(cane))


def pile(rng: np.random.Generator, style: Style, count: int = 3) -> Mesh:
    """Draw a pile of cardboard boxes.

    Parameters
    ----------
    rng
        Random number generator.
    style
        Style of the home.
    count
        Number of boxes.

    Returns
    -------
    Mesh
        A mesh with its base at z = 0.
    """
    parts, z = [], 0.0
    w, d = between(rng, 0.4, 0.6), between(rng, 0.3, 0.42)
    for _ in range(count):
        h = between(rng, 0.2, 0.35)
        one = cardboard(rng, style, w * between(rng, 0.8, 1.0), d * between(rng, 0.85, 1.0), h)
        parts.append(one.moved(0, 0, z).turned(rng.normal(0, 4)))
        z += h
    return backed(join(parts))
