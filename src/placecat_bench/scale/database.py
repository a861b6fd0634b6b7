"""The number of frames per label in a home database, and plausible walks to match."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import zip_longest
from typing import Any

import numpy as np

from placecat import seeds
from placecat.errors import PlacecatError

TRANSITION = "transition"


@dataclass(frozen=True)
class Stretch:
    """One or more consecutive frames with the same label, on the same floor.

    Floors are numbered from 1. The footage of each floor is continuous.
    """

    floor: int
    label: str
    frames: int


@dataclass(frozen=True)
class Home:
    """Counts from a label file: floors, and frames and stretches per label. All are at least 1."""

    name: str
    floors: int
    labels: Mapping[str, tuple[int, int]]

    @property
    def frames(self) -> int:
        """The number of frames in the home."""
        return sum(frames for frames, _ in self.labels.values())

    def scaled(self, size: float) -> "Home":
        """Return the home with `size` times as many frames per label, but at least one.

        The number of stretches stays the same unless a label would then have fewer frames than that.
        """
        labels = {}
        for label, (frames, stretches) in self.labels.items():
            fewer = max(1, round(frames * size))
            labels[label] = (fewer, min(stretches, fewer))
        return replace(self, labels=labels)

    def walk(self) -> list[Stretch]:
        """Shuffle stretches of random length, with transitions between them. The home's name is the seed."""
        rng = np.random.default_rng(seeds.derive("scale", "walk", self.name))
        places: list[tuple[str, int]] = []
        transitions: list[tuple[str, int]] = []
        for label, (frames, count) in self.labels.items():
            shares = 1 + rng.multinomial(frames - count, rng.dirichlet(np.full(count, 4.0)))
            own = transitions if label == TRANSITION else places
            own += [(label, int(share)) for share in shares]
        shuffled = [places[number] for number in rng.permutation(len(places))]
        ordered = [one for pair in zip_longest(shuffled, transitions) for one in pair if one is not None]
        ends = np.linspace(0, len(ordered), self.floors + 1)[1:]
        return [
            Stretch(1 + int(np.searchsorted(ends, number, side="right")), label, frames)
            for number, (label, frames) in enumerate(ordered)
        ]


def read_homes(content: Mapping[str, Any]) -> list[Home]:
    """Read ``floors`` and ``labels`` of each home in conf/scale.yaml. Invalid values raise PlacecatError."""
    homes = []
    for name, own in content.items():
        try:
            labels = {
                str(label): (int(frames), int(count)) for label, (frames, count) in own["labels"].items()
            }
            floors = int(own["floors"])
        except (KeyError, TypeError, ValueError, AttributeError):
            raise PlacecatError(
                f"conf/scale.yaml: homes.{name} needs floors (a number) and labels (LABEL: [frames, "
                "stretches])"
            ) from None
        if floors < 1 or not labels or any(not 1 <= count <= frames for frames, count in labels.values()):
            raise PlacecatError(
                f"conf/scale.yaml: homes.{name} needs at least one floor, and labels with at least one "
                "stretch and at least as many frames as stretches"
            )
        homes.append(Home(str(name), floors, labels))
    return homes


def classes_of(stretches: Sequence[Stretch], classes: Sequence[str], ignored: Sequence[str]) -> list[int]:
    """Return the class of each stretch, or -1 for labels in `ignored`. Unknown labels raise PlacecatError."""
    for stretch in stretches:
        if stretch.label not in classes and stretch.label not in ignored:
            raise PlacecatError(
                f"conf/scale.yaml has the label {stretch.label!r}, which is neither in dataset.classes nor "
                "in dataset.ignored: add it to one of them"
            )
    return [classes.index(one.label) if one.label in classes else -1 for one in stretches]
