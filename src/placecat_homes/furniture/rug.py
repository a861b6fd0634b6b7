"""Rugs."""

import math

import numpy as np

from placecat_homes import palette
from placecat_homes.furniture.blocks import between, block, chance, choose
from placecat_homes.mesh import Mesh, join
from placecat_homes.shapes import box, cylinder, extrude
from placecat_homes.style import Style


def rug(
    rng: np.random.Generator, style: Style, width: float | None = None, depth: float | None = None
) -> Mesh:
    """Draw a flat rectangular or round rug.

    Parameters
    ----------
    rng
        Random number generator.
    style
        Style of the home.
    width, depth
        Size in metres; chosen at random if None.

    Returns
    -------
    Mesh
        A rug 1 cm thick, with its back edge at y = 0.
    """
    width = between(rng, 1.2, 2.4) if width is None else width
    depth = width * between(rng, 0.6, 0.75) if depth is None else depth
    cloth = palette.rug(rng, width, depth) if chance(rng, 0.7) else style.any_fabric(rng)
    if (0.8 < width / depth < 1.25 and chance(rng, 0.5)) or chance(rng, 0.12):
        size = min(width, depth)
        return cylinder(size / 2, 0.01, 36, 0.003).moved(0, size / 2).of(cloth)
    parts = [box(width, depth, 0.01, 0.003).of(cloth)]
    if chance(rng, 0.35):
        fringe = palette.paper(rng)
        for side in (-1, 1):
            for y in np.arange(0.02, depth - 0.01, max(0.05, depth / 40)):
                x = side * (width / 2 + 0.03)
                parts.append(block(fringe, (0.06, 0.02, 0.004), (x, float(y), 0)))
    return join(parts)


def mat(rng: np.random.Generator, style: Style, width: float = 0.8, depth: float = 0.5) -> Mesh:
    """Draw a small mat, such as a bath mat or doormat.

    Parameters
    ----------
    rng
        Random number generator.
    style
        Style of the home.
    width, depth
        Size in metres.

    Returns
    -------
    Mesh
        A mat with its back edge at y = 0.
    """
    cloth = choose(rng, (palette.rug(rng, width, depth), palette.carpet(rng), palette.fabric(rng)))
    if chance(rng, 0.2):
        half = [(width / 2 * math.cos(a), depth * math.sin(a)) for a in np.linspace(0, math.pi, 14)]
        return extrude(half, 0.012).of(cloth)
    return box(width, depth, 0.012, 0.004).of(cloth)
