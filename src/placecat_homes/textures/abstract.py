"""Abstract pictures."""

import numpy as np

from placecat_homes.noise import Field, grid, smooth


def draw(rng: np.random.Generator, colours: list[Field], pixels: int) -> Field:
    """Draw blots, bars and discs in the given colours."""
    x, y = grid(pixels)
    table = np.stack(colours)
    picture = table[0] * np.ones((pixels, pixels, 1))
    for _ in range(int(rng.integers(5, 14))):
        colour = table[int(rng.integers(len(table)))] * rng.uniform(0.7, 1.1)
        cx, cy, r = rng.uniform(0, 1), rng.uniform(0, 1), rng.uniform(0.06, 0.3)
        kind = int(rng.integers(3))
        if kind == 0:
            mask = np.hypot(x - cx, y - cy) < r
        elif kind == 1:
            a = rng.uniform(0, np.pi)
            mask = np.abs((x - cx) * np.cos(a) + (y - cy) * np.sin(a)) < r * 0.25
        else:
            mask = smooth(rng, pixels, 2.0) > rng.uniform(0.6, 1.4)
        picture = np.where(mask[..., None], colour, picture)
    return (picture * (1 + 0.03 * smooth(rng, pixels, 0.6)[..., None])).astype(np.float32)
