"""A small canvas for drawing lines, rectangles, discs and rows of words."""

import itertools

import numpy as np
from numpy.typing import ArrayLike, NDArray


class Canvas:
    """A square picture on which x runs from 0 (left) to 1 (right) and y from 0 (top) to 1 (bottom).

    Parameters
    ----------
    pixels
        Side length of the image in pixels.
    ground
        sRGB colour of the background.
    """

    def __init__(self, pixels: int, ground: ArrayLike) -> None:
        self.pixels = pixels
        self.picture: NDArray[np.float32] = np.empty((pixels, pixels, 3), np.float32)
        self.picture[:] = np.asarray(ground, np.float32)

    def _blend(self, rows: slice, columns: slice, cover: NDArray[np.floating], colour: ArrayLike) -> None:
        part = self.picture[rows, columns]
        part += np.asarray(cover, np.float32)[..., None] * (np.asarray(colour, np.float32) - part)

    def _window(self, x0: float, y0: float, x1: float, y1: float) -> tuple[slice, slice]:
        n = self.pixels
        low = np.clip(np.floor(np.array([x0, y0]) * n - 1), 0, n).astype(int)
        high = np.clip(np.ceil(np.array([x1, y1]) * n + 1), 0, n).astype(int)
        return slice(int(low[1]), int(high[1])), slice(int(low[0]), int(high[0]))

    def _grid(self, rows: slice, columns: slice) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        y = (np.arange(rows.start, rows.stop) + 0.5) / self.pixels
        x = (np.arange(columns.start, columns.stop) + 0.5) / self.pixels
        return x[None, :], y[:, None]

    def rectangle(
        self, x0: float, y0: float, x1: float, y1: float, colour: ArrayLike, cover: float = 1.0
    ) -> None:
        """Fill a rectangle."""
        rows, columns = self._window(x0, y0, x1, y1)
        x, y = self._grid(rows, columns)
        n = self.pixels
        across = np.clip((x - x0) * n + 0.5, 0, 1) * np.clip((x1 - x) * n + 0.5, 0, 1)
        down = np.clip((y - y0) * n + 0.5, 0, 1) * np.clip((y1 - y) * n + 0.5, 0, 1)
        self._blend(rows, columns, cover * across * down, colour)

    def frame(self, x0: float, y0: float, x1: float, y1: float, width: float, colour: ArrayLike) -> None:
        """Draw the outline of a rectangle."""
        self.stroke([(x0, y0), (x1, y0), (x1, y1), (x0, y1), (x0, y0)], width, colour)

    def disc(self, x: float, y: float, radius: float, colour: ArrayLike) -> None:
        """Fill a disc."""
        self.stroke([(x, y), (x, y)], 2 * radius, colour)

    def stroke(self, points: ArrayLike, width: float, colour: ArrayLike) -> None:
        """Draw a line with rounded ends through the points."""
        line = np.asarray(points, np.float64)
        for a, b in itertools.pairwise(line):
            low, high = np.minimum(a, b) - width, np.maximum(a, b) + width
            rows, columns = self._window(low[0], low[1], high[0], high[1])
            x, y = self._grid(rows, columns)
            d = b - a
            t = ((x - a[0]) * d[0] + (y - a[1]) * d[1]) / max(float(d @ d), 1e-12)
            t = np.clip(t, 0, 1)
            away = np.hypot(x - a[0] - t * d[0], y - a[1] - t * d[1])
            self._blend(rows, columns, np.clip((width / 2 - away) * self.pixels + 0.5, 0, 1), colour)

    def polygon(self, points: ArrayLike, colour: ArrayLike) -> None:
        """Fill a convex polygon whose corners run clockwise on the screen."""
        corners = np.asarray(points, np.float64)
        rows, columns = self._window(*corners.min(axis=0), *corners.max(axis=0))
        x, y = self._grid(rows, columns)
        cover = np.ones((rows.stop - rows.start, columns.stop - columns.start))
        for a, b in zip(corners, np.roll(corners, -1, axis=0), strict=True):
            d = (b - a) / max(float(np.linalg.norm(b - a)), 1e-12)
            inside = d[0] * (y - a[1]) - d[1] * (x - a[0])
            cover = np.minimum(cover, np.clip(inside * self.pixels + 0.5, 0, 1))
        self._blend(rows, columns, cover, colour)

    def words(
        self, rng: np.random.Generator, x0: float, x1: float, y: float, height: float, colour: ArrayLike
    ) -> None:
        """Draw a line of words between x0 and x1 at height y, with a small block for each letter."""
        x = x0
        step = height * 0.7
        while x + 2 * step < x1:
            letters = int(rng.integers(2, 10))
            for _ in range(letters):
                if x + step > x1:
                    break
                tall = height * (1.0 if rng.random() < 0.3 else 0.7)
                self.rectangle(x, y - tall, x + step * 0.75, y, colour, float(rng.uniform(0.45, 0.9)))
                x += step
            x += step * 1.2

    def writing(
        self, rng: np.random.Generator, x0: float, x1: float, y: float, height: float, colour: ArrayLike
    ) -> None:
        """Draw a line of handwriting: a scribble broken into words."""
        x = x0
        while x + height < x1:
            end = min(x1, x + height * float(rng.uniform(1.2, 5.0)))
            n = max(4, int((end - x) / (height * 0.22)))
            line = np.stack([np.linspace(x, end, n), y - height * rng.random(n) * rng.choice([0.6, 1], n)], 1)
            line[:, 0] += rng.normal(0, height * 0.12, n)
            self.stroke(line, height * 0.13, colour)
            x = end + height * 0.6
