"""Stage `splits`: train and test cues, integrations and smoothing on fixed splits (thesis 4.9 and 4.10)."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from placecat import paths, settings
from placecat.compute import parallel
from placecat.runs import items
from placecat.stages import run
from placecat.training import fold_file, store
from placecat.training import plan as plans
from placecat.training.cue import Cue, train
from placecat.training.integration import apply_smoothing, fit_smoothing, fuse, smoothing_settings

Probabilities = dict[str, NDArray[np.float64]]


def main() -> None:
    """Train and test on every split."""
    params = settings.load()
    wanted = {}
    for split, own in settings.get(params, "splits").items():
        used = {name: Cue.of(params, name) for name in _cues(own)}
        content = {name: [cue.descriptor, cue.classifier, cue.codebook] for name, cue in used.items()}
        others = [settings.get(params, name) for name in ("protocol.seeds", "protocol.cue_frames")]
        others += [settings.get(params, "protocol.integration_frames"), smoothing_settings(params)]
        names = [f"{split}/{sequence}" for sequence in own["dataset"]["homes"]]
        described = [
            path for home in names for cue in used.values() for path in store.files_of(home, cue.descriptor)
        ]
        inputs = (*map(paths.sequences, names), *described)
        wanted[split] = items.Inputs([own, content, *others], inputs)
    items.refresh("splits", paths.SPLITS, wanted, lambda split, folder: make(split, folder, params))


def _cues(split: Mapping[str, Any]) -> list[str]:
    """Return the names of all cues in the systems of a split."""
    return list(dict.fromkeys(cue for system in split["systems"].values() for cue in system))


def make(split: str, folder: Path, params: Mapping[str, Any]) -> None:
    """Train on the training sequences of a split and test on its test sequences, for every seed."""
    own, plan = settings.get(params, f"splits.{split}"), plans.of_split(params, split)
    used = {name: Cue.of(params, name) for name in _cues(own)}
    seeds = list(settings.get(params, "protocol.seeds"))
    keys: list[tuple[str, int | None]] = [
        (name, seed) for name, cue in used.items() for seed in (seeds if cue.codebook is not None else [None])
    ]
    cue_tasks = [(plan, used[name], seed) for name, seed in keys]
    outputs = dict(zip(keys, parallel.in_parallel(apply_cue, cue_tasks, f"cues of {split}"), strict=True))
    options = smoothing_settings(params)
    system_keys = [(system, seed) for system in own["systems"] for seed in seeds]
    system_tasks = [
        (
            plan,
            [outputs.get((cue, seed), outputs.get((cue, None))) for cue in own["systems"][system]],
            own["integrator"],
            options,
        )
        for system, seed in system_keys
    ]
    fused = parallel.in_parallel(apply_system, system_tasks, f"integration of {split}")
    for (name, seed), (_, tested) in outputs.items():
        for part in plan.tested:
            place = fold_file.path_of(folder / "cues" / name, part.sequence, paths.seed_name(seed))
            fold_file.write(place, {"test": tested[part.home]})
    for (system, seed), by_home in zip(system_keys, fused, strict=True):
        for part in plan.tested:
            place = fold_file.path_of(folder / "systems" / system, part.sequence, paths.seed_name(seed))
            fold_file.write(place, by_home[part.home])


def apply_cue(plan: plans.Plan, cue: Cue, seed: int | None) -> tuple[Probabilities, Probabilities]:
    """Train one cue; return its distributions for training the integration and for all test frames."""
    numbers = [cue.classifier["clusters"]] if cue.codebook is not None else None
    trained = train(plan, cue, seed, numbers=numbers)
    return trained.predict_chosen(plan.integration), {
        part.home: trained.predict(part.home) for part in plan.tested
    }


def apply_system(
    plan: plans.Plan,
    outputs: Sequence[tuple[Probabilities, Probabilities]],
    integrator: Mapping[str, Any],
    smoothing: Mapping[str, Any],
) -> dict[str, Probabilities]:
    """Integrate the outputs of all cues and smooth the decisions for every test sequence."""
    fused = fuse(plan.integration, [train for train, _ in outputs], plan.classes, integrator)
    assert fused.cross_validated is not None
    model = fit_smoothing(plan.integration, fused.cross_validated, fused.truth, smoothing)
    result = {}
    for part in plan.tested:
        stacked = np.stack([tested[part.home] for _, tested in outputs], axis=1)
        proba = fused.integrator.predict_proba(stacked)
        result[part.home] = {"test": proba} | apply_smoothing(model, part.home, proba)
    return result


if __name__ == "__main__":
    run(main)
