"""A bar chart of the averages in a table: one bar per result, with a point for each home or place."""

from dataclasses import dataclass
from typing import Any

import numpy as np
import pandas as pd
from matplotlib.figure import Figure

from placecat.thesis.number import AVERAGE

BAR, POINT, PUBLISHED = "#0072b2", "#222222", "#d55e00"
# Width, line height, and total space above and below the lines, in inches.
_WIDTH, _LINE, _ROUND = 6.5, 0.19, 0.85
_HOME = r"Home \d+"


def accuracy_chart(title: str, cells: pd.DataFrame, *, published: bool) -> Figure | None:
    """Draw a filled table's averages (see `bars_of`); return None if there are none.

    `published` says whether to draw the published numbers as well; they must come from the same data.
    """
    bars = bars_of(cells)
    if not bars:
        return None
    # Each bar takes up one line, and so does each section name.
    places: list[int] = []
    headings: dict[int, str] = {}
    section = ""
    for bar in bars:
        if bar.section != section:
            headings[len(places) + len(headings)] = section = bar.section
        places.append(len(places) + len(headings))
    lines = len(places) + len(headings)
    figure = Figure(figsize=(_WIDTH, _ROUND + _LINE * lines))
    axes = figure.subplots()
    axes.barh(places, [bar.measured for bar in bars], height=0.72, color=BAR, alpha=0.75)
    placed = list(zip(bars, places, strict=True))
    points = [(value, place) for bar, place in placed for value in bar.points]
    if points:
        style: dict[str, Any] = {"color": POINT, "markersize": 6, "markeredgewidth": 0.8}
        axes.plot(*zip(*points, strict=True), "|", label=f"one {point_name(cells)}", **style)
    other = [(bar.published, place) for bar, place in placed if published and np.isfinite(bar.published)]
    if other:
        axes.plot(*zip(*other, strict=True), "D", color=PUBLISHED, markerfacecolor="white", label="published")
    shown = [*(bar.measured for bar in bars), *(value for value, _ in [*points, *other])]
    axes.set_yticks(places, [bar.label for bar in bars])
    axes.tick_params(axis="y", length=0)
    text: dict[str, Any] = {"transform": axes.get_yaxis_transform(), "va": "center", "fontsize": 7}
    for bar, place in placed:
        axes.text(1.02, place, f"{bar.measured:.2f}", **text)
    clear = {"facecolor": "white", "edgecolor": "none", "pad": 1.0}
    for place, heading in headings.items():
        axes.text(0.006, place, heading, fontweight="bold", bbox=clear, **text)
    axes.set_ylim(lines - 0.4, -0.6)
    # A few tables contain gains, which can be negative.
    axes.set_xlim(min(0.0, np.floor(min(shown) / 10) * 10), min(100.0, np.ceil(max(shown) / 10 + 0.01) * 10))
    axes.set_xlabel("accuracy in percent, mean over places")
    axes.xaxis.grid(True)
    figure.suptitle(title, wrap=True)
    if points or other:
        figure.legend(*axes.get_legend_handles_labels(), loc="outside lower right", ncols=2)
    return figure


@dataclass(frozen=True)
class Bar:
    """One bar of the chart, with numbers in percent.

    `section` is the name of its group ("" if there is none), and `label` is its own name. `measured` is the
    mean of `points`, which are numbers from the table. `published` is NaN if missing.
    """

    section: str
    label: str
    measured: float
    published: float
    points: tuple[float, ...]


def bars_of(cells: pd.DataFrame) -> list[Bar]:
    """Turn a filled table's averages into bars.

    The bars show averages over homes or, if there are none, averages over places. A table without averages
    gets one bar per cell. The bars are in table order. Cells that were not measured get no bar.
    """
    axis = _averaged(cells)
    if axis is None:
        names = zip(cells["group"], cells["row"], strict=True)
        sections = [", ".join(filter(None, name)) for name in names]
        named = cells.assign(section=sections, label=cells["column"])
    else:
        named = cells.assign(section=cells["group"], label=cells["column" if axis == "row" else "row"])
    bars = []
    for (section, label), part in named.groupby(["section", "label"], sort=False):
        whole = part if axis is None else part[part[axis] == AVERAGE]
        # A table with a single home has no average.
        whole = part if whole.empty else whole
        if len(whole) != 1 or not np.isfinite(whole["measured"].iloc[0]):
            continue
        points = part.drop(whole.index)["measured"].dropna()
        measured, published = (float(whole[column].iloc[0]) for column in ("measured", "published"))
        bars.append(Bar(str(section), str(label), measured, published, tuple(points)))
    return bars


def point_name(cells: pd.DataFrame) -> str:
    """Return what a point on a bar stands for: "home" or "place"."""
    axis = _averaged(cells)
    return "home" if axis is not None and cells[axis].str.fullmatch(_HOME).any() else "place"


def _averaged(cells: pd.DataFrame) -> str | None:
    """Return the axis ("row" or "column") over which a table is averaged, or None if it is not."""
    for axis in ("row", "column"):
        if cells[axis].str.fullmatch(_HOME).any():
            return axis
    return "column" if (cells["column"] == AVERAGE).any() else None
