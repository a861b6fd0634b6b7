"""Summarise a scale run: the machine, total time and peak memory."""

from collections.abc import Mapping
from typing import Any

import pandas as pd
import psutil

from placecat.compute import parallel
from placecat_bench.scale.watching import GIB


def facts(measured: pd.DataFrame, own: Mapping[str, Any]) -> dict[str, Any]:
    """Summarise measurements with `measurements.COLUMNS`; `own` is the content of conf/scale.yaml."""
    most = measured[measured["frames"] == measured["frames"].max()]
    highest = most.loc[most["peak_gib"].idxmax()]
    peak = float(highest["peak_gib"])
    return {
        "machine": {
            "cores": psutil.cpu_count(),
            "memory_gib": round(psutil.virtual_memory().total / GIB, 1),
            "workers": parallel.workers(),
        },
        "test_homes": list(own["test_homes"]),
        "sizes": sorted(int(frames) for frames in measured["frames"].unique()),
        "largest": {
            "frames": int(most["frames"].iloc[0]),
            "seconds": round(float(most["seconds"].sum()), 1),
            "cpu_seconds": round(float(most["cpu_seconds"].sum()), 1),
            "peak_gib": round(peak, 2),
            "peak_stage": str(highest["stage"]),
            "most_gib": float(own["most_gib"]),
            "met": peak <= float(own["most_gib"]),
        },
    }


def text(found: Mapping[str, Any]) -> str:
    """Format the summary as text."""
    largest, full = found["largest"], found["full_run"]
    return (
        f"{largest['frames']} frames, tested on {', '.join(found['test_homes'])}: "
        f"{largest['seconds'] / 60:.1f} min; at most {largest['peak_gib']:.1f} GiB "
        f"({largest['peak_stage']}; {largest['most_gib']:g} GiB are asked for).\n"
        f"A run from nothing on so many frames, all homes tested, would take about {full['hours']:.1f} h."
    )
