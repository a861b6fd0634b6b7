"""Stage `integration`: fuse the cues' distributions to one."""

from collections.abc import Mapping
from typing import Any

import numpy as np

from placecat import files, listing, parallel, paths, settings
from placecat.errors import PlacecatError
from placecat.evaluation import protocol
from placecat.fusion import das, votes
from placecat.stages import run


def main(name: str) -> None:
    """Train and apply one system's integration in every fold of its scheme."""
    params = settings.load()
    system = settings.get(params, f"systems.{name}")
    folds = protocol.folds(list(settings.get(params, "dataset.homes")), system["scheme"])
    n_classes = len(settings.get(params, "dataset.classes"))
    selection = settings.get(params, "protocol.integration_frames")
    with files.replacing(paths.INTEGRATION / name) as folder:
        folder.mkdir(parents=True)
        tasks = [(name, system, fold, selection, n_classes) for fold in folds]
        for fold, result in zip(
            folds, parallel.in_parallel(integrate, tasks, f"integration {name}"), strict=True
        ):
            files.write_json(folder / fold.test / "facts.json", result.pop("facts"))
            for array_name, array in result.items():
                files.write_array(folder / fold.test / f"{array_name}.npy", array)


def integrate(
    name: str, system: Mapping[str, Any], fold: protocol.Fold, selection: Mapping[str, int], n_classes: int
) -> dict[str, Any]:
    """Integrate one fold: distributions for the test home, and cross-validated ones for training."""
    test = np.stack([_proba(cue, fold, "test") for cue in system["cues"]], axis=1)
    method = system["integrator"]["method"]
    homes = list(fold.integration_homes)
    labels = {home: listing.read_labels(home) for home in homes}
    chosen = protocol.select_training(labels, **selection)
    train = np.concatenate(
        [
            np.stack([_proba(cue, fold, f"integration_{home}") for cue in system["cues"]], axis=1)
            for home in homes
        ]
    )
    truth = np.concatenate([labels[home][chosen[home]] for home in homes])
    if method == "das":
        home_of_frame = np.concatenate([np.full(len(chosen[home]), home) for home in homes])
        model = das.fit(train, truth, home_of_frame, n_classes, classifier=system["integrator"]["classifier"])
        assert model.cross_validated is not None
        return {
            "facts": model.facts,
            "test": das.predict_proba(model, test),
            "cross_validated": model.cross_validated,
            "cross_validated_truth": truth,
        }
    if method in ("vote_distribution", "vote_decision"):
        vote = getattr(votes, method)
        # A vote has nothing to train, so that its statistics need no cross-validation of its own.
        return {
            "facts": {},
            "test": vote(test),
            "cross_validated": vote(train),
            "cross_validated_truth": truth,
        }
    raise PlacecatError(
        f"systems.{name}.integrator.method {method!r} does not exist: "
        "use das, vote_distribution or vote_decision"
    )


def _proba(cue: str, fold: protocol.Fold, array: str) -> np.ndarray:
    path = paths.CUES / cue / fold.scheme / fold.test / f"{array}.npy"
    if not path.exists():
        raise PlacecatError(f"{path} is missing: add {fold.scheme} to cues.{cue}.schemes and run `dvc repro`")
    return files.read_array(path, memory_map=False)


if __name__ == "__main__":
    run(main, item="system")
