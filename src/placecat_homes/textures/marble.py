"""Marble with veins in the second colour."""

import numpy as np

from placecat_homes.noise import Field, mix, smooth


def draw(rng: np.random.Generator, colours: list[Field], pixels: int) -> Field:
    """Draw clouds, with veins where two smooth fields cross zero."""
    vein = np.exp(-np.abs(smooth(rng, pixels, 1.9)) * 14) + 0.5 * np.exp(
        -np.abs(smooth(rng, pixels, 1.7)) * 20
    )
    return mix(colours[0], colours[1], 0.12 * smooth(rng, pixels, 1.6) + 0.75 * vein)
