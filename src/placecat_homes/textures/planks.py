"""Floorboards that run along u."""

import numpy as np

from placecat_homes.noise import Field, cells, grid, mix, smooth


def draw(rng: np.random.Generator, colours: list[Field], pixels: int) -> Field:
    """Draw eight rows of boards in different tones, with dark joints."""
    number, _, dv = cells(pixels, 1, 8)
    tone = rng.uniform(-0.13, 0.13, 8)[number]
    x, _ = grid(pixels)
    ends = rng.uniform(0, 1, 8)[number]
    gap = np.abs((x - ends + 0.5) % 1 - 0.5)
    fibre = smooth(rng, pixels, 0.9, 20.0)
    board = mix(colours[0], colours[1], 0.45 + 0.25 * fibre) * (1 + tone[..., None])
    joint = (dv < 0.035) | (gap < 0.004)
    return np.where(joint[..., None], board * 0.45, board).astype(np.float32)
