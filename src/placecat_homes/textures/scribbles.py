"""Formulas, diagrams, lists and plots left behind on a whiteboard."""

import itertools

import numpy as np
from numpy.typing import NDArray

from placecat_homes.parts.raster import Canvas

Pen = NDArray[np.floating]


def draw(rng: np.random.Generator, colours: list[NDArray[np.floating]], pixels: int) -> NDArray[np.float32]:
    """Draw scribbles.

    Parameters
    ----------
    rng
        Random number generator.
    colours
        Colour of the board, followed by those of the pens.
    pixels
        Side length of the image.

    Returns
    -------
    (pixels, pixels, 3) float32
        sRGB, row 0 at the top.
    """
    canvas = Canvas(pixels, colours[0])
    pens = colours[1:] or [np.array([0.1, 0.15, 0.5])]
    for _ in range(int(rng.integers(1, 4))):
        x, y = rng.random(2)
        smear = colours[0] * 0.93 + 0.07 * pens[0]
        canvas.stroke([(x, y), (x + 0.2, y + 0.05), (x, y + 0.1)], 0.05, smear)
    columns, rows = int(rng.integers(2, 4)), int(rng.integers(2, 4))
    for i in range(columns):
        for j in range(rows):
            if rng.random() < 0.2:
                continue
            pen = pens[int(rng.integers(len(pens)))]
            x, y = (i + 0.1) / columns, (j + 0.12) / rows
            kind = rng.choice(["list", "boxes", "plot", "formula"])
            _DRAWN[kind](rng, canvas, pen, x, y, 0.8 / columns, 0.76 / rows)
    return canvas.picture


def _list(rng: np.random.Generator, canvas: Canvas, pen: Pen, x: float, y: float, w: float, h: float) -> None:
    lines = int(rng.integers(3, 6))
    for k in range(lines):
        line = y + (k + 0.7) * h / lines
        canvas.disc(x + 0.01, line - 0.01, 0.006, pen)
        canvas.writing(rng, x + 0.03, x + w * float(rng.uniform(0.5, 1)), line, 0.45 * h / lines, pen)


def _boxes(
    rng: np.random.Generator, canvas: Canvas, pen: Pen, x: float, y: float, w: float, h: float
) -> None:
    places = [(x + a * w, y + b * h) for a, b in ((0.02, 0.05), (0.6, 0.1), (0.3, 0.65))]
    for a, b in places:
        canvas.frame(a, b, a + 0.35 * w, b + 0.25 * h, 0.006, pen)
        canvas.writing(rng, a + 0.03 * w, a + 0.32 * w, b + 0.17 * h, 0.08 * h, pen)
    for (a, b), (c, d) in itertools.pairwise(places):
        start = np.array([a + 0.3 * w, b + 0.25 * h])
        end = np.array([c + 0.05 * w, d])
        canvas.stroke([start, end], 0.005, pen)
        canvas.stroke([end - np.array([0.02, 0.01]), end, end - np.array([0.0, 0.025])], 0.005, pen)


def _plot(rng: np.random.Generator, canvas: Canvas, pen: Pen, x: float, y: float, w: float, h: float) -> None:
    canvas.stroke([(x, y), (x, y + h), (x + w, y + h)], 0.006, pen)
    t = np.linspace(0, 1, 14)
    for _ in range(int(rng.integers(1, 3))):
        curve = np.clip(rng.uniform(0.1, 0.9) + np.cumsum(rng.normal(0, 0.08, 14)), 0.05, 0.95)
        canvas.stroke(np.stack([x + t * w, y + h * curve], 1), 0.007, pen)
    canvas.writing(rng, x + 0.55 * w, x + w, y + 0.15 * h, 0.08 * h, pen)


def _formula(
    rng: np.random.Generator, canvas: Canvas, pen: Pen, x: float, y: float, w: float, h: float
) -> None:
    for k in range(int(rng.integers(1, 4))):
        line = y + (k + 0.8) * h / 3
        canvas.writing(rng, x, x + 0.3 * w, line, 0.15 * h, pen)
        canvas.stroke([(x + 0.36 * w, line - 0.03), (x + 0.42 * w, line - 0.03)], 0.006, pen)
        canvas.stroke([(x + 0.36 * w, line - 0.045), (x + 0.42 * w, line - 0.045)], 0.006, pen)
        canvas.stroke([(x + 0.48 * w, line - 0.04), (x + 0.95 * w, line - 0.04)], 0.005, pen)
        canvas.writing(rng, x + 0.5 * w, x + 0.9 * w, line - 0.055, 0.08 * h, pen)
        canvas.writing(rng, x + 0.55 * w, x + 0.85 * w, line + 0.02, 0.08 * h, pen)


_DRAWN = {"list": _list, "boxes": _boxes, "plot": _plot, "formula": _formula}
