"""Portraits and family photographs."""

import numpy as np

from placecat_homes.noise import Field, grid


def draw(rng: np.random.Generator, colours: list[Field], pixels: int) -> Field:
    """Draw the heads and shoulders of one to three people against a plain background."""
    x, y = grid(pixels)
    picture = colours[0] * (1.1 - 0.5 * np.hypot(x - 0.5, y - 0.4))[..., None]
    count = int(rng.integers(1, 4))
    for k in range(count):
        cx, cy, r = (
            (k + 1) / (count + 1) + rng.uniform(-0.05, 0.05),
            rng.uniform(0.36, 0.48),
            0.30 / (count + 1) + 0.03,
        )
        skin = np.array([0.86, 0.66, 0.54]) * rng.uniform(0.45, 1.08)
        hair = np.array([0.5, 0.35, 0.2]) * rng.uniform(0.2, 1.5)
        body = ((x - cx) / (r * 1.8)) ** 2 + ((y - 1.05) / (1.0 - cy - r * 0.6)) ** 2 < 1
        picture = np.where(
            body[..., None], colours[1 + k % (len(colours) - 1)] if len(colours) > 1 else 0.3, picture
        )
        head = ((x - cx) / (r * 0.78)) ** 2 + ((y - cy) / r) ** 2 < 1
        mane = ((x - cx) / (r * 0.95)) ** 2 + ((y - cy + r * 0.2) / (r * 1.08)) ** 2 < 1
        picture = np.where(mane[..., None], hair, picture)
        picture = np.where((head & (y > cy - r * 0.45))[..., None], skin, picture)
    return picture.astype(np.float32)
