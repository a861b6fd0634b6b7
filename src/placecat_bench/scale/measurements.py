"""Measure the time and memory of stages, and fit power laws to how the time grows."""

from collections.abc import Mapping, Sequence
from pathlib import Path

import numpy as np
import pandas as pd

from placecat_bench.scale.watching import watch

# `item` is always "". Stages used to run per home or cue, and the files in git still have the column.
COLUMNS = ["size", "frames", "stage", "item", "seconds", "cpu_seconds", "peak_gib"]
GROWTH_COLUMNS = ["stage", "item", "exponent", "r2", "last_exponent", "seconds", "peak_gib"]


def measure(folder: Path, steps: Mapping[str, Sequence[str]], size: float, frames: int) -> pd.DataFrame:
    """Run stages in a folder and return a row of `COLUMNS` for each. Raises PlacecatError if one fails."""
    rows = []
    for stage, command in steps.items():
        watched = watch(command, folder, folder / "logs" / f"{stage}.log")
        seconds, cpu_seconds, peak_gib = watched.seconds, watched.cpu_seconds, watched.peak_gib
        text = f"{seconds:.1f} s, {cpu_seconds:.1f} CPU s, {peak_gib:.2f} GiB"
        print(f"{frames} frames, {stage}: {text}", flush=True)
        rows.append((size, frames, stage, "", round(seconds, 2), round(cpu_seconds, 2), round(peak_gib, 3)))
    return pd.DataFrame(rows, columns=COLUMNS)


def growths(measured: pd.DataFrame) -> pd.DataFrame:
    """Estimate how the run time of each stage, and of all stages together, grows with the number of frames.

    `measured` has the columns `COLUMNS` and rows for at least two numbers of frames. Returns the columns
    `GROWTH_COLUMNS`. The exponents apply to CPU seconds; ``seconds`` (wall time) and ``peak_gib`` are for the
    largest number of frames.
    """
    parts = [*measured.groupby("stage", sort=False), ("all", measured)]
    return pd.DataFrame([(stage, "", *_growth(part)) for stage, part in parts], columns=GROWTH_COLUMNS)


def _growth(rows: pd.DataFrame) -> tuple[float, float, float, float, float]:
    by_size = rows.groupby("frames").agg(
        cpu=("cpu_seconds", "sum"), seconds=("seconds", "sum"), peak=("peak_gib", "max")
    )
    exponent, r2, last = fit(by_size.index.to_list(), by_size["cpu"].clip(lower=0.01).to_list())
    largest = by_size.iloc[-1]
    return (
        round(exponent, 2),
        round(r2, 3),
        round(last, 2),
        round(float(largest["seconds"]), 1),
        round(float(largest["peak"]), 2),
    )


def fit(frames: Sequence[float], values: Sequence[float]) -> tuple[float, float, float]:
    """Fit values = factor * frames ** exponent by least squares on the logarithms.

    `frames` and `values` are positive (n,) arrays with n >= 2 and at least two distinct numbers of frames.
    Returns three numbers. The first is the exponent, which is 1 if the values are proportional to the number
    of frames. The second, at most 1, is the share of the variance in the logarithms that the fit explains.
    The third is the exponent between the two largest sizes, where constant costs such as imports matter
    little.

    >>> fit([100, 200, 400], [3.0, 12.0, 48.0])[0]
    2.0
    """
    order = np.argsort(frames)
    x, y = np.log(np.asarray(frames, float)[order]), np.log(np.asarray(values, float)[order])
    if len(x) < 2 or x[0] == x[-1]:
        raise ValueError("an exponent needs at least two different numbers of frames")
    exponent, constant = np.polyfit(x, y, 1)
    rest = y - (exponent * x + constant)
    total = float(((y - y.mean()) ** 2).sum())
    r2 = 1.0 if total == 0.0 else 1.0 - float((rest**2).sum()) / total
    last = (y[-1] - y[-2]) / (x[-1] - x[-2]) if x[-1] > x[-2] else exponent
    return round(float(exponent), 6), r2, round(float(last), 6)
