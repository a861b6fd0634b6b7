"""Woven cloth."""

import numpy as np

from placecat_homes.noise import Field, grid, mix, smooth


def draw(rng: np.random.Generator, colours: list[Field], pixels: int) -> Field:
    """Draw interwoven threads in the first and second colours."""
    x, y = grid(pixels)
    threads = 48
    over = ((x * threads).astype(int) + (y * threads).astype(int)) % 2
    bump = np.where(over == 0, np.sin(np.pi * (x * threads % 1)), np.sin(np.pi * (y * threads % 1)))
    cloth = mix(colours[0], colours[1], over * 0.6 + 0.12 * smooth(rng, pixels, 0.5))
    return cloth * (0.86 + 0.14 * bump + 0.03 * smooth(rng, pixels, 1.2))[..., None]
