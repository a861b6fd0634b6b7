"""The command `python -m placecat_bench.scale`."""

import shutil
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import pandas as pd
import psutil

from placecat import files, paths
from placecat.compute import parallel
from placecat.config import conf_file
from placecat.errors import PlacecatError
from placecat.report.scale import TEXT
from placecat.runs import linked_folder
from placecat_bench.scale import full_run, measurements, project
from placecat_bench.scale.database import read_homes
from placecat_bench.scale.watching import GIB

SETTINGS = paths.CONF / "scale.yaml"
_NAMES = ["sizes", "test_homes", "stages", "regions", "jitter", "most_gib", "homes"]


def read_settings(path: Path = SETTINGS) -> dict[str, Any]:
    """Read conf/scale.yaml. Raises the same errors as :func:`placecat.config.conf_file.read`."""
    return conf_file.read(path, _NAMES)


def run(
    *,
    sizes: Sequence[float] | None = None,
    stages: Sequence[str] | None = None,
    folder: Path = paths.SCALE,
    add: bool = False,
    keep: bool = False,
    output: Path = paths.REPORTS,
) -> None:
    """Measure one size at a time, and write scale.csv, scale_growth.csv and scale.json to `output`.

    The files are written after each size, so an interrupted run still leaves results. `sizes` and `stages`
    override conf/scale.yaml. Each size has its own folder in `folder`, which is removed afterwards unless
    `keep` is set. `add` keeps the rows of other sizes in `output`/scale.csv. Those rows should come from the
    same machine and code. Raises PlacecatError for invalid settings, missing features, or a stage that fails.
    """
    options = read_settings()
    homes = read_homes(options["homes"])
    wanted = [float(size) for size in (sizes or options["sizes"])]
    if not wanted or min(wanted) <= 0.0:
        raise PlacecatError(f"{SETTINGS}: sizes are {wanted}, but each must be greater than 0")
    parts: list[pd.DataFrame] = []
    if add:
        before = files.read_table(output / paths.SCALE_STAGES.name, TEXT)
        parts = [part for size, part in before.groupby("size") if size not in wanted]
    for size in wanted:
        scaled = [home.scaled(size) for home in homes]
        frames = sum(home.frames for home in scaled)
        place = folder / str(frames)
        drawn = {name: options[name] for name in ("test_homes", "regions", "jitter")}
        params = project.build(place, scaled, **drawn)
        steps = linked_folder.commands(stages or options["stages"])
        parts.append(measurements.measure(place, steps, size, frames))
        if not keep:
            shutil.rmtree(place)
        measured = pd.concat(parts).sort_values("frames", kind="stable", ignore_index=True)
        files.write_csv(output / paths.SCALE_STAGES.name, measured)
        facts = _facts(measured, options)
        if len(parts) > 1:
            files.write_csv(output / paths.SCALE_GROWTH.name, measurements.growths(measured))
        facts["full_run"] = full_run.estimate(measured, params)
        files.write_json(output / paths.SCALE_FACTS.name, facts)
    print(_text(facts))


def _facts(measured: pd.DataFrame, options: Mapping[str, Any]) -> dict[str, Any]:
    most = measured[measured["frames"] == measured["frames"].max()]
    highest = most.loc[most["peak_gib"].idxmax()]
    peak = float(highest["peak_gib"])
    return {
        "machine": {
            "cores": psutil.cpu_count(),
            "memory_gib": round(psutil.virtual_memory().total / GIB, 1),
            "workers": parallel.workers(),
        },
        "test_homes": list(options["test_homes"]),
        "sizes": sorted(int(frames) for frames in measured["frames"].unique()),
        "largest": {
            "frames": int(most["frames"].iloc[0]),
            "seconds": round(float(most["seconds"].sum()), 1),
            "cpu_seconds": round(float(most["cpu_seconds"].sum()), 1),
            "peak_gib": round(peak, 2),
            "peak_stage": str(highest["stage"]),
            "most_gib": float(options["most_gib"]),
            "met": peak <= float(options["most_gib"]),
        },
    }


def _text(facts: Mapping[str, Any]) -> str:
    largest, full = facts["largest"], facts["full_run"]
    return (
        f"{largest['frames']} frames, tested on {', '.join(facts['test_homes'])}: "
        f"{largest['seconds'] / 60:.1f} min; at most {largest['peak_gib']:.1f} GiB "
        f"({largest['peak_stage']}; the target is {largest['most_gib']:g} GiB).\n"
        f"A complete run on this many frames, with all homes tested, would take about {full['hours']:.1f} h."
    )
