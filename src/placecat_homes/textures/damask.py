"""Curved tone-on-tone ornaments."""

import numpy as np

from placecat_homes.noise import Field, grid, mix


def draw(rng: np.random.Generator, colours: list[Field], pixels: int) -> Field:
    """Draw mirrored waves in the second colour on a background of the first."""
    x, y = grid(pixels)
    n = int(rng.integers(2, 4))
    u, v = np.abs(x * n % 1 - 0.5) * 2, y * n % 1
    a, b, c = rng.uniform(0.5, 2.0, 3)
    wave = (
        np.sin(2 * np.pi * (v + 0.35 * np.sin(np.pi * u * a)))
        + b * 0.6 * np.cos(2 * np.pi * (2 * v - c * u)) * u
    )
    return mix(colours[0], colours[1], (wave > 0.55).astype(np.float32))
