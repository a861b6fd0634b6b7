"""Stage `smoothing`: the delayed hidden Markov model over the integrated decisions and over single cues."""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from placecat import files, listing, parallel, paths, settings
from placecat.errors import PlacecatError
from placecat.stages import run
from placecat.training import plan as plans
from placecat.training.system import smooth, smoothing_settings


def main() -> None:
    """Smooth every system, and every cue and filtered result that is wanted smoothed."""
    params = settings.load()
    smoothing = settings.get(params, "smoothing")
    tested = settings.get(params, "protocol.test_homes")
    systems = settings.get(params, "systems")
    sources = {name: (paths.INTEGRATION / name, system["scheme"]) for name, system in systems.items()}
    for cue in smoothing["cues"]:
        scheme = settings.get(params, f"cues.{cue}.schemes")[0]
        sources[cue] = (paths.CUES / cue / scheme, scheme)
    for name in smoothing["filtered"]:
        result = name.rpartition("/")[2]
        scheme = systems[result]["scheme"] if result in systems else params["cues"][result]["schemes"][0]
        sources[name] = (paths.FILTERED / name, scheme)
    model = smoothing_settings(params)
    tasks = [
        (source / plan.test / seed, plan, model, Path(name) / plan.test / seed)
        for name, (source, scheme) in sources.items()
        for plan in plans.of_homes(params, scheme, tested)
        for seed in listing.seeds_in(source / plan.test)
    ]
    with files.replacing(paths.SMOOTHING) as folder:
        results = parallel.in_parallel(smooth_home, [task[:-1] for task in tasks], "smoothing")
        for (*_, place), result in zip(tasks, results, strict=True):
            for array_name, array in result.items():
                files.write_array(folder / place / f"{array_name}.npy", array)


def smooth_home(source: Path, plan: plans.Plan, model: Mapping[str, Any]) -> dict[str, np.ndarray]:
    """Smooth the test home of one fold with statistics of its training homes."""
    if not (source / "cross_validated.npy").exists():
        raise PlacecatError(
            f"{source / 'cross_validated.npy'} is missing: a cue in smoothing.cues must have a classifier "
            "that is cross-validated, such as nu_svm; take it out of the list, or run `dvc repro`"
        )
    proba, held_out, truth = (
        files.read_array(source / f"{name}.npy", memory_map=False)
        for name in ("test", "cross_validated", "cross_validated_truth")
    )
    return smooth(plan.test, proba, plan.integration, held_out, truth, model)


if __name__ == "__main__":
    run(main)
