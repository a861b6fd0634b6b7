"""Train and apply one system according to a plan: cues, integration and smoothing."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from placecat import settings
from placecat.compute import parallel
from placecat.fusion import integrate, smoothing
from placecat.training import cue as of_cue
from placecat.training.cue import Cue, TrainedCue
from placecat.training.integration import (
    Probabilities,
    apply_smoothing,
    fit_smoothing,
    fuse,
    fused_parts,
    smoothing_settings,
)
from placecat.training.plan import Part, Plan


@dataclass(frozen=True)
class System:
    """The settings of a system, and its cues by name, in order.

    `integrator` has ``method`` and ``classifier``, as in :func:`placecat.fusion.integrate.fit`. `smoothing`
    is as in :func:`placecat.fusion.smoothing.fit`. If `tempered` is true, the cues' distributions are
    tempered before integration. If `extra` is true, the integration also trains on the additional sequences
    in the plan.
    """

    cues: Mapping[str, Cue]
    integrator: Mapping[str, Any]
    tempered: bool
    extra: bool
    smoothing: Mapping[str, Any]

    @classmethod
    def of(cls, params: Mapping[str, Any], name: str) -> System:
        """Look up a system in params.yaml."""
        system = settings.get(params, f"systems.{name}")
        cues = {cue: Cue.of(params, cue) for cue in system["cues"]}
        tempered, extra = bool(system["temperature"]), bool(system["extra"])
        return cls(cues, system["integrator"], tempered, extra, smoothing_settings(params))

    def descriptors(self, params: Mapping[str, Any]) -> dict[str, dict[str, Any]]:
        """Return the ``local`` and ``holistic`` descriptors that the cues need, with their settings."""
        wanted: dict[str, dict[str, Any]] = {"local": {}, "holistic": {}}
        for cue in self.cues.values():
            kind = cue.descriptor["kind"]
            for name in filter(None, (cue.descriptor["name"], cue.descriptor.get("color"))):
                wanted[kind][name] = settings.get(params, f"descriptors.{kind}.{name}")
        return wanted


@dataclass(frozen=True)
class Trained:
    """A trained system: its cues by name, in order, and the models trained on their distributions."""

    cues: Mapping[str, TrainedCue]
    integrator: integrate.Integrator
    smoothing: smoothing.SmoothingModel

    def test(self, home: str) -> dict[str, NDArray[np.float64]]:
        """Estimate the place in every frame of a sequence.

        Returns (frames, n_classes) distributions by name: those of each cue, and those after the integration
        (``integration``), the filter (``hmm``) and the delay (``delayed``).
        """
        by_cue = {name: cue.predict(home) for name, cue in self.cues.items()}
        fused = self.integrator.predict_proba(np.stack(list(by_cue.values()), axis=1))
        return by_cue | {"integration": fused} | apply_smoothing(self.smoothing, home, fused)


def train(plan: Plan, system: System, seed: int) -> Trained:
    """Train a system according to a plan, training its cues in parallel.

    `seed` is the seed for clustering, one of ``protocol.seeds``. Raises PlacecatError if features are missing
    or settings are invalid.
    """
    method = system.integrator["method"]
    parts = fused_parts(plan, method=method, extra=system.extra)
    judged = None if integrate.learns_from_held_out(method) else parts
    tasks = [(plan, cue, seed, judged, system.tempered) for cue in system.cues.values()]
    done = parallel.in_parallel(_train_cue, tasks, "training of cues")
    fused = fuse(
        parts,
        [proba for _, proba, _ in done],
        plan.classes,
        system.integrator,
        temperatures=[temperature for *_, temperature in done] if system.tempered else None,
    )
    assert fused.cross_validated is not None
    model = fit_smoothing(plan.integration, fused.cross_validated, fused.truth, system.smoothing)
    cues = dict(zip(system.cues, (cue for cue, *_ in done), strict=True))
    return Trained(cues, fused.integrator, model)


def _train_cue(
    plan: Plan, cue: Cue, seed: int, parts: Sequence[Part] | None, tempered: bool
) -> tuple[TrainedCue, Probabilities, float]:
    """Train one cue, and return it with its distributions for the integration and its temperature.

    If `parts` is None, the integration trains on the frames that the cue was cross-validated on.
    """
    trained = of_cue.train(plan, cue, seed, cross_validate=tempered or parts is None)
    outputs = trained.held_out() if parts is None else trained.predict_chosen(parts)
    return trained, outputs, trained.temperature
