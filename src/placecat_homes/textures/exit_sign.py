"""The green sign at an emergency exit, with a running person, an arrow and a door."""

import numpy as np
from numpy.typing import NDArray

from placecat_homes.parts.raster import Canvas


def draw(rng: np.random.Generator, colours: list[NDArray[np.floating]], pixels: int) -> NDArray[np.float32]:
    """Draw the sign.

    Parameters
    ----------
    rng
        Random number generator, which chooses the direction.
    colours
        Colours of the background and the figures.
    pixels
        Side length. The image is stretched over a sign that is twice as wide as it is high.

    Returns
    -------
    (pixels, pixels, 3) float32
        sRGB, row 0 at the top.
    """
    green, white = colours[0], colours[1]
    canvas = Canvas(pixels, green)
    canvas.rectangle(0.66, 0.12, 0.92, 0.9, white)
    canvas.disc(0.745, 0.24, 0.045, green)
    for line, width in (
        ([(0.74, 0.32), (0.72, 0.58)], 0.07),
        ([(0.74, 0.36), (0.66, 0.46), (0.62, 0.42)], 0.04),
        ([(0.74, 0.36), (0.82, 0.48), (0.87, 0.44)], 0.04),
        ([(0.72, 0.58), (0.8, 0.7), (0.8, 0.86)], 0.045),
        ([(0.72, 0.58), (0.68, 0.74), (0.6, 0.8)], 0.045),
    ):
        canvas.stroke(line, width, green)
    canvas.rectangle(0.2, 0.44, 0.5, 0.56, white)
    canvas.polygon([(0.06, 0.5), (0.26, 0.26), (0.26, 0.74)], white)
    return canvas.picture if rng.random() < 0.5 else np.ascontiguousarray(canvas.picture[:, ::-1])
