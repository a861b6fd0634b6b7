"""Footage and its frames."""

from abc import ABC, abstractmethod
from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from placecat.footage.timing import Timing


@dataclass(frozen=True, eq=False)
class Frame:
    """One frame.

    Attributes
    ----------
    number
        From 1; for a camera, among the frames that were taken.
    seconds
        Since the first frame.
    file
        Name of the image in a folder; "" otherwise.
    image
        (H, W, 3) uint8, BGR.
    begins
        Whether a cut precedes it, after which the system starts again.
    """

    number: int
    seconds: float
    file: str
    image: NDArray[np.uint8]
    begins: bool = False


def nanoseconds(seconds: float) -> int:
    """Round seconds to nanoseconds: exact for times that were measured in them, up to a hundred days."""
    return round(seconds * 1e9)


class Damage(NamedTuple):
    """Numbers of the frames that cannot be decoded, of those that were decoded with errors, and a note."""

    lost: Sequence[int] = ()
    damaged: Sequence[int] = ()
    note: str = ""


class Source(ABC):
    """Footage.

    Attributes
    ----------
    name
        For the folder of results.
    fps
        Frames a second of the footage.
    size
        (width, height) in pixels of its first frame; others may differ if a phone was turned.
    timing
        Times of all frames, lost ones included; None for a camera.
    is_live
        Whether frames that are not taken in time are lost.
    reached
        Number of the last frame that was looked at, from 1; 0 before the first.
    start
        Nanoseconds since 1970 of the first frame; 0 if the footage does not say.
    topic
        The topic of a bag; "" otherwise.
    """

    name: str
    fps: float
    size: tuple[int, int]
    timing: Timing | None
    is_live = False
    reached = 0
    start = 0
    topic = ""

    @abstractmethod
    def frames(self, every: int) -> Iterator[Frame]:
        """Decode the first of each `every` frames or, if that is lost, the next; of a camera, all."""

    def truth(self, classes: Sequence[str], ignored: Collection[str]) -> NDArray[np.int16] | None:
        """(frames,) indices in the model's `classes`, -1 for frames that are not scored; None without labels.

        The labels in `ignored` are not scored.
        """
        return None

    def damage(self) -> Damage:
        """Which of the frames so far are lost or damaged."""
        return Damage()
