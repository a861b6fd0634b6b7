"""Train one cue according to a plan: read frames, cluster them, fit the cue, and predict other frames."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from placecat import cues, settings
from placecat.cues.codebook import Codebook, seed_of, settings_of
from placecat.cues.descriptors import Descriptors
from placecat.fusion.temperature import fit_temperature
from placecat.training import store
from placecat.training.plan import Part, Plan


@dataclass(frozen=True)
class Cue:
    """The settings of a cue.

    `descriptor` is as in :func:`placecat.cues.cue_input.check`, and `classifier` is as in
    :func:`placecat.cues.fit`. `codebook` has ``cells`` and ``tree``, as in
    :meth:`placecat.cues.codebook.Codebook.fit`, or is None for a cue without clusters.
    """

    descriptor: Mapping[str, Any]
    classifier: Mapping[str, Any]
    codebook: Mapping[str, Any] | None = None

    @classmethod
    def of(cls, params: Mapping[str, Any], name: str) -> Cue:
        """Look up a cue in params.yaml."""
        cue = settings.get(params, f"cues.{name}")
        if cue["codebook"] is None:
            return cls(cue["descriptor"], cue["classifier"])
        codebook = settings_of(params, cue["codebook"])
        return cls(codebook["descriptor"], cue["classifier"], codebook)


@dataclass(frozen=True)
class TrainingFrames:
    """Descriptors, classes (n,) and sequence names (n,) of the n training frames, part by part."""

    described: Descriptors
    truth: NDArray[np.int16]
    home_of_frame: NDArray[np.str_]


@dataclass(frozen=True)
class TrainedCue:
    """A trained cue, with the classes and sequence names of its training frames.

    `cross_validated` contains (n, n_classes) distributions for these frames from
    :func:`placecat.cues.cross_validate`, or is None if there was no cross-validation.
    """

    descriptor: Mapping[str, Any]
    model: cues.CueModel
    truth: NDArray[np.int16]
    home_of_frame: NDArray[np.str_]
    cross_validated: NDArray[np.float64] | None

    def predict(self, home: str, rows: NDArray[np.int64] | None = None) -> NDArray[np.float64]:
        """Return (n, n_classes) distributions for the frames `rows` of a sequence, by default all."""
        return self.model.predict_proba(store.read_descriptors(home, self.descriptor, rows))

    def predict_chosen(self, parts: Sequence[Part]) -> dict[str, NDArray[np.float64]]:
        """Map each part's sequence name to the distributions for its chosen frames."""
        return {part.home: self.predict(part.home, part.chosen()[0]) for part in parts}

    def held_out(self) -> dict[str, NDArray[np.float64]]:
        """Map each training sequence to distributions for its frames, from a cue that has not seen it."""
        assert self.cross_validated is not None
        return {
            str(home): self.cross_validated[self.home_of_frame == home]
            for home in dict.fromkeys(self.home_of_frame.tolist())
        }

    @cached_property
    def temperature(self) -> float:
        """The temperature of the distributions, or 1 if the cue was not cross-validated."""
        return 1.0 if self.cross_validated is None else fit_temperature(self.cross_validated, self.truth)


def read_frames(parts: Sequence[Part], descriptor: Mapping[str, Any]) -> TrainingFrames:
    """Read the chosen frames of each part, in order.

    Raises the same errors as :func:`placecat.training.store.read_descriptors`.
    """
    chosen = {part.home: part.chosen() for part in parts}
    rows = {home: frames for home, (frames, _) in chosen.items()}
    return TrainingFrames(
        store.read_training(descriptor, rows),
        np.concatenate([truth for _, truth in chosen.values()]),
        np.concatenate([np.full(len(frames), home) for home, frames in rows.items()]),
    )


def cluster(
    frames: TrainingFrames, plan: Plan, cue: Cue, seed: int, *, numbers: Sequence[int] | None = None
) -> Codebook:
    """Cluster a cue's training frames.

    The clustering seed is derived from the plan, the cue, and `seed`, which is one of ``protocol.seeds``.
    `numbers` lists the numbers of clusters that will be used. If it is None, they come from the codebook
    settings.
    """
    assert cue.codebook is not None
    cells = cue.codebook["cells"]
    return Codebook.fit(
        frames.described,
        cells=cells,
        seed=seed_of(plan.dataset, cue.descriptor, cells, plan.training_set, seed),
        tree=cue.codebook["tree"],
        numbers=numbers,
    )


def fit(
    frames: TrainingFrames,
    cue: Cue,
    classes: Sequence[str],
    codebook: Codebook | None,
    *,
    cross_validate: bool = False,
) -> TrainedCue:
    """Train a cue on frames, with a codebook if it needs one.

    With `cross_validate`, the frames of each sequence are also predicted by a cue trained on the other
    sequences. `classes` are the names of the places. Raises the same errors as :func:`placecat.cues.fit`.
    """
    data = frames.described, frames.truth, frames.home_of_frame
    options: dict[str, Any] = {"classifier": cue.classifier, "classes": classes, "codebook": codebook}
    held_out = cues.cross_validate(*data, **options) if cross_validate else None
    model = cues.fit(*data, **options)
    return TrainedCue(cue.descriptor, model, frames.truth, frames.home_of_frame, held_out)


def train(
    plan: Plan,
    cue: Cue,
    seed: int | None = None,
    *,
    numbers: Sequence[int] | None = None,
    cross_validate: bool = False,
) -> TrainedCue:
    """Train a cue according to a plan: read the plan's frames, cluster them if needed, and fit the cue.

    `seed` and `numbers` are as in :func:`cluster`. They are not needed for a cue without clusters.
    `cross_validate` is as in :func:`fit`. Raises the same errors as :func:`read_frames` and :func:`fit`.
    """
    frames = read_frames(plan.cues, cue.descriptor)
    codebook = None
    if cue.codebook is not None:
        assert seed is not None
        codebook = cluster(frames, plan, cue, seed, numbers=numbers)
    return fit(frames, cue, plan.classes, codebook, cross_validate=cross_validate)
