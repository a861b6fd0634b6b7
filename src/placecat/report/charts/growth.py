"""Chart how the stages' times grow with the number of frames."""

import pandas as pd
from matplotlib.figure import Figure
from matplotlib.ticker import NullLocator

from placecat.report.scale import ALL, seconds_by_size

# Stages with fewer CPU seconds are left out, since imports take most of their time.
_LEAST = 10.0


def growth_chart(measured: pd.DataFrame) -> Figure | None:
    """Plot each stage's CPU seconds against the frames on log axes; return None for fewer than two sizes.

    `measured` is as for :func:`placecat.report.scale.seconds_by_size`.
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
    # A guide for the eye: growth proportional to the frames.
    start = by_size.loc[ALL].to_numpy(float)[0]
    line = [start * size / frames[0] for size in frames]
    axes.plot(frames, line, "--", color="#8a8a8a", linewidth=0.8, label="in proportion to the frames")
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
