"""Text in pictures, in the font of the figures, which OpenCV cannot draw."""

from functools import lru_cache

import numpy as np
from matplotlib.backends.backend_agg import RendererAgg
from matplotlib.font_manager import FontProperties
from numpy.typing import NDArray

from placecat.drawing.palette import written

_FONT = "DejaVu Sans"
# Fractions of the font size: below the baseline, and the total height.
_DESCENT, _LINE = 0.28, 1.3


def line_height(size: int) -> int:
    """Height in pixels of a line of text."""
    return round(_LINE * size)


@lru_cache(maxsize=1024)
def mask(text: str, size: int, *, bold: bool = False) -> NDArray[np.float32]:
    """(line_height(size), width) float32 in [0, 1]: how much of each pixel one line of text covers.

    `size` is the font size in pixels.
    """
    text = written(text)
    if not text:
        return np.zeros((line_height(size), 0), np.float32)
    properties = FontProperties(family=_FONT, size=size, weight="bold" if bold else "normal")
    width = int(np.ceil(_renderer(1, 1).get_text_width_height_descent(text, properties, False)[0])) + 2
    height = line_height(size)
    # A figure with this text gives the same pixels, and takes twice as long.
    renderer = _renderer(width, height)
    renderer.draw_text(renderer.new_gc(), 1, height - _DESCENT * size, text, properties, 0)
    return (np.asarray(renderer.buffer_rgba())[:, :, 3] / 255).astype(np.float32)


def _renderer(width: int, height: int) -> RendererAgg:
    # At 72 dots an inch a point is a pixel.
    return RendererAgg(width, height, 72)


def write(
    picture: NDArray[np.uint8],
    text: str,
    where: tuple[int, int],
    size: int,
    color: tuple[int, int, int],
    *,
    bold: bool = False,
    align: str = "left",
) -> int:
    """Write a line into a picture (H, W, 3) uint8, BGR, cut at its edges; returns the width of the text.

    `where` is x and y of the line's upper left corner, or upper right corner with ``align="right"``;
    `size` is the font size in pixels; `color` is BGR.
    """
    cover = mask(text, size, bold=bold)
    left = where[0] - (cover.shape[1] if align == "right" else 0)
    stamp(picture, cover, (left, where[1]), color)
    return cover.shape[1]


def stamp(
    picture: NDArray[np.uint8],
    cover: NDArray[np.float32],
    where: tuple[int, int],
    color: tuple[int, int, int],
) -> None:
    """Colour a picture (H, W, 3), BGR, where a mask (h, w) covers it, its upper left corner at x and y."""
    left, top = where
    x, y = max(left, 0), max(top, 0)
    part = picture[y : top + cover.shape[0], x : left + cover.shape[1]]
    own = cover[y - top :, x - left :][: part.shape[0], : part.shape[1], None]
    part[:] = np.rint(part * (1 - own) + np.array(color, np.float32) * own).astype(np.uint8)
