"""Draw confusion matrices as images: one table row with numbers, or a whole table in colours only.

The images are built with NumPy, because Matplotlib takes ten times as long.
"""

from collections.abc import Mapping
from pathlib import Path

import cv2
import numpy as np
from matplotlib import colormaps
from numpy.typing import NDArray

from placecat import files
from placecat.drawing.lettering import line_height, mask, stamp, write
from placecat.drawing.palette import place_title
from placecat.results.confusion import ALL_HOMES, in_home, pooled_counts, shares
from placecat.results.measured import Measured

_MAP = "Blues"
# Cell size, gap between matrices, margin, and text sizes, in pixels.
_CELL, _GAP, _MARGIN, _TEXT, _TITLE = 46, 28, 12, 12, 15
# Cell size in pixels in the image of a whole table, which shows no numbers.
_PIXEL = 13
_INK, _PAPER = (0x22, 0x22, 0x22), (255, 255, 255)
# Cells above this percentage are dark, so their numbers are white.
_DARK = 55
_CAPTION = (
    "Rows are true places; columns are decisions. Numbers are percentages of the frames of the true place."
)
_SHEET = (
    "Rows are true places; columns are decisions. White means no frames of the place; dark blue means all."
)


def draw_matrices(target: Path, title: str, matrices: Mapping[str, Measured]) -> None:
    """Write a PNG that shows captioned matrices of the same places side by side.

    Each number is the percentage of the frames of the row's true place that were classified as the column's
    place, over all homes and seeds. Identical matrices produce identical files.
    """
    names = [place_title(place) for place in next(iter(matrices.values())).classes]
    side = _CELL * len(names)
    left = _MARGIN + max(_width(name) for name in names) + 8
    top = _MARGIN + line_height(_TITLE) + line_height(_TEXT) + 10 + line_height(_TEXT)
    under = [_slanted(name) for name in names]
    below = max(label.shape[0] for label in under) + 8
    widths = [max(side, _width(caption)) + _GAP for caption in matrices]
    width = left + sum(widths)
    width = max(width, _MARGIN + _width(title, _TITLE, bold=True), _MARGIN + _width(_CAPTION)) + _MARGIN
    picture = _paper(top + side + below + _MARGIN, width, title, _CAPTION)
    for number, name in enumerate(names):
        y = top + number * _CELL + (_CELL - line_height(_TEXT)) // 2
        write(picture, name, (left - 8, y), _TEXT, _INK, align="right")
    x = left
    for (caption, one), taken in zip(matrices.items(), widths, strict=True):
        write(picture, caption, (x, top - line_height(_TEXT) - 4), _TEXT, _INK)
        _paint(picture[top : top + side, x : x + side], shares(pooled_counts(one)))
        for number, label in enumerate(under):
            right = x + number * _CELL + _CELL // 2 + 8
            stamp(picture, label, (right - label.shape[1], top + side + 4), _INK)
        x += taken
    _save(picture, target)


def draw_sheet(target: Path, title: str, rows: Mapping[tuple[str, str], Mapping[str, Measured]]) -> bool:
    """Write a PNG of all of a table's matrices: one line per row, with one matrix per column or home.

    `rows` comes from :func:`placecat.thesis.decisions.decisions_of`. If there are no rows, the function
    writes nothing and returns False.
    """
    lines = {" / ".join(filter(None, labels)): _blocks(of_row) for labels, of_row in rows.items() if of_row}
    if not lines:
        return False
    columns = list(dict.fromkeys(name for blocks in lines.values() for name in blocks))
    side = _PIXEL * max(len(values) for blocks in lines.values() for values in blocks.values())
    step = max(side, *map(_width, columns)) + _MARGIN
    left = 2 * _MARGIN + max(map(_width, lines))
    top = _MARGIN + line_height(_TITLE) + 2 * line_height(_TEXT) + 14
    texts = max(_width(title, _TITLE, bold=True), _width(_SHEET))
    width = max(left + step * len(columns), 2 * _MARGIN + texts)
    picture = _paper(top + (side + _MARGIN) * len(lines), width, title, _SHEET)
    for number, name in enumerate(columns):
        write(picture, name, (left + number * step, top - line_height(_TEXT) - 4), _TEXT, _INK)
    for line, (label, blocks) in enumerate(lines.items()):
        y = top + line * (side + _MARGIN)
        where = (left - _MARGIN, y + (side - line_height(_TEXT)) // 2)
        write(picture, label, where, _TEXT, _INK, align="right")
        for name, percent in blocks.items():
            x = left + columns.index(name) * step
            block = _colors(percent).repeat(_PIXEL, axis=0).repeat(_PIXEL, axis=1)
            picture[y : y + len(block), x : x + len(block)] = block
    _save(picture, target)
    return True


def _blocks(of_row: Mapping[str, Measured]) -> dict[str, NDArray[np.float64]]:
    parts: dict[str, Measured] = {}
    for column, one in of_row.items():
        if column == "" and len(of_row) == 1 and len(one.homes) > 1:
            parts |= {place_title(home): in_home(one, home) for home in one.homes}
            parts[ALL_HOMES] = one
        else:
            parts[column] = one
    return {name: shares(pooled_counts(one)) for name, one in parts.items()}


def _paper(height: int, width: int, title: str, caption: str) -> NDArray[np.uint8]:
    # White is a single fill value; filling with a colour, which has three, takes 90 times as long.
    picture = np.full((height, width, 3), _PAPER[0], np.uint8)
    write(picture, title, (_MARGIN, _MARGIN), _TITLE, _INK, bold=True)
    write(picture, caption, (_MARGIN, _MARGIN + line_height(_TITLE)), _TEXT, _INK)
    return picture


def _save(picture: NDArray[np.uint8], target: Path) -> None:
    with files.replacing(target) as temporary:
        temporary.write_bytes(cv2.imencode(".png", picture)[1].tobytes())


def _colors(percent: NDArray[np.float64]) -> NDArray[np.uint8]:
    """Return (n, n, 3) uint8 BGR colours; NaN, which marks a place with no frames, becomes white."""
    colors = colormaps[_MAP](percent / 100.0, bytes=True)[:, :, 2::-1].copy()
    colors[np.isnan(percent)] = _PAPER
    return colors


def _paint(picture: NDArray[np.uint8], percent: NDArray[np.float64]) -> None:
    """Fill a (side, side, 3) image with one matrix; rows without frames stay white."""
    picture[:] = _colors(percent).repeat(_CELL, axis=0).repeat(_CELL, axis=1)
    for (i, k), value in np.ndenumerate(percent):
        if np.isnan(value):
            continue
        cell = picture[i * _CELL : (i + 1) * _CELL, k * _CELL : (k + 1) * _CELL]
        text = f"{value:.0f}"
        where = ((_CELL - _width(text)) // 2, (_CELL - line_height(_TEXT)) // 2)
        write(cell, text, where, _TEXT, _PAPER if value > _DARK else _INK)


def _width(text: str, size: int = _TEXT, *, bold: bool = False) -> int:
    return mask(text, size, bold=bold).shape[1]


def _slanted(text: str) -> NDArray[np.float32]:
    """Draw a line of text at 45 degrees, and return how much of each pixel it covers."""
    cover = mask(text, _TEXT)
    height, width = cover.shape
    size = int(np.ceil((height + width) / np.sqrt(2)))
    turn = cv2.getRotationMatrix2D((width / 2, height / 2), 45, 1.0)
    turn[:, 2] += (size - width) / 2, (size - height) / 2
    return cv2.warpAffine(cover, turn, (size, size)).astype(np.float32)
