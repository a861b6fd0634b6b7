"""Green leaves with veins."""

import numpy as np

from placecat_homes.noise import Field, grid, mix, smooth


def draw(rng: np.random.Generator, colours: list[Field], pixels: int) -> Field:
    """Draw a midrib and slanted veins in the second colour over the first."""
    x, y = grid(pixels)
    vein = np.abs((y * 6 + np.abs(x - 0.5) * 4) % 1 - 0.5) < 0.06
    rib = np.abs(x - 0.5) < 0.03
    return mix(colours[0], colours[1], (vein * 0.5 + rib * 0.8) + 0.1 * smooth(rng, pixels, 1.0))
