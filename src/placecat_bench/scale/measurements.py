"""Run stages in a folder, one after another, and measure their time and memory."""

from collections.abc import Mapping, Sequence
from pathlib import Path

import pandas as pd

from placecat_bench.scale import growth
from placecat_bench.scale.watching import watch

# `item` is always ""; the column remains in the files in git from when stages ran per home or cue.
COLUMNS = ["size", "frames", "stage", "item", "seconds", "cpu_seconds", "peak_gib"]
GROWTH_COLUMNS = ["stage", "item", "exponent", "r2", "last_exponent", "seconds", "peak_gib"]


def measure(folder: Path, steps: Mapping[str, Sequence[str]], size: float, frames: int) -> pd.DataFrame:
    """Run stages in a folder; return a row of `COLUMNS` for each; raises PlacecatError if one fails."""
    rows = []
    for stage, command in steps.items():
        watched = watch(command, folder, folder / "logs" / f"{stage}.log")
        seconds, cpu_seconds, peak_gib = watched.seconds, watched.cpu_seconds, watched.peak_gib
        text = f"{seconds:.1f} s, {cpu_seconds:.1f} CPU s, {peak_gib:.2f} GiB"
        print(f"{frames} frames, {stage}: {text}", flush=True)
        rows.append((size, frames, stage, "", round(seconds, 2), round(cpu_seconds, 2), round(peak_gib, 3)))
    return pd.DataFrame(rows, columns=COLUMNS)


def growths(measured: pd.DataFrame) -> pd.DataFrame:
    """Fit how the time of each stage, and of all stages together, grows with the number of frames.

    `measured` has the columns `COLUMNS` and at least two numbers of frames. Returns `GROWTH_COLUMNS`: the
    exponents are for CPU seconds; ``seconds`` (wall time) and ``peak_gib`` are for the largest number of
    frames.
    """
    parts = [*measured.groupby("stage", sort=False), ("all", measured)]
    return pd.DataFrame([(stage, "", *_growth(part)) for stage, part in parts], columns=GROWTH_COLUMNS)


def _growth(rows: pd.DataFrame) -> tuple[float, float, float, float, float]:
    by_size = rows.groupby("frames").agg(
        cpu=("cpu_seconds", "sum"), seconds=("seconds", "sum"), peak=("peak_gib", "max")
    )
    fitted = growth.fit(by_size.index.to_list(), by_size["cpu"].clip(lower=0.01).to_list())
    return (
        round(fitted.exponent, 2),
        round(fitted.r2, 3),
        round(fitted.last, 2),
        round(float(by_size["seconds"].iloc[-1]), 1),
        round(float(by_size["peak"].iloc[-1]), 2),
    )
