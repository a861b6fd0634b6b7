"""Pile carpets."""

import numpy as np

from placecat_homes.noise import Field, mix, smooth


def draw(rng: np.random.Generator, colours: list[Field], pixels: int) -> Field:
    """Draw tufts in shades between the first and second colours."""
    return mix(colours[0], colours[1], 0.4 + 0.3 * smooth(rng, pixels, 0.15)) * (
        1 + 0.05 * smooth(rng, pixels, 1.3)[..., None]
    )
