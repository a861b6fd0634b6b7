"""Runs at the scale of the real home database, in the report."""

from collections.abc import Mapping
from typing import Any

import pandas as pd

# Text columns in reports/scale.csv and scale_growth.csv.
TEXT = ("stage", "item")
ALL = "all"


def seconds_by_size(measured: pd.DataFrame) -> pd.DataFrame:
    """Sum the items of each stage of reports/scale.csv.

    The index is the stage, in order of time, and ``all``; each column has the CPU seconds for a number of
    frames.
    """
    table = measured.pivot_table("cpu_seconds", "stage", "frames", aggfunc="sum", sort=False)
    table = table.reindex(columns=sorted(table.columns))
    table.loc[ALL] = table.sum()
    return table


def shown_scale(measured: pd.DataFrame, growth: pd.DataFrame, facts: Mapping[str, Any]) -> dict[str, Any]:
    """reports/scale.csv, scale_growth.csv and scale.json as text for a page.

    ``sizes`` are numbers of frames; ``rows`` have the stage, CPU seconds by size, and wall seconds, peak and
    exponent of the largest size; further facts describe the machine, the largest size and a full run.
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
