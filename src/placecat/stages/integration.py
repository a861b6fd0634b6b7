"""Stage `integration`: fuse the distributions of several cues into one."""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from placecat import paths, settings
from placecat.compute import parallel
from placecat.runs import items
from placecat.stages import run
from placecat.training import fold_file
from placecat.training import plan as plans
from placecat.training.integration import fuse, fused_parts
from placecat.training.saved import CueResults


def main() -> None:
    """Train and apply the integration of every system."""
    params = settings.load()
    homes = list(settings.get(params, "dataset.homes"))
    shared = [homes, settings.get(params, "dataset.classes"), settings.get(params, "protocol")]
    listed = [paths.sequences(home) / "labels.csv" for home in homes]
    wanted = {}
    for name, system in settings.get(params, "systems").items():
        read = [*listed, *(paths.CUES / cue / system["scheme"] for cue in system["cues"])]
        own = [system, *shared, [settings.get(params, f"cues.{cue}.codebook") for cue in system["cues"]]]
        if system["extra"]:
            split = settings.get(params, "protocol.extra.split")
            own.append(settings.get(params, f"splits.{split}.dataset.classes"))
            read.append(paths.SITE_SEQUENCES / split)
        wanted[name] = items.Inputs(own, tuple(read))
    items.refresh("integration", paths.INTEGRATION, wanted, lambda name, folder: make(name, folder, params))


def make(name: str, folder: Path, params: Mapping[str, Any]) -> None:
    """Train and apply the integration of one system in every fold of its scheme, for every seed."""
    system = settings.get(params, f"systems.{name}")
    tested = settings.get(params, "protocol.test_homes")
    random = [cue for cue in system["cues"] if settings.get(params, f"cues.{cue}.codebook") is not None]
    seeds = settings.get(params, "protocol.seeds") if random else [None]
    planned = plans.of_homes(params, system["scheme"], tested, extra=system["extra"])
    tasks = [(system, plan, seed) for plan in planned for seed in seeds]
    results = parallel.in_parallel(apply, tasks, f"integration {name}")
    for (_, plan, seed), result in zip(tasks, results, strict=True):
        facts = result.pop("facts")
        fold_file.write(fold_file.path_of(folder, plan.test, paths.seed_name(seed)), result, facts)


def apply(system: Mapping[str, Any], plan: plans.Plan, seed: int | None) -> dict[str, Any]:
    """Integrate one fold; return the test and the cross-validated training distributions."""
    read = CueResults(system, plan.test, seed)
    method = system["integrator"]["method"]
    parts = fused_parts(plan, method=method, extra=system["extra"])
    temperatures = read.temperatures() if system["temperature"] else None
    given = parts, read.training(plan, parts, method), plan.classes, system["integrator"]
    trained = fuse(*given, temperatures=temperatures)
    return {
        "facts": trained.facts,
        "test": trained.integrator.predict_proba(np.stack(read.arrays("test"), axis=1)),
        "cross_validated": trained.cross_validated,
        "cross_validated_truth": trained.truth,
    }


if __name__ == "__main__":
    run(main)
