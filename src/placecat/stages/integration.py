"""Stage `integration`: fuse the cues' distributions to one."""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from placecat import files, listing, parallel, paths, settings
from placecat.errors import PlacecatError
from placecat.evaluation import protocol
from placecat.evaluation.accuracy import confusion_matrix, home_accuracy
from placecat.fusion import das, votes
from placecat.stages import run


def main(name: str) -> None:
    """Train and apply one system's integration in every fold of its scheme."""
    params = settings.load()
    system = settings.get(params, f"systems.{name}")
    homes = list(settings.get(params, "dataset.homes"))
    folds = protocol.folds(homes, system["scheme"])
    classes = settings.get(params, "dataset.classes")
    selection = settings.get(params, "protocol.integration_frames")
    # Cues that left a second home out let the same integration be judged on training homes.
    inner = "4-5-1" in settings.get(params, "protocol.schemes") and system["scheme"] == "5-5-1"
    within = protocol.folds(homes, "4-5-1") if inner else [None] * len(folds)
    with files.replacing(paths.INTEGRATION / name) as folder:
        folder.mkdir(parents=True)
        tasks = [
            (name, system, fold, kept, selection, classes) for fold, kept in zip(folds, within, strict=True)
        ]
        for fold, result in zip(
            folds, parallel.in_parallel(apply, tasks, f"integration {name}"), strict=True
        ):
            files.write_json(folder / fold.test / "facts.json", result.pop("facts"))
            for array_name, array in result.items():
                files.write_array(folder / fold.test / f"{array_name}.npy", array)


def apply(
    name: str,
    system: Mapping[str, Any],
    fold: protocol.Fold,
    within: protocol.Fold | None,
    selection: Mapping[str, int],
    classes: Sequence[str],
) -> dict[str, Any]:
    """Integrate one fold: distributions for the test home, and cross-validated ones for training."""
    cues = system["cues"]
    labels = {home: listing.read_labels(home) for home in fold.integration_homes}
    chosen = protocol.select_training(labels, **selection)
    truth = {home: labels[home][chosen[home]] for home in fold.integration_homes}
    result = _integrate(name, system, cues, fold, fold.integration_homes, truth, "test", classes)
    if within is not None and all((paths.CUES / cue / within.scheme).exists() for cue in cues):
        (kept,) = set(within.integration_homes) - set(within.cue_homes)
        judged = _integrate(
            name, system, cues, within, within.cue_homes, truth, f"integration_{kept}", classes
        )
        confusion = confusion_matrix(truth[kept], judged["test"].argmax(axis=1), len(classes))
        result["facts"]["cross_validated_accuracy"] = {kept: round(home_accuracy(confusion), 2)}
    return result


def _integrate(
    name: str,
    system: Mapping[str, Any],
    cues: Sequence[str],
    fold: protocol.Fold,
    homes: Sequence[str],
    truth: Mapping[str, np.ndarray],
    applied_to: str,
    classes: Sequence[str],
) -> dict[str, Any]:
    test = _proba(cues, fold, applied_to)
    train = np.concatenate([_proba(cues, fold, f"integration_{home}") for home in homes])
    train_truth = np.concatenate([truth[home] for home in homes])
    method = system["integrator"]["method"]
    result: dict[str, Any] = {"facts": {}, "cross_validated_truth": train_truth}
    if method == "das":
        home_of_frame = np.concatenate([np.full(len(truth[home]), home) for home in homes])
        classifier = system["integrator"]["classifier"]
        model = das.fit(train, train_truth, home_of_frame, classes, classifier=classifier)
        assert model.cross_validated is not None
        result["facts"] = dict(model.facts)
        return result | {"test": das.predict_proba(model, test), "cross_validated": model.cross_validated}
    if method in ("vote_distribution", "vote_decision"):
        vote = getattr(votes, method)
        # A vote has nothing to train, so that its statistics need no cross-validation of its own.
        return result | {"test": vote(test), "cross_validated": vote(train)}
    raise PlacecatError(
        f"systems.{name}.integrator.method {method!r} does not exist: "
        "use das, vote_distribution or vote_decision"
    )


def _proba(cues: Sequence[str], fold: protocol.Fold, array: str) -> np.ndarray:
    """(frames, cues, classes) distributions of the cues."""
    parts = []
    for cue in cues:
        path = paths.CUES / cue / fold.scheme / fold.test / f"{array}.npy"
        if not path.exists():
            raise PlacecatError(
                f"{path} is missing: add {fold.scheme} to cues.{cue}.schemes and run `dvc repro`"
            )
        parts.append(files.read_array(path, memory_map=False))
    return np.stack(parts, axis=1)


if __name__ == "__main__":
    run(main, item="system")
