"""Basket-weave parquet."""

import numpy as np

from placecat_homes.noise import Field, grid, mix, smooth


def draw(rng: np.random.Generator, colours: list[Field], pixels: int) -> Field:
    """Draw squares of five strips each, in alternating directions."""
    x, y = grid(pixels)
    n, strips = 4, 5
    i, j = (x * n).astype(int), (y * n).astype(int)
    upright = (i + j) % 2 == 0
    across = np.where(upright, x * n % 1, y * n % 1) * strips
    strip = across.astype(int)
    tone = rng.uniform(-0.14, 0.14, n * n * strips)[(i * n + j) * strips + strip]
    edge = np.minimum(across % 1, 1 - across % 1) < 0.05
    rim = np.minimum(np.minimum(x * n % 1, 1 - x * n % 1), np.minimum(y * n % 1, 1 - y * n % 1)) < 0.012
    fibre = np.where(upright, smooth(rng, pixels, 0.9, 16.0).T, smooth(rng, pixels, 0.9, 16.0))
    board = mix(colours[0], colours[1], 0.45 + 0.2 * fibre) * (1 + tone[..., None])
    return np.where((edge | rim)[..., None], board * 0.6, board).astype(np.float32)
