"""Thesis 4.5, Figure 15: confusion matrices after integration and after smoothing."""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import NDArray

from placecat.drawing import palette
from placecat.errors import PlacecatError
from placecat.evaluation.accuracy import home_accuracy
from placecat.ranges import Count
from placecat.report.run import Run, home_of

TITLE = (
    "A home's confusion matrices after integration and after smoothing, for the first seed. Each cell shows "
    "the percentage of the frames of the row's place that were classified as the column's place, with the "
    "number of frames below."
)

WIDTH = 6.5
# Percentages at or above this value are written in white.
DARK = 55.0


def draw(run: Run, *, home: Count, panels: Mapping[str, str]) -> Figure:
    """Draw one matrix per panel, using the settings in ``figures.figure_15``."""
    chosen = home_of(run, home)
    drawn = Figure(figsize=(WIDTH, WIDTH / len(panels) + 0.3))
    grid = drawn.subplots(1, len(panels), squeeze=False, sharey=True)[0]
    for number, (axes, (title, result)) in enumerate(zip(grid, panels.items(), strict=True)):
        measured = run.results.of(result)
        if chosen not in measured.homes:
            raise PlacecatError(f"{result} was not measured on {chosen}")
        confusion = measured.confusion[0, measured.homes.index(chosen)]
        matrix(axes, confusion, measured.classes)
        letter = f"({chr(ord('a') + number)}) " if len(panels) > 1 else ""
        shown = f"{letter}{palette.written(title)}, accuracy {home_accuracy(confusion):.1f}%"
        axes.set_title(shown, loc="left")
    grid[0].set_ylabel(f"true place of {palette.place_title(chosen)}")
    return drawn


def matrix(axes: Axes, confusion: NDArray[np.int64], classes: Sequence[str]) -> None:
    """Draw (classes, classes) counts, one row per true place; a place without frames gets a row of dashes."""
    totals = confusion.sum(axis=1, keepdims=True)
    percent = 100.0 * confusion / np.maximum(totals, 1)
    axes.imshow(percent, cmap=palette.AMOUNT, vmin=0.0, vmax=100.0)
    for row, column in np.ndindex(*confusion.shape):
        color = "white" if percent[row, column] >= DARK else palette.INK
        text: dict[str, Any] = {"ha": "center", "color": color}
        if not totals[row]:
            axes.text(column, row, "–", va="center", **text)
            continue
        axes.text(column, row, f"{percent[row, column]:.1f}", va="bottom", fontsize=8, **text)
        axes.text(column, row + 0.06, f"{confusion[row, column]}", va="top", fontsize=7, **text)
    names = [palette.place_title(place).replace(" ", "\n") for place in classes]
    axes.set_xticks(range(len(names)), names)
    axes.set_yticks(range(len(names)), names)
    axes.tick_params(length=0)
    axes.set_xlabel("decided place")
    axes.spines[:].set_visible(True)


FIGURES = {"figure_15": (TITLE, draw)}
