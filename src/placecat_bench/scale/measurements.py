"""Running the stages in a folder, one after the other, with what each took."""

from collections.abc import Iterable
from pathlib import Path

import pandas as pd

from placecat_bench.scale import growth
from placecat_bench.scale.pipeline import Step
from placecat_bench.scale.watching import Watched, watch

COLUMNS = ["size", "frames", "stage", "item", "seconds", "cpu_seconds", "peak_gib"]
GROWTH_COLUMNS = ["stage", "item", "exponent", "r2", "last_exponent", "seconds", "peak_gib"]


def measure(folder: Path, steps: Iterable[Step], size: float, frames: int) -> pd.DataFrame:
    """Run stages in a folder and watch them; columns `COLUMNS`, a row a step.

    Raises
    ------
    PlacecatError
        If a stage fails.
    """
    rows = []
    for step in steps:
        watched = watch(step.command, folder, folder / "logs" / f"{step.name}.log")
        print(f"{frames} frames, {step.name}: {_text(watched)}", flush=True)
        numbers = (round(watched.seconds, 2), round(watched.cpu_seconds, 2), round(watched.peak_gib, 3))
        rows.append((size, frames, step.stage, step.item, *numbers))
    return pd.DataFrame(rows, columns=COLUMNS)


def _text(watched: Watched) -> str:
    return f"{watched.seconds:.1f} s, {watched.cpu_seconds:.1f} CPU s, {watched.peak_gib:.2f} GiB"


def growths(measured: pd.DataFrame) -> pd.DataFrame:
    """Fit how the time of every stage, and of each of its items, grows with the frames.

    Parameters
    ----------
    measured
        Columns `COLUMNS`, at least two numbers of frames.

    Returns
    -------
    DataFrame
        Columns `GROWTH_COLUMNS`. A stage's own row, with item "", has the sum over its items. The exponents
        are those of the CPU seconds; ``seconds`` (wall time) and ``peak_gib`` are those of the most frames.
    """
    rows = []
    for stage, of_stage in measured.groupby("stage", sort=False):
        items = list(dict.fromkeys(of_stage["item"]))
        rows.append((stage, "", *_growth(of_stage)))
        if items != [""]:
            rows += [(stage, item, *_growth(of_stage[of_stage["item"] == item])) for item in items]
    rows.append(("all", "", *_growth(measured)))
    return pd.DataFrame(rows, columns=GROWTH_COLUMNS)


def _growth(rows: pd.DataFrame) -> tuple[float, float, float, float, float]:
    by_size = rows.groupby("frames").agg(
        cpu=("cpu_seconds", "sum"), seconds=("seconds", "sum"), peak=("peak_gib", "max")
    )
    found = growth.fit(by_size.index.to_list(), by_size["cpu"].clip(lower=0.01).to_list())
    return (
        round(found.exponent, 2),
        round(found.r2, 3),
        round(found.last, 2),
        round(float(by_size["seconds"].iloc[-1]), 1),
        round(float(by_size["peak"].iloc[-1]), 2),
    )
