"""Prepare measurements at the scale of the real home database for the report."""

from collections.abc import Mapping
from typing import Any

import pandas as pd

# Text columns in reports/scale.csv and scale_growth.csv.
TEXT = ("stage", "item")
ALL = "all"


def seconds_by_size(measured: pd.DataFrame) -> pd.DataFrame:
    """Sum the CPU seconds of each stage's items in reports/scale.csv.

    The index has the stages, in the order in which they ran, and ``all``; each column is a number of frames.
    """
    table = measured.pivot_table("cpu_seconds", "stage", "frames", aggfunc="sum", sort=False)
    table = table.reindex(columns=sorted(table.columns))
    table.loc[ALL] = table.sum()
    return table


def shown_scale(measured: pd.DataFrame, growth: pd.DataFrame, facts: Mapping[str, Any]) -> dict[str, Any]:
    """Format reports/scale.csv, scale_growth.csv and scale.json for a page.

    ``sizes`` are numbers of frames; ``rows`` have the stage, its CPU seconds by size, its wall seconds and
    peak memory at the largest size, and the exponents of its growth; the other entries describe the machine,
    the largest size and a full run.
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
