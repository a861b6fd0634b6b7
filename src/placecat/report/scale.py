"""The report's measurements at the scale of the real home database, as text and as a chart."""

from collections.abc import Mapping
from typing import Any

import pandas as pd
from matplotlib.figure import Figure
from matplotlib.ticker import NullLocator

# Text columns in reports/scale.csv and scale_growth.csv.
TEXT = ("stage", "item")
ALL = "all"
# Stages that take fewer CPU seconds are left out, because they spend most of that time on imports.
_LEAST = 10.0


def seconds_by_size(measured: pd.DataFrame) -> pd.DataFrame:
    """Sum the CPU seconds in reports/scale.csv over each stage's items.

    The index lists the stages in the order in which they ran, followed by ``all``. There is one column for
    each number of frames.
    """
    table = measured.pivot_table("cpu_seconds", "stage", "frames", aggfunc="sum", sort=False)
    table = table.reindex(columns=sorted(table.columns))
    table.loc[ALL] = table.sum()
    return table


def shown_scale(measured: pd.DataFrame, growth: pd.DataFrame, facts: Mapping[str, Any]) -> dict[str, Any]:
    """Format reports/scale.csv, scale_growth.csv and scale.json for a page.

    ``sizes`` lists the numbers of frames. Each entry of ``rows`` contains a stage, its CPU seconds at each
    size, its elapsed seconds and peak memory at the largest size, and its growth exponents. The other entries
    describe the machine, the largest size and a full run.
    """
    by_size = seconds_by_size(measured)
    of_stage = growth[growth["item"] == ""].set_index("stage")
    rows = [
        {
            "stage": stage,
            "cpu": [f"{value:.1f}" for value in by_size.loc[stage]],
            "seconds": f"{of_stage.loc[stage, 'seconds']:.1f}",
            "peak": f"{of_stage.loc[stage, 'peak_gib']:.2f}",
            "exponent": f"{of_stage.loc[stage, 'exponent']:.2f}",
            "last": f"{of_stage.loc[stage, 'last_exponent']:.2f}",
        }
        for stage in by_size.index
    ]
    return {
        "sizes": [f"{frames:,}" for frames in by_size.columns],
        "rows": rows,
        "machine": facts["machine"],
        "largest": facts["largest"],
        "test_homes": ", ".join(facts["test_homes"]),
        "hours": facts["full_run"]["hours"],
    }


def growth_chart(measured: pd.DataFrame) -> Figure | None:
    """Plot each stage's CPU seconds against the number of frames, on logarithmic axes.

    Returns None if there are fewer than two sizes. For `measured`, see :func:`seconds_by_size`.
    """
    by_size = seconds_by_size(measured)
    if by_size.shape[1] < 2:
        return None
    largest = by_size.iloc[:, -1]
    shown = largest[(largest >= _LEAST) & (largest.index != ALL)].sort_values(ascending=False).index
    figure = Figure(figsize=(6.5, 3.2))
    axes = figure.subplots()
    frames = list(by_size.columns)
    axes.plot(frames, by_size.loc[ALL], "o-", color="#222222", label="all stages")
    for stage in shown:
        axes.plot(frames, by_size.loc[stage], "o-", label=stage)
    # A reference line that shows growth in proportion to the number of frames.
    start = by_size.loc[ALL].to_numpy(float)[0]
    line = [start * size / frames[0] for size in frames]
    axes.plot(frames, line, "--", color="#8a8a8a", linewidth=0.8, label="linear growth")
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_xticks(frames, [f"{size:,}" for size in frames])
    axes.xaxis.set_minor_locator(NullLocator())
    axes.yaxis.set_major_formatter(lambda value, _: f"{value:g}")
    axes.grid(axis="y")
    axes.set_xlabel("frames")
    axes.set_ylabel("CPU seconds")
    figure.legend(loc="outside right upper")
    return figure
