"""Rectangular tiles or bricks in running bond, with joints in the second colour."""

import numpy as np

from placecat_homes.noise import Field, cells, smooth


def draw(rng: np.random.Generator, colours: list[Field], pixels: int) -> Field:
    """Draw eight rows of four tiles."""
    number, du, dv = cells(pixels, 4, 8, 0.5)
    tone = rng.uniform(-0.07, 0.07, 32)[number]
    tile = colours[0] * (1 + tone + 0.03 * smooth(rng, pixels, 0.8))[..., None]
    joint = (du < 0.02) | (dv < 0.045)
    return np.where(joint[..., None], colours[1], tile).astype(np.float32)
