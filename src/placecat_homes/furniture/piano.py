"""Upright pianos."""

import numpy as np

from placecat_homes import palette
from placecat_homes.furniture.blocks import between, block, chance, legs
from placecat_homes.materials import Material
from placecat_homes.mesh import Mesh, join
from placecat_homes.parts.arrange import grounded
from placecat_homes.shapes import quad
from placecat_homes.style import Style

IVORY = Material((0.93, 0.91, 0.85), gloss=0.04, roughness=0.2)
EBONY = Material((0.03, 0.03, 0.03), gloss=0.04, roughness=0.2)


def piano(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw an upright piano with a stool.

    Parameters
    ----------
    rng
        Random number generator.
    style
        Style of the home.

    Returns
    -------
    Mesh
        A mesh with its base at z = 0.
    """
    width, height, depth = 1.46, between(rng, 1.1, 1.28), 0.36
    case = (
        Material((0.02, 0.02, 0.02), gloss=0.06, roughness=0.05) if chance(rng, 0.45) else style.any_wood(rng)
    )
    shelf = 0.27
    parts = [
        block(case, (width - 0.06, depth, height - 0.03), (0, 0, 0), 0.004),
        block(case, (width, depth + 0.03, 0.035), (0, 0, height - 0.035), 0.006),
        block(case, (width, shelf, 0.07), (0, depth, 0.62), 0.004),
        block(case, (width - 0.1, 0.02, 0.03), (0, depth + 0.01, 0.75), 0.003),
        block(case, (width - 0.06, 0.015, 0.12), (0, depth, 0.1), 0.004),
    ]
    for side in (-1, 1):
        x = side * (width - 0.05) / 2
        parts.append(block(case, (0.05, depth + shelf, 0.16), (x, 0, 0.62), 0.01))
        parts.append(block(case, (0.06, 0.07, 0.62), (x, depth + shelf - 0.08, 0), 0.01))
        parts.append(block(case, (0.05, shelf + 0.02, 0.07), (x, depth, 0), 0.006))
    keys = width - 0.12
    parts.append(block(IVORY, (keys, 0.15, 0.025), (0, depth + 0.1, 0.69)))
    pitch = keys / 52
    for k in range(52):
        x = (k - 26) * pitch
        if k:
            parts.append(quad(0.0025, 0.15).turned(90, "x").moved(x, depth + 0.25, 0.7155).of(EBONY))
        if k and k % 7 not in (2, 5):
            parts.append(block(EBONY, (pitch * 0.55, 0.095, 0.012), (x, depth + 0.1, 0.715)))
    stand = block(case, (0.7, 0.012, 0.24), (0, 0, 0)).turned(12, "x").moved(0, depth + 0.06, 0.8)
    parts.append(stand)
    if chance(rng, 0.7):
        for x in (-0.115, 0.115):
            parts.append(quad(0.22, 0.3).turned(12, "x").moved(x, depth + 0.085, 0.81).of(palette.paper(rng)))
    for x in (-0.08, 0.0, 0.08):
        parts.append(block(palette.METALS[2], (0.025, 0.09, 0.012), (x, depth, 0.05)))
    if chance(rng, 0.8):
        y = depth + shelf + between(rng, -0.1, 0.05)
        parts.append(legs("square", 0.55, 0.33, 0.43, case, 0.045).moved(0, y, 0))
        parts.append(block(palette.leather(rng), (0.57, 0.35, 0.07), (0, y - 0.01, 0.42), 0.015))
    return grounded(join(parts))
