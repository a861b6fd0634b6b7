"""Plaster, paint and other nearly plain surfaces."""

import numpy as np

from placecat_homes.noise import Field, smooth


def draw(rng: np.random.Generator, colours: list[Field], pixels: int) -> Field:
    """Draw faint blots and grain on the first colour."""
    field = 0.006 * smooth(rng, pixels, 1.3) + 0.007 * smooth(rng, pixels, 0.3)
    return colours[0] * (1 + field[..., None])
