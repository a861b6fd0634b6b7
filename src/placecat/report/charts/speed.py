"""Ratios of benchmarks beside their targets."""

import pandas as pd
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from placecat.report.benchmarks import Ratio, ratios_of, times

MET, MISSED, TARGET = "#0072b2", "#d55e00", "#222222"
# Inches: a line of the chart, and what stands above and below the lines of a panel.
_WIDTH, _LINE, _ROUND = 6.5, 0.24, 0.55
_BOUND = 1.25


def speed_chart(benchmarks: pd.DataFrame) -> Figure | None:
    """Draw the median ratio of each comparison, the range of its pairs and its target.

    Parameters
    ----------
    benchmarks
        As :func:`placecat_bench.run.run` writes it.

    Returns
    -------
    Figure or None
        None if nothing was compared. Two panels: how many times faster (more is better),
        and how many times the peer's time (less is better).
    """
    ratios = ratios_of(benchmarks)
    panels = [
        ("times faster than the alternative", [one for one in ratios if one.is_faster]),
        ("times the time of the alternative", [one for one in ratios if not one.is_faster]),
    ]
    panels = [(label, rows) for label, rows in panels if rows]
    if not panels:
        return None
    heights = [_ROUND + _LINE * len(rows) for _, rows in panels]
    figure = Figure(figsize=(_WIDTH, sum(heights) + 0.1))
    all_axes = figure.subplots(len(panels), squeeze=False, height_ratios=heights)[:, 0]
    for axes, (label, rows) in zip(all_axes, panels, strict=True):
        _panel(axes, rows)
        axes.set_xlabel(label)
    handles, labels = all_axes[0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside upper right", ncols=3)
    return figure


def _panel(axes: Axes, rows: list[Ratio]) -> None:
    places = range(len(rows))
    medians = [one.ratio for one in rows]
    colors = [MET if one.is_met else MISSED for one in rows]
    is_faster = rows[0].is_faster
    if is_faster:
        axes.set_xscale("log")
        axes.xaxis.set_major_formatter(lambda value, _: f"{value:g}")
    axes.barh(places, medians, height=0.66, color=colors, alpha=0.75)
    below = [one.ratio - one.low for one in rows]
    above = [one.high - one.ratio for one in rows]
    axes.errorbar(
        medians,
        places,
        xerr=[below, above],
        fmt="none",
        ecolor=TARGET,
        elinewidth=0.8,
        capsize=2,
        label="pairs",
    )
    axes.plot([one.target for one in rows], places, "|", color=TARGET, markersize=12, mew=1.8, label="target")
    for place, one in zip(places, rows, strict=True):
        axes.text(
            1.01, place, f"{times(one.ratio)}x", transform=axes.get_yaxis_transform(), va="center", fontsize=7
        )
    axes.set_yticks(places, [", ".join(filter(None, (one.piece, one.input))) for one in rows])
    axes.tick_params(axis="y", length=0)
    axes.set_ylim(len(rows) - 0.4, -0.6)
    values = [value for one in rows for value in (one.low, one.high, one.target)]
    axes.set_xlim(min(1.0, min(values) / _BOUND) if is_faster else 0.0, max(values) * _BOUND)
