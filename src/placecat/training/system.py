"""A system by a plan: cues, their integration and its smoothing, trained and applied."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from placecat import listing, parallel, settings
from placecat.fusion import integrate, smoothing
from placecat.training import cue as of_cue
from placecat.training.cue import Cue, TrainedCue
from placecat.training.plan import Part, Plan

Probabilities = Mapping[str, NDArray[np.float64]]


@dataclass(frozen=True)
class System:
    """The settings of a system.

    Attributes
    ----------
    cues
        By name, in their order.
    integrator
        ``method`` and ``classifier``, as for :func:`placecat.fusion.integrate.fit`.
    tempered
        Whether the cues' distributions are tempered before.
    extra
        Whether the integration trains on the plan's further sequences as well.
    smoothing
        As for :func:`placecat.fusion.smoothing.fit`.
    """

    cues: Mapping[str, Cue]
    integrator: Mapping[str, Any]
    tempered: bool
    extra: bool
    smoothing: Mapping[str, Any]

    @classmethod
    def of(cls, params: Mapping[str, Any], name: str) -> System:
        """Look up a system of params.yaml."""
        system = settings.get(params, f"systems.{name}")
        cues = {cue: Cue.of(params, cue) for cue in system["cues"]}
        tempered, extra = bool(system["temperature"]), bool(system["extra"])
        return cls(cues, system["integrator"], tempered, extra, smoothing_settings(params))


@dataclass(frozen=True)
class Trained:
    """A system that has learned.

    Attributes
    ----------
    cues
        By name, in their order.
    integrator, smoothing
        What decides from their distributions.
    """

    cues: Mapping[str, TrainedCue]
    integrator: integrate.Integrator
    smoothing: smoothing.SmoothingModel

    def test(self, home: str) -> dict[str, NDArray[np.float64]]:
        """Name the places of every frame of a sequence.

        Returns
        -------
        dict
            (frames, n_classes) distributions of each cue by its name, of the ``integration``, of the
            filter, ``hmm``, and after the delay, ``delayed``.
        """
        by_cue = {name: cue.predict(home) for name, cue in self.cues.items()}
        fused = self.integrator.predict_proba(np.stack(list(by_cue.values()), axis=1))
        smoothed = smoothing.apply(
            self.smoothing, fused, listing.sequence_slices(home), frame_rate=listing.frame_rate(home)
        )
        return by_cue | {"integration": fused} | smoothed


def smoothing_settings(params: Mapping[str, Any]) -> dict[str, Any]:
    """Settings of :func:`placecat.fusion.smoothing.fit`: those of params.yaml, but for what is smoothed."""
    section = settings.get(params, "smoothing")
    return {name: value for name, value in section.items() if name not in ("cues", "filtered")}


def train(plan: Plan, system: System, seed: int) -> Trained:
    """Train a system by a plan, its cues in parallel.

    Parameters
    ----------
    seed
        One of ``protocol.seeds``, for the clusterings.

    Raises
    ------
    PlacecatError
        Features that were not computed, or settings that cannot be.
    """
    parts = fused_parts(plan, extra=system.extra)
    tasks = [(plan, cue, seed, parts, system.tempered) for cue in system.cues.values()]
    done = parallel.in_parallel(_train_cue, tasks, "training of cues")
    fused = fuse(
        parts,
        [proba for _, proba in done],
        plan.classes,
        system.integrator,
        temperatures=[cue.temperature for cue, _ in done] if system.tempered else None,
    )
    assert fused.cross_validated is not None
    walks, frame_rates = training_walks(plan.integration)
    model = smoothing.fit(
        walks,
        fused.cross_validated,
        fused.truth,
        len(plan.classes),
        training_frame_rates=frame_rates,
        **system.smoothing,
    )
    cues = dict(zip(system.cues, (cue for cue, _ in done), strict=True))
    return Trained(cues, fused.integrator, model)


def _train_cue(
    plan: Plan, cue: Cue, seed: int, parts: Sequence[Part], tempered: bool
) -> tuple[TrainedCue, Probabilities]:
    """Train one cue; give it, and its distributions for the integration's frames."""
    trained = of_cue.train(plan, cue, seed, cross_validate=tempered)
    return trained, trained.predict_chosen(parts)


def fused_parts(plan: Plan, *, extra: bool) -> tuple[Part, ...]:
    """Name what an integration trains on."""
    return (*plan.integration, *(plan.extra if extra else ()))


def fuse(
    parts: Sequence[Part],
    outputs: Sequence[Probabilities],
    classes: Sequence[str],
    integrator: Mapping[str, Any],
    *,
    temperatures: Sequence[float] | None = None,
    cross_validated: bool = True,
) -> integrate.Trained:
    """Train an integration.

    Parameters
    ----------
    parts
        What it trains on.
    outputs
        Of each cue the distributions for the chosen frames of these parts, by name.
    classes
        Names of the places.
    integrator, temperatures, cross_validated
        As for :func:`placecat.fusion.integrate.fit`.
    """
    train = {part.home: np.stack([proba[part.home] for proba in outputs], axis=1) for part in parts}
    truth = {part.home: part.chosen()[1] for part in parts}
    return integrate.fit(
        train, truth, classes, temperatures=temperatures, cross_validated=cross_validated, **integrator
    )


def training_walks(parts: Sequence[Part]) -> tuple[list[NDArray[np.int16]], list[float]]:
    """What transitions are counted on: labels of each stretch without a cut, and its frames a second."""
    walks: list[NDArray[np.int16]] = []
    rates: list[float] = []
    for part in parts:
        labels, rate = part.labels(), listing.frame_rate(part.home)
        for stretch in listing.sequence_slices(part.home):
            walks.append(labels[stretch])
            rates.append(rate)
    return walks, rates


def smooth(
    home: str,
    proba: NDArray[np.float64],
    parts: Sequence[Part],
    training_proba: NDArray[np.float64],
    training_truth: NDArray[np.int16],
    options: Mapping[str, Any],
) -> dict[str, NDArray[np.float64]]:
    """Smooth the distributions of a sequence with statistics of others.

    Parameters
    ----------
    proba
        (frames, n_classes) for every frame of `home`.
    parts
        What the statistics are of.
    training_proba, training_truth
        (n, n_classes) cross-validated distributions of their frames, and (n,) classes.
    options
        As for :func:`placecat.fusion.smoothing.fit`.

    Returns
    -------
    dict
        ``hmm`` and ``delayed``, each (frames, n_classes).
    """
    walks, frame_rates = training_walks(parts)
    return smoothing.smooth(
        proba,
        listing.sequence_slices(home),
        frame_rate=listing.frame_rate(home),
        training_sequences=walks,
        training_frame_rates=frame_rates,
        training_proba=training_proba,
        training_truth=training_truth,
        n_classes=proba.shape[1],
        **options,
    )
