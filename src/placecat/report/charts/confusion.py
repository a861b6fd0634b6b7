"""Chart of all confusion matrices of a table."""

from collections.abc import Mapping

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from placecat.drawing.palette import place_title
from placecat.results.confusion import ALL_HOMES, in_home, pooled_counts, shares
from placecat.results.measured import Measured

_MAP = "Blues"
# Inches.
_CELL = 0.11


def confusion_sheet(title: str, rows: Mapping[tuple[str, str], Mapping[str, Measured]]) -> Figure | None:
    """Draw all confusion matrices of a table: one line per row, with each column or each home.

    `rows` are from :func:`placecat.thesis.decisions.decisions_of`; without any there is no figure.
    """
    lines = {key: _blocks(of_row) for key, of_row in rows.items() if of_row}
    if not lines:
        return None
    columns = list(dict.fromkeys(name for blocks in lines.values() for name in blocks))
    size = max(len(values) for blocks in lines.values() for values in blocks.values())
    # One picture of all, as hundreds of axes would take minutes. The gaps are NaN, which shows as white.
    step = size + 1
    canvas = np.full((len(lines) * step - 1, len(columns) * step - 1), np.nan)
    for y, blocks in enumerate(lines.values()):
        for name, values in blocks.items():
            x = columns.index(name)
            canvas[y * step : y * step + len(values), x * step : x * step + len(values)] = values
    labels = ["\n".join(part for part in key if part) for key in lines]
    left = 0.2 + 0.058 * max(len(line) for label in labels for line in label.split("\n"))
    height, width = (_CELL * count for count in canvas.shape)
    above, right, below = 0.65, 0.75, 0.1
    # The title may need the room.
    full = (max(left + width + right, 5.2), above + height + below)
    figure = Figure(figsize=full)
    axes = _panel(figure, left, below, width, height)
    image = axes.imshow(canvas, cmap=_MAP, vmin=0, vmax=100, interpolation="nearest")
    axes.set_yticks(np.arange(len(lines)) * step + (size - 1) / 2, labels)
    axes.set_xticks(np.arange(len(columns)) * step + (size - 1) / 2, columns)
    axes.tick_params(length=0)
    axes.xaxis.tick_top()
    axes.spines[:].set_visible(False)
    bar_height = min(height, 1.4)
    scale = _panel(figure, left + width + 0.12, below + height - bar_height, 0.1, bar_height)
    bar = figure.colorbar(image, cax=scale)
    bar.set_label("percent of the true place")
    bar.outline.set_visible(False)
    figure.text(0.1 / full[0], 1 - 0.08 / full[1], title, va="top", fontsize=9)
    return figure


def _panel(figure: Figure, left: float, bottom: float, width: float, height: float) -> Axes:
    """Axes at a place in inches from the lower left corner."""
    across, up = figure.get_size_inches()
    return figure.add_axes((left / across, bottom / up, width / across, height / up))


def _blocks(of_row: Mapping[str, Measured]) -> dict[str, np.ndarray]:
    parts: dict[str, Measured] = {}
    for column, one in of_row.items():
        if column == "" and len(of_row) == 1 and len(one.homes) > 1:
            parts |= {place_title(home): in_home(one, home) for home in one.homes}
            parts[ALL_HOMES] = one
        else:
            parts[column] = one
    return {name: shares(pooled_counts(one)) for name, one in parts.items()}
