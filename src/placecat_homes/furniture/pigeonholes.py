"""Racks of mail slots."""

import numpy as np

from placecat_homes.furniture.blocks import between, block, chance
from placecat_homes.materials import Material
from placecat_homes.mesh import Mesh, join
from placecat_homes.parts.drawers import surface
from placecat_homes.parts.prints import ink, leaf
from placecat_homes.style import Style


def pigeonholes(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a rack of mail slots with names, letters and papers, standing on a low cabinet.

    Parameters
    ----------
    rng, style
        Random number generator and style of the home.
    """
    columns, rows = int(rng.integers(3, 6)), int(rng.integers(5, 10))
    slot_wide, slot_high, deep = between(rng, 0.25, 0.3), between(rng, 0.09, 0.13), between(rng, 0.33, 0.38)
    skin = surface(rng, style)
    thick = 0.012
    width, height = columns * slot_wide + thick, rows * slot_high + thick
    low = between(rng, 0.65, 0.9)
    parts = [
        block(skin, (width, deep, low - 0.06), (0, 0, 0.06), 0.003),
        block(Material((0.1, 0.1, 0.1)), (width - 0.03, deep - 0.04, 0.06)),
        block(skin, (width, 0.01, height), (0, 0, low)),
    ]
    doors = max(2, columns // 2 * 2)
    for k in range(doors):
        x = (k + 0.5) * width / doors - width / 2
        parts.append(block(skin, (width / doors - 0.006, 0.016, low - 0.08), (x, deep, 0.07), 0.003))
        grip = (x + (0.35 if k % 2 == 0 else -0.35) * width / doors, deep + 0.016, low * 0.7)
        parts.append(block(style.metal, (0.012, 0.015, 0.09), grip))
    for k in range(columns + 1):
        x = k * slot_wide - width / 2 + thick / 2
        parts.append(block(skin, (thick, deep, height), (x, 0, low)))
    for k in range(rows + 1):
        parts.append(block(skin, (width - thick, deep - 0.002, 0.008), (0, 0, low + k * slot_high)))
    for i in range(columns):
        for j in range(rows):
            x = (i + 0.5) * slot_wide - width / 2 + thick / 2
            z = low + j * slot_high
            parts.append(
                block(Material((0.93, 0.93, 0.9)), (0.08, 0.002, 0.012), (x, deep - 0.001, z - 0.002))
            )
            up = z + 0.008
            for _ in range(int(rng.choice([0, 1, 2, 3], p=[0.3, 0.35, 0.25, 0.1]))):
                tall = between(rng, 0.004, slot_high * 0.3)
                body = leaf(rng) if chance(rng, 0.75) else Material(ink(rng))
                wide = between(rng, 0.16, 0.215)
                y = between(rng, 0.02, deep - 0.31)
                parts.append(block(body, (wide, 0.3, tall), (x + between(rng, -0.015, 0.015), y, up)))
                up += tall
    return join(parts)
