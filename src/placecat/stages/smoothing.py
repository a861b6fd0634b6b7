"""Stage `smoothing`: apply the delayed hidden Markov model to integrated decisions and to single cues."""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from placecat import files, paths, settings
from placecat.compute import parallel
from placecat.stages import run
from placecat.training import fold_file
from placecat.training import plan as plans
from placecat.training.integration import smoothing_settings
from placecat.training.saved import smooth_home


def main() -> None:
    """Smooth the results of all systems, and of the cues and filters listed in the settings."""
    params = settings.load()
    tested = settings.get(params, "protocol.test_homes")
    model = smoothing_settings(params)
    tasks = [
        (fold_file.path_of(source, plan.test, seed), plan, model, name)
        for name, (source, scheme) in sources(params).items()
        for plan in plans.of_homes(params, scheme, tested)
        for seed in fold_file.seeds_in(source, plan.test)
    ]
    with files.replacing(paths.SMOOTHING) as folder:
        results = parallel.in_parallel(smooth_home, [task[:-1] for task in tasks], "smoothing")
        for (source, *_, name), result in zip(tasks, results, strict=True):
            fold_file.write(folder / name / source.name, result)


def sources(params: Mapping[str, Any]) -> dict[str, tuple[Path, str]]:
    """Map the name of each smoothed result to its input folder and its protocol."""
    smoothing, systems = settings.get(params, "smoothing"), settings.get(params, "systems")
    found = {name: (paths.INTEGRATION / name, system["scheme"]) for name, system in systems.items()}
    for cue in smoothing["cues"]:
        scheme = settings.get(params, f"cues.{cue}.schemes")[0]
        found[cue] = (paths.CUES / cue / scheme, scheme)
    for name in smoothing["filtered"]:
        result = name.rpartition("/")[2]
        scheme = systems[result]["scheme"] if result in systems else params["cues"][result]["schemes"][0]
        found[name] = (paths.FILTERED / name, scheme)
    return found


if __name__ == "__main__":
    run(main)
