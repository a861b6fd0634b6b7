"""Coat stands, coats, bags and hats."""

import math

import numpy as np

from placecat_homes import palette
from placecat_homes.furniture.blocks import between, block, chance, choose
from placecat_homes.materials import Material
from placecat_homes.mesh import Mesh, join
from placecat_homes.parts.outlines import loft
from placecat_homes.shapes import cylinder, lathe, superellipsoid, tube
from placecat_homes.style import Style


def coat(rng: np.random.Generator, style: Style, length: float | None = None) -> Mesh:
    """Draw a coat or jacket hanging by its loop from a hook at the origin.

    Parameters
    ----------
    rng, style
        Random number generator and style of the home.
    length
        Length in metres; 0.6 to 1.1 if None.
    """
    length = length or between(rng, 0.6, 1.1)
    cloth = _cloth(rng)
    wide, deep = between(rng, 0.34, 0.44), between(rng, 0.09, 0.15)
    waves, phase = int(rng.integers(3, 6)), between(rng, 0, 6.28)
    rings = []
    angles = np.linspace(0, 2 * math.pi, 20, endpoint=False)
    for t, w, d in ((1.0, 1.05, 1.0), (0.8, 0.98, 0.95), (0.5, 0.9, 0.9), (0.25, 0.88, 0.9), (0.1, 0.7, 0.75),
                    (0.03, 0.4, 0.5), (0.0, 0.18, 0.3)):  # fmt: skip
        fold = 1 + 0.12 * t * np.sin(waves * angles + phase) * (0.4 + 0.6 * t)
        x = wide / 2 * w * np.cos(angles) * fold
        y = deep / 2 * d * np.sin(angles) * fold + deep / 2
        rings.append(np.stack([x, y, np.full(20, -t * length)], 1))
    parts = [loft(rings, close=True).of(cloth)]
    for side in (-1, 1):
        arm = side * wide * 0.4
        line = [
            (arm * 0.75, deep * 0.55, -0.1),
            (arm * 1.1, deep * 0.7, -0.25),
            (arm * 1.15, deep * 0.75, -0.58),
        ]
        parts.append(tube(line, 0.052, 8).of(cloth))
    collar = tube([(-0.06, deep * 0.8, -0.03), (0, deep, -0.09), (0.06, deep * 0.8, -0.03)], 0.02, 6)
    parts.append(collar.of(cloth))
    if chance(rng, 0.5):
        trim = Material((0.1, 0.1, 0.1)) if chance(rng, 0.6) else style.metal
        parts.append(block(trim, (0.012, 0.01, length * 0.8), (0, deep * 0.96, -length * 0.95)))
    return join(parts)


def bag(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a handbag or rucksack hanging from a hook at the origin."""
    skin = choose(rng, (palette.leather(rng), palette.plain_fabric(rng)))
    w, d, h = between(rng, 0.24, 0.36), between(rng, 0.09, 0.15), between(rng, 0.22, 0.4)
    drop = between(rng, 0.12, 0.3)
    body = superellipsoid(w, d, h, 0.4, 0.4, 14).moved(0, d / 2, -drop - h).of(skin)
    strap = [(-w * 0.35, d / 2, -drop - 0.04), (0, 0.03, 0.0), (w * 0.35, d / 2, -drop - 0.04)]
    return join(body, tube(strap, 0.008, 5).of(skin))


def hat(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a hat lying on a shelf."""
    felt = _cloth(rng)
    line = [(0, 0), (0.15, 0), (0.155, 0.008), (0.095, 0.02), (0.09, 0.08), (0.07, 0.11), (0, 0.105)]
    return lathe(line, 18).of(felt)


def coat_stand(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a coat stand with coats and bags on it."""
    high = between(rng, 1.65, 1.85)
    material = choose(rng, (style.metal, style.any_wood(rng), palette.wood(rng)))
    parts = [tube([(0, 0, 0.02), (0, 0, high)], 0.02, 10).of(material)]
    if chance(rng, 0.5):
        parts.append(cylinder(0.19, 0.025, 24).of(material))
    else:
        for k in range(4):
            angle = math.radians(45 + 90 * k)
            c, s = math.cos(angle), math.sin(angle)
            line = [(0, 0, 0.22), (0.12 * c, 0.12 * s, 0.12), (0.25 * c, 0.25 * s, 0.015)]
            parts.append(tube(line, 0.014, 6).of(material))
    hooks = choose(rng, (4, 6))
    for k in range(hooks):
        angle = 2 * math.pi * k / hooks
        c, s = math.cos(angle), math.sin(angle)
        z = high - 0.08
        line = [(0, 0, z - 0.03), (0.09 * c, 0.09 * s, z), (0.13 * c, 0.13 * s, z + 0.09)]
        parts.append(tube(line, 0.009, 6).of(material))
        if chance(rng, 0.45):
            thing = coat(rng, style, between(rng, 0.6, 1.0)) if chance(rng, 0.7) else bag(rng, style)
            thing = thing.turned(math.degrees(angle) - 90)
            parts.append(thing.moved(0.06 * c, 0.06 * s, z - 0.02))
    whole = join(parts)
    return whole.moved(y=-float(whole.low[1]))


def _cloth(rng: np.random.Generator) -> Material:
    if chance(rng, 0.6):
        return palette.plain_fabric(rng)
    return choose(rng, (palette.leather(rng), palette.plastic(rng), palette.fabric(rng)))
