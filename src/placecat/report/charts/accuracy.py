"""Draw a bar chart of a table's averages."""

from typing import Any

import numpy as np
import pandas as pd
from matplotlib.figure import Figure

from placecat.report.charts.bars import bars_of, point_name

BAR, POINT, PUBLISHED = "#0072b2", "#222222", "#d55e00"
# Inches: width, height of a line, and total space above and below the lines.
_WIDTH, _LINE, _ROUND = 6.5, 0.19, 0.85


def accuracy_chart(title: str, cells: pd.DataFrame, *, published: bool) -> Figure | None:
    """Draw a filled table's averages (see `bars_of`); return None if there are none.

    `published` says whether to draw the published numbers too; they must be from the same data.
    """
    bars = bars_of(cells)
    if not bars:
        return None
    # Lines from top to bottom: bars and section names.
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
    # A few tables have gains, which may be negative.
    axes.set_xlim(min(0.0, np.floor(min(shown) / 10) * 10), min(100.0, np.ceil(max(shown) / 10 + 0.01) * 10))
    axes.set_xlabel("accuracy in percent, mean over places")
    axes.xaxis.grid(True)
    figure.suptitle(title, wrap=True)
    if points or other:
        figure.legend(*axes.get_legend_handles_labels(), loc="outside lower right", ncols=2)
    return figure
