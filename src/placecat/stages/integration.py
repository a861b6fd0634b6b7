"""Stage `integration`: fuse the cues' distributions to one."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from placecat import files, items, listing, parallel, paths, settings
from placecat.errors import PlacecatError
from placecat.stages import run
from placecat.training import plan as plans
from placecat.training.system import fuse, fused_parts


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
    tested = settings.get(params, "protocol.test_homes")
    random = [cue for cue in system["cues"] if settings.get(params, f"cues.{cue}.codebook") is not None]
    seeds = settings.get(params, "protocol.seeds") if random else [None]
    planned = plans.of_homes(params, system["scheme"], tested, extra=system["extra"])
    tasks = [(system, plan, seed) for plan in planned for seed in seeds]
    results = parallel.in_parallel(apply, tasks, f"integration {name}")
    for (_, plan, seed), result in zip(tasks, results, strict=True):
        place = folder / plan.test / paths.seed_folder(seed)
        files.write_json(place / "facts.json", result.pop("facts"))
        for array_name, array in result.items():
            files.write_array(place / f"{array_name}.npy", array)


def apply(system: Mapping[str, Any], plan: plans.Plan, seed: int | None) -> dict[str, Any]:
    """Integrate one fold: distributions for the test home, and cross-validated ones for training."""
    read = CueResults(system, plan.test, seed)
    parts = fused_parts(plan, extra=system["extra"])
    trained = fuse(
        parts,
        read.outputs(plan, parts),
        plan.classes,
        system["integrator"],
        temperatures=read.temperatures() if system["temperature"] else None,
    )
    return {
        "facts": trained.facts,
        "test": trained.integrator.predict_proba(np.stack(read.arrays("test"), axis=1)),
        "cross_validated": trained.cross_validated,
        "cross_validated_truth": trained.truth,
    }


class CueResults:
    """What the stage `cues` left of a system's cues for one test home and seed.

    Parameters
    ----------
    system
        Its settings.
    test
        The test home.
    seed
        One of ``protocol.seeds``; None if no cue has clusters.
    """

    def __init__(self, system: Mapping[str, Any], test: str, seed: int | None) -> None:
        self._scheme = system["scheme"]
        self._places = {
            cue: listing.seeded(paths.CUES / cue / self._scheme / test, seed) for cue in system["cues"]
        }

    def arrays(self, name: str) -> list[NDArray[Any]]:
        """Read one array of every cue.

        Raises
        ------
        PlacecatError
            A cue that has not been applied to these frames.
        """
        found = []
        for cue, place in self._places.items():
            path = place / f"{name}.npy"
            if not path.exists():
                raise PlacecatError(
                    f"{path} is missing: add {self._scheme} to cues.{cue}.schemes, or set cues.{cue}.extra "
                    "where a system asks for extra training data, and run `dvc repro`"
                )
            found.append(files.read_array(path, memory_map=False))
        return found

    def outputs(self, plan: plans.Plan, parts: Sequence[plans.Part]) -> list[dict[str, NDArray[np.float64]]]:
        """Of each cue the distributions for the chosen frames of some parts of the plan, by name."""
        found: list[dict[str, NDArray[np.float64]]] = [{} for _ in self._places]
        for part in parts:
            is_extra = part in plan.extra
            name = f"extra_{part.home.rpartition('/')[2]}" if is_extra else f"integration_{part.home}"
            for of_cue, proba in zip(found, self.arrays(name), strict=True):
                # Cues judge every frame of a further sequence.
                of_cue[part.home] = proba[part.chosen()[0]] if is_extra else proba
        return found

    def temperatures(self) -> list[float]:
        """Read the temperature of each cue.

        Raises
        ------
        PlacecatError
            A cue that was not cross-validated.
        """
        found = []
        for cue, place in self._places.items():
            facts = files.read_json(place / "facts.json")
            if "temperature" not in facts:
                raise PlacecatError(
                    f"cues.{cue} has no temperature: set cues.{cue}.cross_validate, and run `dvc repro`"
                )
            found.append(facts["temperature"])
        return found


if __name__ == "__main__":
    run(main)
