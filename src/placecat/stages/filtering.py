"""Stage `filtering`: apply the information filter to decisions (thesis 4.6)."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
from numpy.typing import NDArray

from placecat import files, paths, settings
from placecat.compute import parallel
from placecat.fusion.information_filter import dropped, hold, threshold_of
from placecat.results.measured import DROPPED_COLUMNS
from placecat.sequences import listing
from placecat.stages import run
from placecat.training import fold_file, protocol


def main() -> None:
    """Apply every filter to its cues and systems, for every test home and seed."""
    params = settings.load()
    filters = settings.get(params, "filters")
    names = list(settings.get(params, "dataset.homes"))
    homes = protocol.tested_homes(names, settings.get(params, "protocol.test_homes"))
    thresholds = {
        (name, home): _threshold(options, [other for other in names if other != home])
        for name, options in filters.items()
        for home in homes
    }
    tasks: dict[Path, tuple[Path, str, float]] = {}
    with files.replacing(paths.FILTERED) as folder:
        for name, options in filters.items():
            for result, source in _sources(params, options).items():
                for home in homes:
                    for seed in fold_file.seeds_in(source, home):
                        place = fold_file.path_of(source, home, seed)
                        tasks[Path(name, result, place.name)] = place, home, thresholds[name, home]
        results = parallel.in_parallel(filter_home, list(tasks.values()), "information filter")
        for place, result in zip(tasks, results, strict=True):
            fold_file.write(folder / place, result)
        rows = [
            {"filter": name, "home": home}
            | dropped(_information(home), listing.read_labels(home), thresholds[name, home])
            for name, home in thresholds
        ]
        folder.mkdir(parents=True, exist_ok=True)
        files.write_csv(folder / "dropped.csv", pd.DataFrame(rows, columns=DROPPED_COLUMNS))


def _threshold(options: Mapping[str, Any], training: Sequence[str]) -> float:
    """Return the threshold of a filter, or compute it from its share and the labelled training frames."""
    if options.get("threshold") is not None:
        return float(options["threshold"])
    seen = [_information(home)[listing.read_labels(home) >= 0] for home in training]
    return threshold_of(options["share"], np.concatenate(seen))


def _information(home: str) -> NDArray[np.float32]:
    return files.read_array(paths.features(home) / "information.npy", memory_map=False)


def _sources(params: Mapping[str, Any], options: Mapping[str, Any]) -> dict[str, Path]:
    """Return the folders of the cues and systems that a filter is applied to."""
    cues = {cue: paths.CUES / cue / settings.get(params, f"cues.{cue}.schemes")[0] for cue in options["cues"]}
    return cues | {system: paths.INTEGRATION / system for system in options["systems"]}


def filter_home(source: Path, home: str, threshold: float) -> dict[str, np.ndarray]:
    """Return the filtered distributions of one home, and the unfiltered arrays that smoothing needs."""
    found = files.read_arrays(source)
    sequences = listing.sequence_slices(home)
    held = hold(found["test"], _information(home), threshold=threshold, sequences=sequences)
    needed = ("cross_validated", "cross_validated_truth")
    return {"test": held, **{name: found[name] for name in needed if name in found}}


if __name__ == "__main__":
    run(main)
