"""Estimate how long a complete run on many frames takes if every home is tested."""

from collections.abc import Mapping
from typing import Any

import pandas as pd

from placecat import files, paths, settings
from placecat.errors import PlacecatError
from placecat.sequences import listing
from placecat.thesis.records import trials_of
from placecat.training import protocol

# Stages whose work is proportional to the number of tested homes.
PER_TEST_HOME = ("codebooks", "cues", "integration", "filtering", "smoothing")
# Stages whose work is proportional to the number of frames.
PER_FRAME = ("sequences", "features", "tracks")


def estimate(measured: pd.DataFrame, params: Mapping[str, Any]) -> dict[str, Any]:
    """Estimate how long a full run takes by adding up the times of its stages.

    For measured stages, the times at the largest size are scaled to a run that tests every home. The times of
    the other stages come from the project's last full run (reports/times.csv). Stages that work on frames
    (sequences, features, tracks) are assumed to take the same time per frame. All others (further data sets,
    toy problem, figures, page) are assumed to take the same total time. `measured` has the columns
    `placecat_bench.scale.measurements.COLUMNS`; `params` are the settings of that measurement. Returns
    ``hours``, and ``seconds`` for each stage.
    """
    frames = int(measured["frames"].max())
    most = measured[measured["frames"] == frames]
    seconds: dict[str, float] = {}
    for stage, took in zip(most["stage"], most["seconds"], strict=True):
        seconds[stage] = seconds.get(stage, 0.0) + took * times_as_often(stage, params)
    kept = files.read_table(paths.KEPT_TIMES, ["stage"])
    here = sum(len(listing.read_labels(home)) for home in settings.get(settings.load(), "dataset.homes"))
    for stage, took in zip(kept["stage"], kept["seconds"], strict=True):
        if stage not in seconds:
            seconds[stage] = float(took) * (frames / here if stage in PER_FRAME else 1.0)
    rounded = {stage: round(took, 1) for stage, took in seconds.items()}
    return {"hours": round(sum(seconds.values()) / 3600, 2), "seconds": rounded}


def times_as_often(stage: str, params: Mapping[str, Any]) -> float:
    """Return how many times the measured work of a stage is repeated in a run that tests every home."""
    homes = list(settings.get(params, "dataset.homes"))
    tested = protocol.tested_homes(homes, settings.get(params, "protocol.test_homes"))
    if stage in PER_TEST_HOME:
        return len(homes) / len(tested)
    if stage != "trials":
        return 1.0
    of_trials = [trial.homes for trial in trials_of(params).values()]
    now = sum(home in tested for own in of_trials for home in own)
    if not now:
        raise PlacecatError(f"no study tests on any of {', '.join(tested)}: choose other test_homes")
    return sum(map(len, of_trials)) / now
