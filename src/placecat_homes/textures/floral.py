"""Flowers and leaves scattered on a background, for wallpaper, curtains and covers."""

import numpy as np

from placecat_homes.noise import Field, grid, smooth


def draw(rng: np.random.Generator, colours: list[Field], pixels: int) -> Field:
    """Draw flowers in the second and any further colours, on a background of the first."""
    x, y = grid(pixels)
    picture = np.broadcast_to(colours[0], (pixels, pixels, 3)) * (
        1 + 0.02 * smooth(rng, pixels, 0.6)[..., None]
    )
    n = int(rng.integers(3, 6))
    for i in range(n):
        for j in range(n):
            cx, cy = (i + 0.5 * (j % 2) + rng.uniform(-0.15, 0.15)) / n, (j + rng.uniform(-0.15, 0.15)) / n
            dx, dy = (x - cx + 0.5) % 1 - 0.5, (y - cy + 0.5) % 1 - 0.5
            r, a = np.hypot(dx, dy) * n, np.arctan2(dy, dx) + rng.uniform(0, 6.28)
            petals = int(rng.integers(4, 8))
            colour = colours[1 + int(rng.integers(len(colours) - 1))]
            size = rng.uniform(0.22, 0.42)
            flower = r < size * (0.65 + 0.35 * np.cos(petals * a))
            heart = r < size * 0.22
            stem = (np.abs(np.sin(a) * r - 0.12 * np.cos(a) * r) < 0.02) & (r < 0.6) & (np.cos(a) > 0)
            picture = np.where((stem | flower)[..., None], colour, picture)
            picture = np.where(heart[..., None], colours[0] * 0.7, picture)
    return picture.astype(np.float32)
