"""Write text into images in the font used for figures, which OpenCV cannot do."""

from functools import lru_cache

import numpy as np
from matplotlib.backends.backend_agg import RendererAgg
from matplotlib.font_manager import FontProperties
from numpy.typing import NDArray

from placecat.drawing.palette import written

_FONT = "DejaVu Sans"
# The depth below the baseline and the height of a line, as fractions of the font size.
_DESCENT, _LINE = 0.28, 1.3
# At this many dots per inch, one point is one pixel.
_DPI = 72


def line_height(size: int) -> int:
    """Return the height of a line of text in pixels; `size` is the font size."""
    return round(_LINE * size)


@lru_cache(maxsize=1024)
def mask(text: str, size: int, *, bold: bool = False) -> NDArray[np.float32]:
    """Return the share of each pixel that a line of text covers.

    `size` is the font size in pixels. The result is (line_height(size), width) float32 in [0, 1].
    """
    text = written(text)
    if not text:
        return np.zeros((line_height(size), 0), np.float32)
    properties = FontProperties(family=_FONT, size=size, weight="bold" if bold else "normal")
    width = (
        int(np.ceil(RendererAgg(1, 1, _DPI).get_text_width_height_descent(text, properties, False)[0])) + 2
    )
    height = line_height(size)
    # Drawing the text in a figure would produce the same pixels, but take twice as long.
    renderer = RendererAgg(width, height, _DPI)
    renderer.draw_text(renderer.new_gc(), 1, height - _DESCENT * size, text, properties, 0)
    return (np.asarray(renderer.buffer_rgba())[:, :, 3] / 255).astype(np.float32)


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
    """Write a line of text into an (H, W, 3) uint8 BGR image, and return the width of the text.

    The text is cut off at the edges of the image. `where` is the (x, y) position of the text's upper left
    corner, or of its upper right corner if `align` is ``right``. `size` is the font size in pixels, and
    `color` is BGR.
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
    """Colour an (H, W, 3) BGR image through an (h, w) mask whose upper left corner is at `where` (x, y)."""
    left, top = where
    x, y = max(left, 0), max(top, 0)
    part = picture[y : top + cover.shape[0], x : left + cover.shape[1]]
    own = cover[y - top :, x - left :][: part.shape[0], : part.shape[1], None]
    part[:] = np.rint(part * (1 - own) + np.array(color, np.float32) * own).astype(np.uint8)
