"""A bar chart of a table's averages."""

import numpy as np
import pandas as pd
from matplotlib.figure import Figure

from placecat.report.charts.bars import Bar, bars_of, point_name

BAR, POINT, PUBLISHED = "#0072b2", "#222222", "#d55e00"
# Inches: a line of the chart, and what stands above and below all lines.
_WIDTH, _LINE, _ROUND = 6.5, 0.19, 0.85


def accuracy_chart(title: str, cells: pd.DataFrame, *, published: bool) -> Figure | None:
    """Draw the averages of a filled table.

    Parameters
    ----------
    cells
        See :func:`placecat.report.charts.bars.bars_of`.
    published
        Whether the published numbers were measured on the same data and may stand beside.

    Returns
    -------
    Figure or None
        None if nothing was measured.
    """
    bars = bars_of(cells)
    if not bars:
        return None
    lines = _lines(bars)
    figure = Figure(figsize=(_WIDTH, _ROUND + _LINE * len(lines)))
    axes = figure.subplots()
    at = {id(line): place for place, line in enumerate(lines) if isinstance(line, Bar)}
    places = np.array([at[id(bar)] for bar in bars])
    axes.barh(places, [bar.measured for bar in bars], height=0.72, color=BAR, alpha=0.75)
    points = [(value, at[id(bar)]) for bar in bars for value in bar.points]
    if points:
        axes.plot(
            *zip(*points, strict=True),
            "|",
            color=POINT,
            markersize=6,
            markeredgewidth=0.8,
            label=f"one {point_name(cells)}",
        )
    other = [(bar.published, at[id(bar)]) for bar in bars if np.isfinite(bar.published)] if published else []
    if other:
        axes.plot(*zip(*other, strict=True), "D", color=PUBLISHED, markerfacecolor="white", label="published")
    shown = [*(bar.measured for bar in bars), *(value for value, _ in [*points, *other])]
    for bar in bars:
        axes.text(
            1.02,
            at[id(bar)],
            f"{bar.measured:.2f}",
            transform=axes.get_yaxis_transform(),
            va="center",
            fontsize=7,
        )
    axes.set_yticks(places, [bar.label for bar in bars])
    axes.tick_params(axis="y", length=0)
    for place, line in enumerate(lines):
        if not isinstance(line, Bar):
            axes.text(
                0.006,
                place,
                line,
                transform=axes.get_yaxis_transform(),
                va="center",
                fontweight="bold",
                fontsize=7,
                bbox={"facecolor": "white", "edgecolor": "none", "pad": 1.0},
            )
    axes.set_ylim(len(lines) - 0.4, -0.6)
    # A gain, which a few tables have as well, may be negative.
    axes.set_xlim(min(0.0, np.floor(min(shown) / 10) * 10), min(100.0, np.ceil(max(shown) / 10 + 0.01) * 10))
    axes.set_xlabel("accuracy in percent, mean over places")
    axes.xaxis.grid(True)
    figure.suptitle(title, wrap=True)
    if points or other:
        figure.legend(*axes.get_legend_handles_labels(), loc="outside lower right", ncols=2)
    return figure


def _lines(bars: list[Bar]) -> list[Bar | str]:
    """Bars from top to bottom, with the names of their sections."""
    lines: list[Bar | str] = []
    section = ""
    for bar in bars:
        if bar.section != section:
            section = bar.section
            lines.append(section)
        lines.append(bar)
    return lines
