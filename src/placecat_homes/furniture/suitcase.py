"""Suitcases and travel bags."""

import math

import numpy as np

from placecat_homes import palette
from placecat_homes.furniture.blocks import between, block, chance
from placecat_homes.mesh import Mesh, join
from placecat_homes.parts.arrange import grounded
from placecat_homes.shapes import box, cylinder, tube
from placecat_homes.style import Style


def suitcase(rng: np.random.Generator, style: Style, lying: bool | None = None) -> Mesh:
    """Draw a ribbed hard-shell suitcase on wheels, or an old leather suitcase with straps.

    Parameters
    ----------
    rng
        Random number generator.
    style
        Style of the home.
    lying
        Whether the suitcase lies flat; chosen at random if None.

    Returns
    -------
    Mesh
        A mesh with its base at z = 0.
    """
    w, h, d = between(rng, 0.38, 0.5), between(rng, 0.52, 0.74), between(rng, 0.2, 0.28)
    lying = chance(rng, 0.25) if lying is None else lying
    if chance(rng, 0.35 + 0.3 * (1 - style.modern)):
        w, h = h, w * 0.95
        mesh = _old(rng, style, w, d * 0.85, h)
    else:
        mesh = _shell(rng, style, w, d, h)
    if lying:
        mesh = mesh.turned(-90, "x")
    return grounded(mesh)


def _shell(rng: np.random.Generator, style: Style, w: float, d: float, h: float) -> Mesh:
    skin = palette.plastic(rng)
    foot = 0.04
    parts = [box(w, d, h - foot, 0.03).moved(0, 0, foot).of(skin)]
    count = 6
    for k in range(count):
        x = (k + 0.5 - count / 2) * (w - 0.08) / count
        rib = box(0.035, d + 0.014, h - foot - 0.1, 0.006).moved(x, -0.007, foot + 0.05)
        parts.append(rib.of(skin))
    parts.append(block(palette.RUBBER, (w + 0.004, 0.012, h - foot - 0.02), (0, d / 2 - 0.006, foot + 0.01)))
    wheel = cylinder(0.025, 0.025, 10, 0.002).turned(90, "y")
    for x in (-w / 2 + 0.05, w / 2 - 0.07):
        for y in (0.04, d - 0.04):
            parts.append(wheel.moved(x, y, 0.025).of(palette.RUBBER))
    out = between(rng, 0.25, 0.4) if chance(rng, 0.4) else 0.03
    grip = [
        (-w * 0.2, 0.03, h - 0.02),
        (-w * 0.2, 0.03, h + out),
        (w * 0.2, 0.03, h + out),
        (w * 0.2, 0.03, h - 0.02),
    ]
    parts.append(tube(grip, 0.009, 6).of(palette.METALS[1]))
    return join(parts)


def _old(rng: np.random.Generator, style: Style, w: float, d: float, h: float) -> Mesh:
    skin, strap = palette.leather(rng), palette.leather(rng)
    parts = [box(w, d, h, 0.015).of(skin)]
    parts.append(block(palette.RUBBER, (w + 0.002, 0.004, h + 0.002), (0, d * 0.5, -0.001)))
    for x in (-0.28, 0.28):
        parts.append(block(strap, (0.035, d + 0.008, h + 0.008), (x * w, -0.004, -0.002)))
        parts.append(block(palette.METALS[2], (0.05, 0.006, 0.04), (x * w, d + 0.004, h * 0.75)))
    for x in (-1, 1):
        for z in (0.0, h - 0.06):
            parts.append(block(strap, (0.06, d + 0.006, 0.062), (x * (w / 2 - 0.029), -0.003, z)))
    path = [(0.08 * math.cos(a), d / 2, h + 0.045 * math.sin(a)) for a in np.linspace(0, math.pi, 7)]
    parts.append(tube(path, 0.009, 6).of(strap))
    return join(parts)
