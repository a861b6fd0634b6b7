"""Framed mirrors."""

import numpy as np

from placecat_homes import palette
from placecat_homes.furniture.blocks import between, block, chance, choose
from placecat_homes.mesh import Mesh, join
from placecat_homes.parts.outlines import frontal, oval
from placecat_homes.shapes import box, quad
from placecat_homes.style import Style


def mirror(
    rng: np.random.Generator, style: Style, width: float | None = None, height: float | None = None
) -> Mesh:
    """Draw a rectangular, round or oval framed mirror to hang on a wall.

    Parameters
    ----------
    rng, style
        Random number generator and style of the home.
    width, height
        Size in metres; 0.4 to 0.75 by 0.6 to 1.6 if None.
    """
    width = width or between(rng, 0.4, 0.75)
    height = height or choose(rng, (between(rng, 1.2, 1.6), between(rng, 0.6, 1.0)))
    frame = choose(rng, (style.metal, style.any_wood(rng), palette.paint(rng)))
    if chance(rng, 0.3):
        if chance(rng, 0.5):
            height = width
        rim = between(rng, 0.02, 0.06)
        outer = frontal(oval(width, height, 28), 0.025, smooth=True).moved(0, 0, height / 2).of(frame)
        glass = frontal(oval(width - 2 * rim, height - 2 * rim, 28), 0.004).moved(0, 0.024, height / 2)
        return join(outer, glass.of(palette.MIRROR))
    bar = between(rng, 0.02, 0.09)
    parts = [
        quad(width - 2 * bar, height - 2 * bar).moved(0, 0.014, bar).of(palette.MIRROR),
        block(frame, (width - 0.01, 0.012, height - 0.01), (0, 0, 0.005)),
    ]
    for z in (0.0, height - bar):
        parts.append(box(width, 0.03, bar, 0.006).moved(0, 0, z).of(frame))
    for side in (-1, 1):
        parts.append(box(bar, 0.0295, height, 0.006).moved(side * (width - bar) / 2).of(frame))
    return join(parts)
