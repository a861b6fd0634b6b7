"""Soil, gravel and cork."""

import numpy as np

from placecat_homes.noise import Field, mix, smooth


def draw(rng: np.random.Generator, colours: list[Field], pixels: int) -> Field:
    """Draw grains in shades between the first and second colours."""
    return mix(colours[0], colours[1], 0.5 + 0.35 * smooth(rng, pixels, 0.5))
