"""The report's benchmarks, as text and as a chart of the ratios with their targets."""

from collections.abc import Mapping
from typing import Any

import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.figure import Figure

# Text columns of the benchmarks.
TEXT = ("module", "piece", "input", "quantity", "peer", "peer_version", "target", "met", "spent")
_SECONDS = "seconds"
_NUMBER = r"(\d+(?:\.\d+)?(?:e[+-]?\d+)?)"

MET, MISSED, TARGET = "#0072b2", "#d55e00", "#222222"
# Width, line height, and total space above and below a panel's lines, in inches.
_WIDTH, _LINE, _ROUND = 6.5, 0.24, 0.55
_BOUND = 1.25


def ratios_of(benchmarks: pd.DataFrame) -> pd.DataFrame:
    """From the table that :func:`placecat_bench.run.run` returns, select the benchmarks that have a ratio.

    ``met`` becomes a bool and ``target`` a number. Missing numbers become NaN. The new column ``is_faster``
    is True if the target is a minimum speed-up, and False if it is a maximum multiple of the peer's time.
    """
    rows = benchmarks[benchmarks["ratio"].notna()]
    return rows.assign(
        target=rows["target"].str.extract(_NUMBER, expand=False).astype(float),
        is_faster=rows["target"].str.contains("faster"),
        met=rows["met"] == "yes",
    )


def shown_speed(benchmarks: pd.DataFrame, facts: Mapping[str, str]) -> dict[str, Any]:
    """Format the benchmarks from :func:`placecat_bench.run.run` for a page.

    Empty text cells in `benchmarks` must be "". Returns a dict: ``facts`` contains ``processor``, ``python``
    and ``packages``, and ``rows`` is a list of dicts with the keys piece, input, ours, peer, theirs, ratio,
    target, met and spent. If a row measures something other than seconds, its ``piece`` also names that
    quantity.
    """
    return {"facts": facts, "rows": [_shown_row(row) for row in benchmarks.to_dict("records")]}


def _shown_row(row: Mapping[Any, Any]) -> dict[str, Any]:
    return {
        "piece": row["piece"] if row["quantity"] == _SECONDS else f"{row['piece']}: {row['quantity']}",
        "input": row["input"],
        "ours": _amount(row["ours"], row["quantity"]),
        "peer": " ".join(filter(None, (row["peer"], row["peer_version"]))),
        "theirs": _amount(row["theirs"], row["quantity"]),
        "ratio": ""
        if pd.isna(row["ratio"])
        else f"{times(row['ratio'])} ({times(row['low'])} to {times(row['high'])})",
        "target": row["target"],
        "met": row["met"],
        "spent": f"spent on: {row['spent']}" if row["met"] == "no" else row["spent"],
    }


def times(ratio: float) -> str:
    """Format a ratio to three significant digits, or as a whole number if it is at least 1000."""
    return f"{ratio:,.0f}" if ratio >= 1000 else f"{ratio:.3g}"


def _amount(value: float, quantity: str) -> str:
    """Format a number. Times are in seconds or, if shorter than a second, in milliseconds."""
    if pd.isna(value):
        return ""
    if quantity != _SECONDS:
        return f"{value:.3g}"
    return f"{value:.3g} s" if value >= 1 else f"{value * 1000:.3g} ms"


def speed_chart(benchmarks: pd.DataFrame) -> Figure | None:
    """For each comparison, draw the median ratio, the range over pairs, and the target.

    There are up to two panels: one for speed-ups (higher is better), and one for shares of the peer's time
    (lower is better). Returns None if there are no comparisons.
    """
    ratios = ratios_of(benchmarks)
    panels = [
        ("times faster than the alternative", ratios[ratios["is_faster"]]),
        ("time as a multiple of the alternative's time", ratios[~ratios["is_faster"]]),
    ]
    panels = [(label, rows) for label, rows in panels if len(rows)]
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


def _panel(axes: Axes, rows: pd.DataFrame) -> None:
    places, is_faster = range(len(rows)), bool(rows["is_faster"].iloc[0])
    ratio, low, high, target = (rows[name].to_numpy(float) for name in ("ratio", "low", "high", "target"))
    if is_faster:
        axes.set_xscale("log")
        axes.xaxis.set_major_formatter(lambda value, _: f"{value:g}")
    colors = np.where(rows["met"], MET, MISSED).tolist()
    axes.barh(places, ratio, height=0.66, color=colors, alpha=0.75)
    style: dict[str, Any] = {"fmt": "none", "ecolor": TARGET, "elinewidth": 0.8, "capsize": 2}
    axes.errorbar(ratio, places, xerr=[ratio - low, high - ratio], label="range over pairs", **style)
    axes.plot(target, places, "|", color=TARGET, markersize=12, mew=1.8, label="target")
    at = axes.get_yaxis_transform()
    for place, one in zip(places, ratio, strict=True):
        axes.text(1.01, place, f"{times(one)}x", transform=at, va="center", fontsize=7)
    names = zip(rows["piece"], rows["input"], strict=True)
    axes.set_yticks(places, [", ".join(filter(None, name)) for name in names])
    axes.tick_params(axis="y", length=0)
    axes.set_ylim(len(rows) - 0.4, -0.6)
    values = np.concatenate([low, high, target])
    axes.set_xlim(min(1.0, values.min() / _BOUND) if is_faster else 0.0, values.max() * _BOUND)
