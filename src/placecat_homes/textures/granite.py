"""Granite, terrazzo and speckled laminate, with specks in the other colours over the first."""

import numpy as np

from placecat_homes.noise import Field, smooth


def draw(rng: np.random.Generator, colours: list[Field], pixels: int) -> Field:
    """Draw specks in several sizes."""
    picture = np.broadcast_to(colours[0], (pixels, pixels, 3)).astype(np.float32)
    for k, colour in enumerate(colours[1:]):
        specks = smooth(rng, pixels, 0.55 + 0.25 * k) > 1.15
        picture = np.where(specks[..., None], colour, picture)
    return picture * (1 + 0.04 * smooth(rng, pixels, 0.2)[..., None])
