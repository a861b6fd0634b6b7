"""The image on a computer screen, with windows showing text, tables and pictures on a background."""

import numpy as np
from numpy.typing import NDArray

from placecat_homes.parts.raster import Canvas


def draw(rng: np.random.Generator, colours: list[NDArray[np.floating]], pixels: int) -> NDArray[np.float32]:
    """Draw a desktop.

    Parameters
    ----------
    rng
        Random number generator.
    colours
        Background colour, followed by colours for title bars and pictures.
    pixels
        Side length of the image.

    Returns
    -------
    (pixels, pixels, 3) float32
        sRGB, row 0 at the top.
    """
    canvas = Canvas(pixels, colours[0])
    accents = colours[1:] or [np.array([0.2, 0.35, 0.7])]
    fade = np.linspace(1.15, 0.75, pixels, dtype=np.float32)[:, None, None]
    canvas.picture *= fade
    for k in range(int(rng.integers(3, 9))):
        x, y = 0.03 + 0.08 * (k // 6), 0.04 + 0.13 * (k % 6)
        canvas.rectangle(x, y, x + 0.04, y + 0.055, accents[k % len(accents)])
        canvas.words(rng, x - 0.01, x + 0.06, y + 0.08, 0.014, (0.95, 0.95, 0.95))
    for _ in range(int(rng.integers(1, 4))):
        w, h = rng.uniform(0.45, 0.85), rng.uniform(0.5, 0.82)
        x, y = rng.uniform(0.02, 0.98 - w), rng.uniform(0.03, 0.93 - h)
        _window(rng, canvas, float(x), float(y), float(w), float(h), accents)
    bar = np.array([0.12, 0.13, 0.16]) if rng.random() < 0.6 else np.array([0.75, 0.76, 0.78])
    canvas.rectangle(0, 0.95, 1, 1, bar)
    for k in range(6):
        canvas.rectangle(0.02 + 0.05 * k, 0.96, 0.05 + 0.05 * k, 0.99, accents[k % len(accents)])
    return canvas.picture


def _window(
    rng: np.random.Generator,
    canvas: Canvas,
    x: float,
    y: float,
    w: float,
    h: float,
    accents: list[NDArray[np.floating]],
) -> None:
    dark = rng.random() < 0.25
    paper = np.array([0.1, 0.11, 0.13]) if dark else np.array([0.96, 0.96, 0.97])
    ink = np.array([0.75, 0.8, 0.75]) if dark else np.array([0.2, 0.2, 0.25])
    canvas.rectangle(x, y, x + w, y + h, paper)
    canvas.rectangle(x, y, x + w, y + 0.04, accents[int(rng.integers(len(accents)))])
    canvas.rectangle(x, y + 0.04, x + w, y + 0.085, np.array([0.82, 0.83, 0.85]))
    kind = rng.choice(["text", "table", "mail", "picture"])
    top = y + 0.13
    if kind == "table":
        for k in range(int((h - 0.14) / 0.04)):
            line = top + 0.04 * k
            canvas.rectangle(x, line, x + w, line + 0.003, np.array([0.7, 0.7, 0.72]))
            for column in range(5):
                if rng.random() < 0.7:
                    left = x + 0.02 + column * w / 5
                    canvas.words(rng, left, left + 0.12 * w, line - 0.008, 0.014, ink)
        return
    left = x + 0.03
    if kind in ("mail", "picture"):
        canvas.rectangle(x, y + 0.085, x + 0.22 * w, y + h, paper * 0.88)
        for k in range(int((h - 0.14) / 0.06)):
            canvas.words(rng, x + 0.01, x + 0.2 * w, top + 0.06 * k, 0.014, ink)
        left = x + 0.25 * w
    if kind == "picture":
        tint = accents[int(rng.integers(len(accents)))]
        canvas.rectangle(left, top, x + w - 0.03, y + h - 0.05, tint * 0.6 + 0.3)
        canvas.rectangle(left, top + 0.55 * (h - 0.2), x + w - 0.03, y + h - 0.05, tint * 0.6)
        return
    line = top
    while line < y + h - 0.02:
        if rng.random() < 0.88:
            start = left + 0.03 * int(rng.integers(0, 3)) * dark
            canvas.words(rng, start, start + (x + w - 0.03 - start) * rng.uniform(0.4, 1), line, 0.016, ink)
        line += 0.032
