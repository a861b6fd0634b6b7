"""Stage `codebooks`: cluster each training set once per seed, for all cluster numbers and classifiers."""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from placecat import files, paths, settings
from placecat.cues.codebook import settings_of
from placecat.runs import items
from placecat.stages import run
from placecat.training import plan as plans
from placecat.training import store
from placecat.training.cue import Cue, cluster, read_frames


def main() -> None:
    """Cluster the descriptors of every codebook, once per seed and training set of its schemes."""
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
    items.refresh_together("codebooks", paths.CODEBOOKS, wanted, make_one, lambda name: plan(name, params))


def plan(name: str, params: Mapping[str, Any]) -> items.Work:
    """Plan the clusterings of one codebook: one per seed and training set of its schemes."""
    codebook = settings_of(params, name)
    cue = Cue(codebook["descriptor"], {}, codebook)
    tested = settings.get(params, "protocol.test_homes")
    tasks = {
        paths.codebook(name, fold.training_set, seed).name: (fold, cue, seed)
        for scheme in codebook["schemes"]
        for fold in plans.of_homes(params, scheme, tested)
        for seed in settings.get(params, "protocol.seeds")
    }

    def write(folder: Path, results: list[dict[str, Any]]) -> None:
        for file, arrays in zip(tasks, results, strict=True):
            files.write_arrays(folder / file, arrays)
        files.write_json(folder / "descriptor.json", codebook["descriptor"])

    return list(tasks.values()), write


def make_one(plan: plans.Plan, cue: Cue, seed: int) -> dict[str, Any]:
    """Cluster the frames of one training set; return the codebook as arrays."""
    return cluster(read_frames(plan.cues, cue.descriptor), plan, cue, seed).to_arrays()


if __name__ == "__main__":
    run(main)
