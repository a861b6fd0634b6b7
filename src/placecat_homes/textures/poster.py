"""Large printed posters, with a coloured heading above columns of boxes with text, plots and pictures."""

import numpy as np
from numpy.typing import NDArray

from placecat_homes.parts.raster import Canvas


def draw(rng: np.random.Generator, colours: list[NDArray[np.floating]], pixels: int) -> NDArray[np.float32]:
    """Draw a poster.

    Parameters
    ----------
    rng
        Random number generator.
    colours
        Colours of the paper and heading, followed by colours for pictures.
    pixels
        Side length of the image.

    Returns
    -------
    (pixels, pixels, 3) float32
        sRGB, row 0 at the top.
    """
    paper = colours[0]
    heading = colours[1] if len(colours) > 1 else np.array([0.1, 0.2, 0.5])
    accents = colours[2:] or [heading]
    dark = np.full(3, 0.12)
    canvas = Canvas(pixels, paper)
    high = float(rng.uniform(0.1, 0.2))
    if rng.random() < 0.7:
        canvas.rectangle(0, 0, 1, high, heading)
        canvas.words(rng, 0.08, 0.92, high * 0.5, high * 0.28, paper)
        canvas.words(rng, 0.2, 0.8, high * 0.82, high * 0.12, paper)
    else:
        canvas.words(rng, 0.08, 0.92, high * 0.5, high * 0.32, heading)
        canvas.words(rng, 0.2, 0.8, high * 0.85, high * 0.12, dark)
    columns = int(rng.integers(2, 4))
    width = 0.94 / columns
    for column in range(columns):
        x, y = 0.03 + column * width, high + 0.03
        while y < 0.93:
            height = min(float(rng.uniform(0.14, 0.32)), 0.97 - y)
            _block(rng, canvas, x, y, width - 0.03, height, heading, accents, dark)
            y += height + 0.02
    return canvas.picture


def _block(
    rng: np.random.Generator,
    canvas: Canvas,
    x: float,
    y: float,
    w: float,
    h: float,
    heading: NDArray[np.floating],
    accents: list[NDArray[np.floating]],
    dark: NDArray[np.floating],
) -> None:
    accent = accents[int(rng.integers(len(accents)))]
    kind = rng.random()
    if kind < 0.3:
        canvas.rectangle(x, y, x + w, y + h, accent)
        for _ in range(5):
            a, b = rng.random(2)
            tint = np.clip(accent + rng.normal(0, 0.25, 3), 0, 1)
            canvas.disc(x + w * (0.2 + 0.6 * a), y + h * (0.3 + 0.4 * b), 0.2 * min(w, h), tint)
        return
    canvas.words(rng, x, x + 0.7 * w, y + 0.025, 0.022, heading)
    if kind < 0.55:
        canvas.stroke([(x, y + 0.05), (x, y + h), (x + w, y + h)], 0.005, dark)
        t = np.linspace(0, 1, 12)
        for _ in range(2):
            pen = accents[int(rng.integers(len(accents)))]
            curve = np.clip(0.5 + np.cumsum(rng.normal(0, 0.1, 12)), 0.05, 0.95)
            canvas.stroke(np.stack([x + t * w, y + 0.05 + (h - 0.05) * curve], 1), 0.008, pen)
        return
    line = y + 0.055
    while line < y + h:
        canvas.words(rng, x, x + w * (1 if rng.random() < 0.8 else 0.6), line, 0.011, dark)
        line += 0.022
