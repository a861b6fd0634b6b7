"""Stage `filtering`: what the information filter makes of decisions (thesis 4.6)."""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from placecat import files, listing, parallel, paths, settings
from placecat.evaluation import protocol
from placecat.fusion.information_filter import hold
from placecat.stages import run

# What smoothing needs of a filtered result besides the frames of the test home: it is not filtered.
STATISTICS = ("cross_validated", "cross_validated_truth")


def main() -> None:
    """Filter every cue and system that a filter names, in every test home, once for each seed."""
    params = settings.load()
    homes = protocol.tested_homes(
        settings.get(params, "dataset.homes"), settings.get(params, "protocol.test_homes")
    )
    tasks: dict[Path, tuple[Path, str, float]] = {}
    with files.replacing(paths.FILTERED) as folder:
        for name, options in settings.get(params, "filters").items():
            for result, source in _sources(params, options).items():
                for home in homes:
                    for seed in listing.seeds_in(source / home):
                        task = source / home / seed, home, float(options["threshold"])
                        tasks[Path(name, result, home, seed)] = task
        results = parallel.in_parallel(filter_home, list(tasks.values()), "information filter")
        for place, result in zip(tasks, results, strict=True):
            for array_name, array in result.items():
                files.write_array(folder / place / f"{array_name}.npy", array)


def _sources(params: Mapping[str, Any], options: Mapping[str, Any]) -> dict[str, Path]:
    """Folders of the results that one filter names."""
    found = {}
    for cue in options["cues"]:
        scheme = settings.get(params, f"cues.{cue}.schemes")[0]
        found[cue] = paths.CUES / cue / scheme
    for system in options["systems"]:
        settings.get(params, f"systems.{system}")
        found[system] = paths.INTEGRATION / system
    return found


def filter_home(source: Path, home: str, threshold: float) -> dict[str, np.ndarray]:
    """Give the filtered distributions of one home, and the statistics that smoothing needs."""
    information = files.read_array(paths.features(home) / "information.npy", memory_map=False)
    proba = files.read_array(source / "test.npy", memory_map=False)
    held = hold(proba, information, threshold=threshold, sequences=listing.sequence_slices(home))
    found = {"test": held}
    for name in STATISTICS:
        if (source / f"{name}.npy").exists():
            found[name] = files.read_array(source / f"{name}.npy", memory_map=False)
    return found


if __name__ == "__main__":
    run(main)
