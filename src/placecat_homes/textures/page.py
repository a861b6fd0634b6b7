"""Printed sheets with headings, lines of text, and sometimes pictures or tables."""

import numpy as np
from numpy.typing import NDArray

from placecat_homes.parts.raster import Canvas


def draw(rng: np.random.Generator, colours: list[NDArray[np.floating]], pixels: int) -> NDArray[np.float32]:
    """Draw a page.

    Parameters
    ----------
    rng
        Random number generator.
    colours
        Colours of the paper and ink, followed by colours for pictures.
    pixels
        Side length of the image.

    Returns
    -------
    (pixels, pixels, 3) float32
        sRGB, row 0 at the top.
    """
    paper, ink = colours[0], colours[1] if len(colours) > 1 else np.full(3, 0.1)
    accents = colours[2:] or [ink]
    canvas = Canvas(pixels, paper)
    y = 0.1
    accent = accents[int(rng.integers(len(accents)))]
    if rng.random() < 0.7:
        height = float(rng.uniform(0.025, 0.06))
        canvas.words(rng, 0.1, float(rng.uniform(0.5, 0.9)), y + height, height, accent)
        y += height + 0.05
    while y < 0.88:
        kind = rng.random()
        if kind < 0.25 and y < 0.6:
            height = float(rng.uniform(0.15, 0.3))
            _figure(rng, canvas, y, height, accents, ink)
            y += height + 0.04
        else:
            for _ in range(int(rng.integers(3, 8))):
                if y > 0.9:
                    break
                canvas.words(rng, 0.1, 0.9 if rng.random() < 0.75 else 0.6, y + 0.014, 0.014, ink)
                y += 0.028
            y += 0.03
    return canvas.picture


def _figure(
    rng: np.random.Generator,
    canvas: Canvas,
    y: float,
    height: float,
    accents: list[NDArray[np.floating]],
    ink: NDArray[np.floating],
) -> None:
    accent = accents[int(rng.integers(len(accents)))]
    kind = rng.random()
    if kind < 0.4:
        canvas.rectangle(0.15, y, 0.85, y + height, accent)
        canvas.rectangle(0.15, y, 0.85, y + height * float(rng.uniform(0.3, 0.7)), accent * 0.5 + 0.4)
        canvas.disc(float(rng.uniform(0.3, 0.7)), y + height / 2, height * 0.22, accent * 0.4)
    elif kind < 0.7:
        bars = int(rng.integers(4, 9))
        for k in range(bars):
            x = 0.2 + 0.6 * k / bars
            top = y + height * float(rng.uniform(0.05, 0.9))
            canvas.rectangle(x, top, x + 0.4 / bars, y + height, accent)
        canvas.stroke([(0.18, y), (0.18, y + height), (0.84, y + height)], 0.005, ink)
    else:
        for k in range(6):
            line = y + height * k / 5
            canvas.stroke([(0.12, line), (0.88, line)], 0.004, ink)
        for k in range(5):
            x = 0.12 + 0.76 * k / 4
            canvas.stroke([(x, y), (x, y + height)], 0.004, ink)
