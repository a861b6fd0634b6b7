"""Draw distributions over places as divided bars (Figures 9, 12 to 14 and 18)."""

from collections.abc import Mapping, Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.colors import to_rgb
from matplotlib.figure import Figure
from matplotlib.patches import Patch
from numpy.typing import NDArray

from placecat.drawing.palette import INK, place_colors, place_title

# Smallest share that has room for its percentage.
LEAST_WRITTEN = 0.07
LEGEND_COLUMNS = 5


def share_bar(
    axes: Axes, y: float, shares: NDArray[np.floating], classes: Sequence[str], *, height: float = 0.7
) -> None:
    """Draw (classes,) shares, 0 to 1, as a horizontal bar around `y`, with percentages if there is room."""
    left = 0.0
    for share, color in zip(shares.tolist(), place_colors(classes).values(), strict=True):
        axes.barh(y, share, height, left, color=color, edgecolor="white", linewidth=0.6)
        if share >= LEAST_WRITTEN:
            ink = "white" if np.dot(to_rgb(color), (0.299, 0.587, 0.114)) < 0.55 else INK
            axes.text(
                left + share / 2, y, f"{100 * share:.0f}", color=ink, fontsize=7, ha="center", va="center"
            )
        left += share


def share_rows(
    axes: Axes, rows: Mapping[str, NDArray[np.floating]], classes: Sequence[str], *, height: float = 0.7
) -> None:
    """Draw one (classes,) distribution per row, its name on the left; the first is at 0, the next at -1."""
    for row, shares in enumerate(rows.values()):
        share_bar(axes, -row, shares, classes, height=height)
    axes.set_yticks([-row for row in range(len(rows))], list(rows))
    axes.set_xlim(0, 1)
    axes.set_ylim(-len(rows) + 0.5, 0.5)
    axes.set_xticks([])
    axes.tick_params(length=0)
    axes.spines[:].set_visible(False)


def place_legend(figure: Figure, classes: Sequence[str], at: tuple[float, float]) -> None:
    """Draw the legend of the places' colours; `at` is its left centre in fractions of the figure."""
    handles = [Patch(color=color) for color in place_colors(classes).values()]
    titles = [place_title(place) for place in classes]
    figure.legend(
        handles,
        titles,
        loc="center left",
        bbox_to_anchor=at,
        handlelength=1.0,
        handleheight=0.8,
        columnspacing=1.0,
        borderaxespad=0,
        ncols=min(len(handles), LEGEND_COLUMNS),
    )
