"""Checked cloth and gingham."""

import numpy as np

from placecat_homes.noise import Field, grid, mix, smooth


def draw(rng: np.random.Generator, colours: list[Field], pixels: int) -> Field:
    """Draw crossing bands in the second colour, and the third if any, on a background of the first."""
    x, y = grid(pixels)
    n = int(rng.integers(2, 6))
    across, down = (x * n % 1 < 0.5), (y * n % 1 < 0.5)
    cloth = mix(colours[0], colours[1], 0.5 * across + 0.5 * down)
    if len(colours) > 2:
        line = (np.abs(x * n % 1 - 0.25) < 0.03) | (np.abs(y * n % 1 - 0.25) < 0.03)
        cloth = np.where(line[..., None], colours[2], cloth)
    return cloth * (1 + 0.03 * smooth(rng, pixels, 0.3)[..., None])
