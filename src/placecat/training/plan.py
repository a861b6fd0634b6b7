"""Training plans: the sequences and frames used to train each component, and the test sequences."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from placecat import settings
from placecat.sequences import listing
from placecat.training import protocol


@dataclass(frozen=True)
class Part:
    """Frames from one sequence.

    `home` names the sequence, as in :func:`placecat.paths.sequences`. `numbers` contains the class index of
    each place in the sequence's data set, or -1 if the place does not count. `offset` and `step` select
    frames; see :func:`placecat.training.protocol.select_frames`.
    """

    home: str
    numbers: tuple[int, ...]
    offset: int = 0
    step: int = 1

    @property
    def sequence(self) -> str:
        """Name of the sequence in its data set."""
        return self.home.rpartition("/")[2]

    def labels(self) -> NDArray[np.int16]:
        """Return the (frames,) class indices of all frames, with -1 for frames that do not count."""
        return np.array([*self.numbers, -1], dtype=np.int16)[listing.read_labels(self.home)]

    def chosen(self) -> tuple[NDArray[np.int64], NDArray[np.int16]]:
        """Return the ascending indices (n,) and the classes (n,) of the chosen frames. All have a class."""
        labels = self.labels()
        rows = protocol.select_frames(labels, offset=self.offset, step=self.step)
        return rows, labels[rows]


@dataclass(frozen=True)
class Plan:
    """The training and test sequences.

    `classes` are the names of the places, and `dataset` is the name of the data set. The parts in `cues` are
    used to train codebooks, scalings and cues, and those in `integration` to train the integration and
    smoothing. Those in `extra` are also used for the integration if a system trains on additional data
    (thesis 4.5). No trained component has seen the parts in `tested`. `left_out` lists the homes not used to
    train the cues, or is None for a fixed split.
    """

    classes: tuple[str, ...]
    cues: tuple[Part, ...]
    integration: tuple[Part, ...]
    extra: tuple[Part, ...]
    tested: tuple[Part, ...]
    dataset: str
    left_out: tuple[str, ...] | None

    @property
    def training_set(self) -> str:
        """Name of the cues' training set; codebook seeds are derived from it and `dataset`."""
        return self.dataset if self.left_out is None else protocol.training_set(self.left_out)

    @property
    def test(self) -> str:
        """Name of the only sequence in `tested`."""
        (part,) = self.tested
        return part.home

    def with_cue_frames(self, frames: Mapping[str, int]) -> Plan:
        """Return this plan, but with other frames (``offset`` and ``step``) for training the cues."""
        offset, step = frames["offset"], frames["step"]
        return replace(self, cues=tuple(replace(part, offset=offset, step=step) for part in self.cues))


def of_homes(
    params: Mapping[str, Any],
    scheme: str,
    tested: str | Sequence[str] = protocol.ALL,
    *,
    extra: bool = False,
) -> list[Plan]:
    """Plan one fold of the main data set for each home in `tested`, as in :func:`of_release`.

    `tested` is as in :func:`placecat.training.protocol.tested_homes`.
    """
    homes = protocol.tested_homes(settings.get(params, "dataset.homes"), tested)
    return [of_release(params, scheme, [home], extra=extra) for home in homes]


def of_release(
    params: Mapping[str, Any], scheme: str, without: Sequence[str] = (), *, extra: bool = False
) -> Plan:
    """Plan a system for other footage: test the homes in `without`, and train on all others.

    `params` contains all settings. See :func:`placecat.training.protocol.training_homes` for `scheme`,
    `without` and the errors raised. `extra` adds the sequences in ``protocol.extra``.
    """
    cues, integration = protocol.training_homes(settings.get(params, "dataset.homes"), scheme, without)
    kept = [home for home in integration if home not in cues]
    plan = _of_main(params, cues, integration, without, (*without, *kept))
    if not extra:
        return plan
    split, sequences = (settings.get(params, f"protocol.extra.{name}") for name in ("split", "sequences"))
    # Places are matched by name.
    places = settings.get(params, f"splits.{split}.dataset.classes")
    numbers = tuple(plan.classes.index(place) if place in plan.classes else -1 for place in places)
    chosen = settings.get(params, "protocol.integration_frames")
    return replace(
        plan, extra=tuple(Part(f"{split}/{sequence}", numbers, **chosen) for sequence in sequences)
    )


def without_homes(params: Mapping[str, Any], tested: Sequence[str]) -> Plan:
    """Plan a test on the homes in `tested` after training on all others."""
    homes = [home for home in settings.get(params, "dataset.homes") if home not in tested]
    return _of_main(params, homes, homes, tested, tuple(tested))


def of_split(params: Mapping[str, Any], split: str) -> Plan:
    """Plan a fixed split, which may train on only some places of a sequence (thesis 4.9 and 4.10)."""
    own = settings.get(params, f"splits.{split}")
    classes = own["dataset"]["classes"]

    def parts(kind: str, frames: str) -> tuple[Part, ...]:
        chosen = settings.get(params, f"protocol.{frames}")
        return tuple(
            Part(f"{split}/{part['sequence']}", _numbers(classes, part["places"]), **chosen)
            for part in own[kind]
        )

    return Plan(
        classes=tuple(classes),
        cues=parts("cue_parts", "cue_frames"),
        integration=parts("integration_parts", "integration_frames"),
        extra=(),
        tested=tuple(Part(f"{split}/{sequence}", _numbers(classes, None)) for sequence in own["test"]),
        dataset=split,
        left_out=None,
    )


def on_training_homes(plan: Plan) -> list[Plan]:
    """For each training home of `plan`, plan a test on it after training on the other training homes.

    The test sequence of `plan` is not used.
    """
    training = [part for part in plan.cues if part.home != plan.test]
    return [
        replace(
            plan,
            cues=tuple(part for part in training if part is not tested),
            integration=tuple(part for part in plan.integration if part.home != tested.home),
            tested=(replace(tested, offset=0, step=1),),
            left_out=None if plan.left_out is None else (tested.home, *plan.left_out),
        )
        for tested in training
    ]


def _of_main(
    params: Mapping[str, Any],
    cues: Sequence[str],
    integration: Sequence[str],
    tested: Sequence[str],
    left_out: tuple[str, ...],
) -> Plan:
    """Make a plan for homes from the main data set, without additional sequences."""
    classes = tuple(settings.get(params, "dataset.classes"))
    numbers = tuple(range(len(classes)))
    cue_frames, integration_frames = (
        settings.get(params, f"protocol.{name}") for name in ("cue_frames", "integration_frames")
    )
    return Plan(
        classes=classes,
        cues=tuple(Part(home, numbers, **cue_frames) for home in cues),
        integration=tuple(Part(home, numbers, **integration_frames) for home in integration),
        extra=(),
        tested=tuple(Part(home, numbers) for home in tested),
        dataset=settings.get(params, "dataset.name"),
        left_out=left_out,
    )


def _numbers(classes: Sequence[str], counted: Sequence[str] | None) -> tuple[int, ...]:
    """Return each place's class index, or -1 if it is not in `counted`. None counts all places."""
    return tuple(
        number if counted is None or place in counted else -1 for number, place in enumerate(classes)
    )
