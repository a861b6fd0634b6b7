"""Signs beside office doors."""

import numpy as np

from placecat_homes.furniture.blocks import between, block, chance, choose
from placecat_homes.materials import Material
from placecat_homes.mesh import Mesh, join
from placecat_homes.parts.prints import ink, page
from placecat_homes.shapes import quad
from placecat_homes.style import Style


def door_sign(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a sign with a room number and names behind glass. It should hang about 1.4 m above the floor."""
    width, height = choose(rng, ((0.15, 0.15), (0.21, 0.12), (0.15, 0.21)))
    case = choose(rng, (Material((0.75, 0.76, 0.77), gloss=0.25, roughness=0.5), Material(ink(rng))))
    parts = [
        block(case, (width, 0.012, height), bevel=0.002),
        quad(width - 0.02, height * 0.6)
        .moved(0, 0.0125, 0.012)
        .of(page(rng, width * 1.4, height * 1.2, white=1)),
    ]
    dark = Material((0.1, 0.1, 0.12))
    for k in range(3):
        size = (width * 0.1, 0.001, height * 0.14)
        parts.append(block(dark, size, (width * (0.32 - 0.15 * k), 0.012, height * 0.76)))
    if chance(rng, 0.3):
        z = -between(rng, 0.3, 0.35)
        parts.append(quad(0.21, 0.297).moved(0, 0.002, z).of(page(rng, 0.21, 0.297)))
    whole = join(parts)
    return whole.moved(z=-float(whole.low[2]))
