"""Estimate the time of a complete run on many frames that tests every home."""

from collections.abc import Mapping
from typing import Any

import pandas as pd

from placecat import files, listing, paths, settings
from placecat.errors import PlacecatError
from placecat.evaluation.trials import expand
from placecat.thesis import definitions
from placecat.training import protocol

# Stages with the same work for every tested home.
PER_TEST_HOME = ("codebooks", "cues", "integration", "filtering", "smoothing")
# Stages with the same work for every frame.
PER_FRAME = ("sequences", "features", "tracks")


def estimate(measured: pd.DataFrame, params: Mapping[str, Any]) -> dict[str, Any]:
    """Add up the times of the largest size, as often as in a full run, and of the stages not measured.

    Stages that work on frames (features, tracks) are assumed to take as long per frame as in the project's
    last full run (reports/times.csv). Stages that do not depend on the homes' size (further data sets, toy
    problem, figures, page) are assumed to take as long as there. `measured` has the columns
    `placecat_bench.scale.measurements.COLUMNS`; `params` are its settings. Returns ``hours``, and ``seconds``
    by stage.
    """
    frames = int(measured["frames"].max())
    most = measured[measured["frames"] == frames]
    seconds: dict[str, float] = {}
    for stage, took in zip(most["stage"], most["seconds"], strict=True):
        seconds[stage] = seconds.get(stage, 0.0) + took * times_as_often(stage, params)
    kept = files.read_csv(paths.KEPT_TIMES)
    here = sum(len(listing.read_labels(home)) for home in settings.get(settings.load(), "dataset.homes"))
    for stage, took in zip(kept["stage"], kept["seconds"], strict=True):
        if stage not in seconds:
            seconds[stage] = float(took) * (frames / here if stage in PER_FRAME else 1.0)
    rounded = {stage: round(took, 1) for stage, took in seconds.items()}
    return {"hours": round(sum(seconds.values()) / 3600, 2), "seconds": rounded}


def times_as_often(stage: str, params: Mapping[str, Any]) -> float:
    """How many times a run that tests every home does the measured work of a stage, e.g. ``trials``."""
    homes = list(settings.get(params, "dataset.homes"))
    tested = protocol.tested_homes(homes, settings.get(params, "protocol.test_homes"))
    if stage in PER_TEST_HOME:
        return len(homes) / len(tested)
    if stage != "trials":
        return 1.0
    of_trials = [
        trial.homes
        for tables in definitions.studies(params).values()
        for name, table in tables.items()
        for trial in expand(name, table, homes)
    ]
    now = sum(home in tested for own in of_trials for home in own)
    if not now:
        raise PlacecatError(f"no study tests on any of {', '.join(tested)}: choose other test_homes")
    return sum(map(len, of_trials)) / now
