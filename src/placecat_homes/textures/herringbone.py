"""Herringbone parquet."""

import numpy as np

from placecat_homes.noise import Field, grid, mix, smooth


def draw(rng: np.random.Generator, colours: list[Field], pixels: int) -> Field:
    """Draw slanted blocks in columns that are mirror images of each other."""
    x, y = grid(pixels)
    columns, rows = 6, 12
    column = (x * columns).astype(int)
    fx = x * columns - column
    slant = np.where(column % 2 == 0, fx, 1 - fx)
    across = y * rows + slant * 2
    block = np.floor(across).astype(int) % rows
    tone = rng.uniform(-0.15, 0.15, rows * columns)[block * columns + column]
    edge = (np.minimum(across % 1, 1 - across % 1) < 0.05) | (np.minimum(fx, 1 - fx) < 0.015)
    board = mix(colours[0], colours[1], 0.45 + 0.2 * smooth(rng, pixels, 0.9, 4.0)) * (1 + tone[..., None])
    return np.where(edge[..., None], board * 0.6, board).astype(np.float32)
