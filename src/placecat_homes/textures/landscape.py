"""Painted or photographed landscapes."""

import numpy as np

from placecat_homes.noise import Field, grid, mix, smooth


def draw(rng: np.random.Generator, colours: list[Field], pixels: int) -> Field:
    """Draw a sky, ranges of hills, and a lake or meadow, tinted with the first colour."""
    x, y = grid(pixels)
    tint = colours[0]
    sky = mix(np.array([0.45, 0.6, 0.85]), np.array([0.95, 0.88, 0.78]), y * 1.6)
    picture = sky * (1 + 0.06 * np.clip(smooth(rng, pixels, 1.8), 0, 3)[..., None])
    horizon = rng.uniform(0.4, 0.6)
    for k in range(4):
        line = (
            horizon
            - 0.1
            + 0.07 * k
            + (0.09 - 0.02 * k) * np.interp(x[0], np.linspace(0, 1, 9), rng.uniform(-1, 1, 9))
        )
        shade = np.array([0.32, 0.42, 0.5]) * (1 - 0.25 * k) + np.array([0.1, 0.22, 0.05]) * 0.3 * k
        picture = np.where((y > line[None, :])[..., None], shade * rng.uniform(0.8, 1.2), picture)
    lake = y > horizon + rng.uniform(0.15, 0.3)
    picture = np.where(
        lake[..., None], (sky[::-1] * 0.7 if rng.random() < 0.5 else np.array([0.45, 0.5, 0.25])), picture
    )
    return (0.75 * picture + 0.25 * picture * tint * 1.5).astype(np.float32) * (
        1 + 0.04 * smooth(rng, pixels, 0.8)[..., None]
    )
