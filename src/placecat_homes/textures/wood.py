"""Wood grain that runs along u."""

import numpy as np

from placecat_homes.noise import Field, grid, mix, smooth


def draw(rng: np.random.Generator, colours: list[Field], pixels: int) -> Field:
    """Draw grain in shades between the first and second colours, with fine fibres."""
    _, y = grid(pixels)
    bend = 0.06 * smooth(rng, pixels, 1.8, 6.0)
    rings = 0.5 + 0.5 * np.sin(
        2 * np.pi * (rng.integers(4, 9) * y + 2.5 * bend + 1.2 * smooth(rng, pixels, 2.0, 8.0) * 0.15)
    )
    fibre = smooth(rng, pixels, 0.8, 24.0)
    return mix(colours[0], colours[1], 0.55 * rings + 0.22 * fibre) * (
        1 + 0.05 * smooth(rng, pixels, 1.0, 12.0)[..., None]
    )
