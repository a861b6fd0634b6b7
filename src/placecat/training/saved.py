"""Read saved results of cues and systems for further training."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from placecat import paths
from placecat.errors import PlacecatError
from placecat.fusion import integrate
from placecat.training import fold_file
from placecat.training.integration import smooth
from placecat.training.plan import Part, Plan


class CueResults:
    """The stage `cues`' results for a system's cues, one test home and one seed.

    Parameters
    ----------
    system
        Settings of the system.
    test
        The test home.
    seed
        One of ``protocol.seeds``; None if no cue has clusters.
    """

    def __init__(self, system: Mapping[str, Any], test: str, seed: int | None) -> None:
        self._scheme = system["scheme"]
        self._places = {
            cue: fold_file.seeded(paths.CUES / cue / self._scheme, test, seed) for cue in system["cues"]
        }

    def arrays(self, name: str) -> list[NDArray[Any]]:
        """Read one array per cue; raise PlacecatError if a cue was not applied to these frames."""
        found = []
        for cue, place in self._places.items():
            if not fold_file.has(place, name):
                raise PlacecatError(
                    f"{place} has no {name}: add {self._scheme} to cues.{cue}.schemes, or set "
                    f"cues.{cue}.extra if a system uses extra training data, and run `dvc repro`"
                )
            found.append(fold_file.read(place, name))
        return found

    def outputs(self, plan: Plan, parts: Sequence[Part]) -> list[dict[str, NDArray[np.float64]]]:
        """For each cue, map each part's name to the distributions for its chosen frames."""
        found: list[dict[str, NDArray[np.float64]]] = [{} for _ in self._places]
        for part in parts:
            is_extra = part in plan.extra
            name = f"extra_{part.sequence}" if is_extra else f"integration_{part.home}"
            for of_cue, proba in zip(found, self.arrays(name), strict=True):
                # Cues predict every frame of an additional sequence.
                of_cue[part.home] = proba[part.chosen()[0]] if is_extra else proba
        return found

    def held_out(self, plan: Plan) -> list[dict[str, NDArray[np.float64]]]:
        """For each cue, map each training home to its frames' distributions from cues that never saw it."""
        ends = np.cumsum([len(part.chosen()[0]) for part in plan.cues])
        return [
            dict(zip((part.home for part in plan.cues), np.split(proba, ends[:-1]), strict=True))
            for proba in self.arrays("cross_validated")
        ]

    def training(
        self, plan: Plan, parts: Sequence[Part], method: str
    ) -> list[dict[str, NDArray[np.float64]]]:
        """For each cue, return the distributions that an integration method trains on, see `fused_parts`."""
        if integrate.learns_from_held_out(method):
            return self.held_out(plan)
        return self.outputs(plan, parts)

    def temperatures(self) -> list[float]:
        """Read each cue's temperature.

        Raises
        ------
        PlacecatError
            If a cue was not cross-validated.
        """
        found = []
        for cue, place in self._places.items():
            facts = fold_file.read_facts(place)
            if "temperature" not in facts:
                raise PlacecatError(
                    f"cues.{cue} has no temperature: set cues.{cue}.cross_validate, and run `dvc repro`"
                )
            found.append(facts["temperature"])
        return found


def smooth_home(source: Path, plan: Plan, model: Mapping[str, Any]) -> dict[str, np.ndarray]:
    """Smooth one fold's test home using statistics from the fold's training homes.

    `source` is a cue's or a system's result file for the fold; without cross-validated distributions it
    raises PlacecatError. `model` is as in :func:`placecat.fusion.smoothing.fit`.
    """
    if not fold_file.has(source, "cross_validated"):
        raise PlacecatError(
            f"{source} has no cross_validated: a cue in smoothing.cues needs a cross-validated classifier, "
            "such as nu_svm; remove the cue from the list, or run `dvc repro`"
        )
    proba, held_out, truth = (
        fold_file.read(source, name) for name in ("test", "cross_validated", "cross_validated_truth")
    )
    return smooth(plan.test, proba, plan.integration, held_out, truth, model)
