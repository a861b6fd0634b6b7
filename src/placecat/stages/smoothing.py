"""Stage `smoothing`: the delayed hidden Markov model over the integrated decisions and over single cues."""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from placecat import files, listing, parallel, paths, settings
from placecat.errors import PlacecatError
from placecat.evaluation import protocol
from placecat.fusion.smoothing import smooth
from placecat.stages import run


def main() -> None:
    """Smooth every system, and every cue and filtered result that is wanted smoothed."""
    params = settings.load()
    smoothing = settings.get(params, "smoothing")
    homes = list(settings.get(params, "dataset.homes"))
    tested = settings.get(params, "protocol.test_homes")
    n_classes = len(settings.get(params, "dataset.classes"))
    systems = settings.get(params, "systems")
    sources = {name: (paths.INTEGRATION / name, system["scheme"]) for name, system in systems.items()}
    for cue in smoothing["cues"]:
        scheme = settings.get(params, f"cues.{cue}.schemes")[0]
        sources[cue] = (paths.CUES / cue / scheme, scheme)
    for name in smoothing["filtered"]:
        result = name.rpartition("/")[2]
        scheme = systems[result]["scheme"] if result in systems else params["cues"][result]["schemes"][0]
        sources[name] = (paths.FILTERED / name, scheme)
    model = {name: value for name, value in smoothing.items() if name not in ("cues", "filtered")}
    tasks = [
        (source / fold.test / seed, fold, model, n_classes, Path(name) / fold.test / seed)
        for name, (source, scheme) in sources.items()
        for fold in protocol.folds(homes, scheme, tested)
        for seed in listing.seeds_in(source / fold.test)
    ]
    with files.replacing(paths.SMOOTHING) as folder:
        results = parallel.in_parallel(smooth_home, [task[:-1] for task in tasks], "smoothing")
        for (*_, place), result in zip(tasks, results, strict=True):
            for array_name, array in result.items():
                files.write_array(folder / place / f"{array_name}.npy", array)


def smooth_home(
    source: Path, fold: protocol.Fold, model: Mapping[str, Any], n_classes: int
) -> dict[str, np.ndarray]:
    """Smooth the test home of one fold with statistics of its training homes."""
    if not (source / "cross_validated.npy").exists():
        raise PlacecatError(
            f"{source / 'cross_validated.npy'} is missing: a cue in smoothing.cues must have a classifier "
            "that is cross-validated, such as nu_svm; take it out of the list, or run `dvc repro`"
        )
    walks, frame_rates = listing.walks(fold.integration_homes)
    return smooth(
        files.read_array(source / "test.npy", memory_map=False),
        listing.sequence_slices(fold.test),
        frame_rate=listing.frame_rate(fold.test),
        training_sequences=walks,
        training_frame_rates=frame_rates,
        training_proba=files.read_array(source / "cross_validated.npy", memory_map=False),
        training_truth=files.read_array(source / "cross_validated_truth.npy", memory_map=False),
        n_classes=n_classes,
        **model,
    )


if __name__ == "__main__":
    run(main)
