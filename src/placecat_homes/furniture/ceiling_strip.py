"""Fluorescent ceiling lights for offices and hallways."""

import numpy as np

from placecat_homes.furniture.blocks import between, block, chance, choose
from placecat_homes.materials import Colour, Material
from placecat_homes.mesh import Lamp, Mesh, join
from placecat_homes.shapes import quad, tube
from placecat_homes.style import Style


def ceiling_strip(rng: np.random.Generator, style: Style, *, length: float | None = None) -> Mesh:
    """Draw a fluorescent light along x: a box with a glowing cover, a trough with louvres, or bare tubes.

    Parameters
    ----------
    rng, style
        Random number generator and style of the home.
    length
        Length in metres; 1.2 or 1.5 if None.
    """
    length = length or choose(rng, (1.2, 1.5))
    kind = choose(rng, ("cover", "louvre", "tube", "square"), (2, 2, 1, 1.5))
    cool = between(rng, 0.0, 1.0)
    light: Colour = (0.93 + 0.07 * cool, 0.96, 0.86 + 0.14 * (1 - cool))
    glow = Material(light, emission=1.8)
    case = Material((0.88, 0.88, 0.87))
    drop = between(rng, 0.15, 0.4) if kind == "louvre" and chance(rng, 0.25) else 0.0
    if kind == "square":
        length = wide = 0.6
        parts = [block(case, (0.62, 0.62, 0.03), (0, -0.31, -0.03))]
        parts.append(quad(0.56, 0.56).turned(-90, "x").moved(0, -0.28, -0.031).of(glow))
    elif kind == "cover":
        wide = between(rng, 0.14, 0.2)
        parts = [
            block(case, (length, wide, 0.03), (0, -wide / 2, -0.03)),
            block(glow, (length - 0.04, wide - 0.02, 0.05), (0, -wide / 2 + 0.01, -0.08), 0.015),
        ]
    elif kind == "tube":
        parts = [block(case, (length, 0.06, 0.05), (0, -0.03, -0.05))]
        line = [(-length / 2 + 0.04, 0.0, -0.075), (length / 2 - 0.04, 0.0, -0.075)]
        parts.append(tube(line, 0.016, 8).of(glow))
    else:
        wide = between(rng, 0.2, 0.3)
        parts = [block(case, (length, wide, 0.02), (0, -wide / 2, -0.02))]
        for side in (-1, 1):
            parts.append(block(case, (length, 0.012, 0.08), (0, side * (wide / 2 - 0.006) - 0.006, -0.08)))
            parts.append(block(case, (0.012, wide, 0.08), (side * (length / 2 - 0.006), -wide / 2, -0.08)))
            line = [
                (-length / 2 + 0.04, side * wide * 0.22, -0.04),
                (length / 2 - 0.04, side * wide * 0.22, -0.04),
            ]
            parts.append(tube(line, 0.014, 6).of(glow))
        count = round(length / 0.12)
        for k in range(1, count):
            x = k * length / count - length / 2
            parts.append(block(case, (0.004, wide - 0.02, 0.035), (x, -wide / 2 + 0.01, -0.08)))
    whole = join(parts).moved(z=-drop)
    if drop:
        rods = [tube([(x, 0, 0), (x, 0, -drop)], 0.003, 4) for x in (-length / 3, length / 3)]
        whole = join(whole, join(rods).of(case))
    power = between(rng, 0.5, 0.8)
    lamps = [Lamp((x, 0.0, -drop - 0.18), light, power, 0.15) for x in (-length / 4, length / 4)]
    return whole.lit(*lamps)
