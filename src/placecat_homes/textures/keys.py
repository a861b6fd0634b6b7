"""The keys of a computer keyboard, seen from above."""

import itertools

import numpy as np
from numpy.typing import NDArray

from placecat_homes.parts.raster import Canvas


def draw(rng: np.random.Generator, colours: list[NDArray[np.floating]], pixels: int) -> NDArray[np.float32]:
    """Draw rows of keys in three blocks.

    Parameters
    ----------
    rng
        Random number generator.
    colours
        Colours of the case and the keys.
    pixels
        Side length. The image is stretched over the keyboard.

    Returns
    -------
    (pixels, pixels, 3) float32
        sRGB, row 0 at the far side.
    """
    case, key = colours[0], colours[1]
    canvas = Canvas(pixels, case)
    blocks = [(0.02, 0.66, 15), (0.69, 0.81, 3), (0.84, 0.98, 4)]
    rows = 6
    for row in range(rows):
        y0 = 0.05 + row * 0.15 + (0.03 if row else 0)
        for x0, x1, count in blocks:
            if row == 5 and count == 15:
                edges = np.array([0, 1.3, 2.6, 4, 9.5, 10.9, 12.3, 13.6, 15]) / 15
            else:
                edges = np.arange(count + 1) / count
            for a, b in itertools.pairwise(edges):
                left, right = x0 + a * (x1 - x0) + 0.003, x0 + b * (x1 - x0) - 0.003
                canvas.rectangle(left, y0, right, y0 + 0.125, key * 0.8)
                canvas.rectangle(left + 0.003, y0 + 0.01, right - 0.003, y0 + 0.1, key)
                if rng.random() < 0.9:
                    letter = np.clip(1.15 - key, 0, 1)
                    canvas.rectangle(left + 0.009, y0 + 0.025, left + 0.018, y0 + 0.065, letter, 0.6)
    return canvas.picture
