"""Printed pages and posters, with a heading, lines of text, and perhaps a picture."""

import numpy as np

from placecat_homes.noise import Field, grid, smooth


def draw(rng: np.random.Generator, colours: list[Field], pixels: int) -> Field:
    """Draw text in the second colour on a background of the first."""
    x, y = grid(pixels)
    picture = np.broadcast_to(colours[0], (pixels, pixels, 3)).astype(np.float32)
    ink = colours[1] if len(colours) > 1 else np.array([0.15, 0.15, 0.18])
    lines = int(rng.integers(18, 36))
    number = (y * lines).astype(int)
    ends = rng.uniform(0.35, 0.92, lines)[number]
    words = smooth(rng, pixels, 0.9, 0.3) > -0.9
    text = (y * lines % 1 < 0.5) & (x > 0.08) & (x < ends) & (y > 0.2) & (y < 0.94) & words
    picture = np.where(text[..., None], ink, picture)
    head = (y > 0.06) & (y < 0.06 + rng.uniform(0.04, 0.1)) & (x > 0.08) & (x < rng.uniform(0.5, 0.92))
    picture = np.where(head[..., None], colours[-1] * 0.8, picture)
    if rng.random() < 0.5:
        y0, x0 = rng.uniform(0.25, 0.5), rng.uniform(0.08, 0.4)
        block = (y > y0) & (y < y0 + 0.3) & (x > x0) & (x < x0 + 0.5)
        field = np.clip(0.5 + 0.25 * smooth(rng, pixels, 1.6), 0, 1)
        picture = np.where(block[..., None], field[..., None] * colours[-1] * 1.3, picture)
    return picture.astype(np.float32)
