"""Vertical stripes in the given colours."""

import numpy as np

from placecat_homes.noise import Field, grid, smooth


def draw(rng: np.random.Generator, colours: list[Field], pixels: int) -> Field:
    """Draw stripes of various widths."""
    x, _ = grid(pixels)
    widths = rng.uniform(0.4, 1.6, 2 * len(colours))
    ends = np.cumsum(widths) / widths.sum()
    number = np.searchsorted(ends, x) % len(colours)
    return np.stack(colours)[number] * (1 + 0.03 * smooth(rng, pixels, 0.5)[..., None])
