"""Oriental and modern rugs, with a border around a central field."""

import numpy as np

from placecat_homes.noise import Field, grid, smooth


def draw(rng: np.random.Generator, colours: list[Field], pixels: int) -> Field:
    """Draw borders around a central field of diamonds, bands, circles or plain pile."""
    x, y = grid(pixels)
    edge = np.minimum(np.minimum(x, 1 - x), np.minimum(y, 1 - y))
    u, v = np.abs(x - 0.5), np.abs(y - 0.5)
    kind = int(rng.integers(5))
    table = np.stack(colours)
    k = len(colours)
    if kind == 0:
        number = ((u + v) * rng.integers(6, 14)).astype(int)
    elif kind == 1:
        number = (y * rng.integers(5, 12)).astype(int)
    elif kind == 2:
        number = (np.hypot(u, v) * rng.integers(6, 14)).astype(int)
    elif kind == 3:
        number = (np.maximum(np.abs(np.sin(u * 30)), np.abs(np.sin(v * 30))) > 0.8).astype(int) + 2 * (
            u + v < 0.25
        )
    else:
        number = np.zeros(x.shape, int)
    picture = table[number % k]
    for width, colour in ((0.12, 1), (0.10, 2), (0.035, 0), (0.02, 1)):
        if kind != 2:
            picture = np.where((edge < width)[..., None], table[colour % k], picture)
    if kind in (0, 3):
        motif = (edge < 0.095) & (edge > 0.045) & (np.sin((x + y) * 60) > 0.3)
        picture = np.where(motif[..., None], table[3 % k], picture)
    return picture * (1 + 0.06 * smooth(rng, pixels, 0.3)[..., None])
