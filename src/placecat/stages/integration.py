"""Stage `integration`: fuse the cues' distributions to one."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from placecat import files, items, listing, parallel, paths, settings
from placecat.errors import PlacecatError
from placecat.evaluation import protocol
from placecat.fusion.integrate import integrate
from placecat.stages import run


def main() -> None:
    """Train and apply every system's integration."""
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
    """Train and apply one system's integration in every fold of its scheme, once for each seed."""
    system = settings.get(params, f"systems.{name}")
    homes = list(settings.get(params, "dataset.homes"))
    tested = settings.get(params, "protocol.test_homes")
    folds = protocol.folds(homes, system["scheme"], tested)
    classes = settings.get(params, "dataset.classes")
    selection = settings.get(params, "protocol.integration_frames")
    random = [cue for cue in system["cues"] if settings.get(params, f"cues.{cue}.codebook") is not None]
    seeds = settings.get(params, "protocol.seeds") if random else [None]
    extra = _extra(params, selection, classes) if system["extra"] else {}
    tasks = [(system, fold, seed, selection, extra, classes) for fold in folds for seed in seeds]
    results = parallel.in_parallel(apply, tasks, f"integration {name}")
    for (_, fold, seed, *_), result in zip(tasks, results, strict=True):
        place = folder / fold.test / protocol.seed_folder(seed)
        files.write_json(place / "facts.json", result.pop("facts"))
        for array_name, array in result.items():
            files.write_array(place / f"{array_name}.npy", array)


def _extra(
    params: Mapping[str, Any], selection: Mapping[str, int], classes: Sequence[str]
) -> dict[str, tuple[np.ndarray, np.ndarray]]:
    """Chosen frames of further sequences, by `split/sequence`, and their classes among those of the homes."""
    extra = settings.get(params, "protocol.extra")
    own = settings.get(params, f"splits.{extra['split']}.dataset.classes")
    found = {}
    for sequence in extra["sequences"]:
        name = f"{extra['split']}/{sequence}"
        labels = protocol.translate(listing.read_labels(name), own, classes)
        chosen = protocol.select_frames(labels, **selection)
        found[name] = chosen, labels[chosen]
    return found


def apply(
    system: Mapping[str, Any],
    fold: protocol.Fold,
    seed: int | None,
    selection: Mapping[str, int],
    extra: Mapping[str, tuple[np.ndarray, np.ndarray]],
    classes: Sequence[str],
) -> dict[str, Any]:
    """Integrate one fold: distributions for the test home, and cross-validated ones for training."""
    cues = system["cues"]
    labels = {home: listing.read_labels(home) for home in fold.integration_homes}
    chosen = protocol.select_training(labels, **selection)
    truth = {home: labels[home][chosen[home]] for home in fold.integration_homes}
    train = {home: _proba(cues, fold, seed, f"integration_{home}") for home in fold.integration_homes}
    for name, (rows, own) in extra.items():
        proba = _proba(cues, fold, seed, f"extra_{name.rpartition('/')[2]}")
        train[name], truth[name] = proba[rows], own
    test = _proba(cues, fold, seed, "test")
    temperatures = _temperatures(cues, fold, seed) if system["temperature"] else None
    return integrate(train, truth, test, classes, temperatures=temperatures, **system["integrator"])


def _temperatures(cues: Sequence[str], fold: protocol.Fold, seed: int | None) -> list[float]:
    """The temperature of each cue, from its training frames."""
    found = []
    for cue in cues:
        facts = files.read_json(_place(cue, fold, seed) / "facts.json")
        if "temperature" not in facts:
            raise PlacecatError(
                f"cues.{cue} has no temperature: set cues.{cue}.cross_validate, and run `dvc repro`"
            )
        found.append(facts["temperature"])
    return found


def _place(cue: str, fold: protocol.Fold, seed: int | None) -> Path:
    return listing.seeded(paths.CUES / cue / fold.scheme / fold.test, seed)


def _proba(cues: Sequence[str], fold: protocol.Fold, seed: int | None, array: str) -> np.ndarray:
    """(frames, cues, classes) distributions of the cues."""
    parts = []
    for cue in cues:
        path = _place(cue, fold, seed) / f"{array}.npy"
        if not path.exists():
            raise PlacecatError(
                f"{path} is missing: add {fold.scheme} to cues.{cue}.schemes, or set cues.{cue}.extra where "
                "a system asks for extra training data, and run `dvc repro`"
            )
        parts.append(files.read_array(path, memory_map=False))
    return np.stack(parts, axis=1)


if __name__ == "__main__":
    run(main)
