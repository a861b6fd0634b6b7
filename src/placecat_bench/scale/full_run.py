"""Estimate of the time of a complete run on so many frames, with every home tested."""

from collections.abc import Mapping
from typing import Any

import pandas as pd

from placecat import files, listing, paths, settings
from placecat.errors import PlacecatError
from placecat.evaluation.trials import expand
from placecat.thesis import definitions
from placecat.training import protocol

# Their work is the same for every home that is tested on.
PER_TEST_HOME = ("codebooks", "cues", "integration", "filtering", "smoothing")
# Their work is the same for every frame.
PER_FRAME = ("sequences", "features", "tracks")


def estimate(measured: pd.DataFrame, params: Mapping[str, Any]) -> dict[str, Any]:
    """Add up the times of the largest size, as often as a full run has them, and of the stages not measured.

    Stages that work on frames (features, tracks) take as long a frame as in the kept run of the project
    (reports/times.csv) on its own frames. Stages that do not depend on the homes' size (further data sets,
    toy problem, figures, page) take as long as there. `measured` has columns
    `placecat_bench.scale.measurements.COLUMNS`, `params` its settings. Returns ``hours``, and ``seconds`` by
    stage.
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
    """How many times the measured work of a stage, e.g. ``trials``, a run has that tests on every home."""
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
