"""Meeting tables for offices."""

import numpy as np

from placecat_homes.furniture.blocks import between, block, chance, legs
from placecat_homes.furniture.desk import HEIGHT
from placecat_homes.mesh import Mesh, join
from placecat_homes.parts.drawers import surface
from placecat_homes.shapes import cylinder
from placecat_homes.style import Style


def meeting_table(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a desk-height table, either a round one on a column or a square one on legs."""
    wide = between(rng, 0.8, 1.1)
    top = surface(rng, style)
    if chance(rng, 0.6):
        parts = [
            cylinder(wide / 2, 0.028, 32).moved(z=HEIGHT - 0.028).of(top),
            cylinder(0.04, HEIGHT - 0.04, 14).moved(z=0.02).of(style.metal),
            cylinder(wide * 0.3, 0.025, 24).of(style.metal),
        ]
        return join(parts).moved(y=wide / 2)
    frame = style.metal if chance(rng, 0.6) else top
    return join(
        block(top, (wide, wide, 0.028), (0, 0, HEIGHT - 0.028), 0.004),
        legs(
            "square" if chance(rng, 0.5) else "round", wide - 0.06, wide - 0.06, HEIGHT - 0.028, frame, 0.045
        ).moved(0, 0.03),
    )
