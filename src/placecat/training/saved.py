"""Read saved results of cues and systems as training data."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from placecat import paths
from placecat.errors import PlacecatError
from placecat.fusion import integrate
from placecat.training import fold_file
from placecat.training.integration import apply_smoothing, fit_smoothing
from placecat.training.plan import Part, Plan


class CueResults:
    """Results of a system's cues, as saved by the `cues` stage for one test home and one seed.

    `system` contains the settings of the system, and `test` is the test home. `seed` is one of
    ``protocol.seeds``, or None if no cue has clusters.
    """

    def __init__(self, system: Mapping[str, Any], test: str, seed: int | None) -> None:
        self._scheme = system["scheme"]
        self._places = {
            cue: fold_file.seeded(paths.CUES / cue / self._scheme, test, seed) for cue in system["cues"]
        }

    def arrays(self, name: str) -> list[NDArray[Any]]:
        """Read the array `name` of each cue. Raise PlacecatError if a cue was not applied to these frames."""
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

    def training(
        self, plan: Plan, parts: Sequence[Part], method: str
    ) -> list[dict[str, NDArray[np.float64]]]:
        """Like `outputs`, but for the parts used to train an integration (see `fused_parts`).

        If the method learns from held-out frames, the distributions come from cues that have not seen the
        part.
        """
        if not integrate.learns_from_held_out(method):
            return self.outputs(plan, parts)
        ends = np.cumsum([len(part.chosen()[0]) for part in plan.cues])
        homes = [part.home for part in plan.cues]
        return [
            dict(zip(homes, np.split(proba, ends[:-1]), strict=True))
            for proba in self.arrays("cross_validated")
        ]

    def temperatures(self) -> list[float]:
        """Read each cue's temperature. Raise PlacecatError if a cue was not cross-validated."""
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
    """Smooth the test home of a fold with statistics from its training homes.

    `source` is a cue's or a system's result file for the fold. Raises PlacecatError if it has no
    cross-validated distributions. `model` is as in :func:`placecat.fusion.smoothing.fit`.
    """
    if not fold_file.has(source, "cross_validated"):
        raise PlacecatError(
            f"{source} has no array cross_validated: each cue in smoothing.cues needs a cross-validated "
            "classifier, such as nu_svm; remove the cue from this list, or run `dvc repro`"
        )
    proba, held_out, truth = (
        fold_file.read(source, name) for name in ("test", "cross_validated", "cross_validated_truth")
    )
    return apply_smoothing(fit_smoothing(plan.integration, held_out, truth, model), plan.test, proba)
