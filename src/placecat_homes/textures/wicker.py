"""Wickerwork."""

import numpy as np
from numpy.typing import NDArray

STRANDS = 8
"""Number of canes per repetition in each direction."""


def draw(rng: np.random.Generator, colours: list[NDArray[np.floating]], pixels: int) -> NDArray[np.float32]:
    """Draw horizontal canes woven over and under upright ones.

    Parameters
    ----------
    rng
        Random number generator.
    colours
        Colours of the canes and the gaps.
    pixels
        Side length of the image.

    Returns
    -------
    NDArray[np.float32]
        (pixels, pixels, 3) sRGB.
    """
    grid = (np.arange(pixels) + 0.5) / pixels * STRANDS
    row, column = np.floor(grid).astype(int), np.floor(grid).astype(int)
    over = (row[:, None] + column[None, :]) % 2 == 0
    across = np.abs(grid[:, None] % 1 - 0.5) * 2 + 0 * grid[None, :]
    along = np.abs(grid[None, :] % 1 - 0.5) * 2 + 0 * grid[:, None]
    body = np.where(over, 1 - across**2, 1 - along**2)
    bulge = np.where(over, 1 - 0.5 * along**2, 1 - 0.5 * across**2)
    tone = rng.uniform(0.85, 1.1, (STRANDS, STRANDS))[row[:, None], column[None, :]]
    light = np.clip(body * bulge * tone, 0, 1)[..., None]
    first = np.asarray(colours[0])
    second = np.asarray(colours[1]) if len(colours) > 1 else first * 0.35
    return np.clip(second + (first - second) * light, 0, 1).astype(np.float32)
