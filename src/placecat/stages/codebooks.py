"""Stage `codebooks`: one tree a training set and seed serves every cluster number and classifier."""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from placecat import files, items, listing, parallel, paths, settings, store
from placecat.cues.codebook import Codebook, seed_of, settings_of
from placecat.evaluation import protocol
from placecat.stages import run


def main() -> None:
    """Cluster the descriptors of every codebook for every training set of its schemes, once for each seed."""
    params = settings.load()
    homes = list(settings.get(params, "dataset.homes"))
    shared = [settings.get(params, name) for name in ("dataset.name", "dataset.homes")]
    shared += [settings.get(params, f"protocol.{name}") for name in ("cue_frames", "seeds", "test_homes")]
    labels = [paths.sequences(home) / "labels.csv" for home in homes]
    wanted = {
        name: items.Inputs(
            [codebook, *shared],
            (*labels, *(path for home in homes for path in store.files_of(home, codebook["descriptor"]))),
        )
        for name in settings.get(params, "codebooks")
        for codebook in [settings_of(params, name)]
    }
    items.refresh("codebooks", paths.CODEBOOKS, wanted, lambda name, folder: make(name, folder, params))


def make(name: str, folder: Path, params: Mapping[str, Any]) -> None:
    """Cluster one kind of descriptor for every training set of its schemes, once for each seed."""
    codebook = settings_of(params, name)
    homes = list(settings.get(params, "dataset.homes"))
    labels = {home: listing.read_labels(home) for home in homes}
    selection = protocol.select_training(labels, **settings.get(params, "protocol.cue_frames"))
    training_sets = {
        fold.training_set: fold.cue_homes
        for scheme in codebook["schemes"]
        for fold in protocol.folds(homes, scheme, settings.get(params, "protocol.test_homes"))
    }
    dataset = settings.get(params, "dataset.name")
    tasks = {
        protocol.codebook_file(training_set, seed): (
            codebook,
            train_homes,
            selection,
            seed_of(dataset, codebook["descriptor"], codebook["cells"], training_set, seed),
        )
        for training_set, train_homes in training_sets.items()
        for seed in settings.get(params, "protocol.seeds")
    }
    results = parallel.in_parallel(cluster, list(tasks.values()), f"codebook {name}")
    for file, arrays in zip(tasks, results, strict=True):
        files.write_arrays(folder / file, arrays)
    files.write_json(folder / "descriptor.json", codebook["descriptor"])


def cluster(
    codebook: Mapping[str, Any], homes: tuple[str, ...], selection: Mapping[str, Any], seed: int
) -> dict[str, Any]:
    """Cluster the selected frames of one training set."""
    train = store.read_training(homes, codebook["descriptor"], selection)
    return Codebook.fit(train, cells=codebook["cells"], seed=seed, tree=codebook["tree"]).to_arrays()


if __name__ == "__main__":
    run(main)
