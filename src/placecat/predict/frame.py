"""Footage, and one frame."""

from abc import ABC, abstractmethod
from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True, eq=False)
class Frame:
    """One frame.

    Attributes
    ----------
    number
        From 1; in a camera's footage, of the frames that were taken.
    seconds
        Since the first frame.
    file
        Name of the image in a folder; "" otherwise.
    image
        (H, W, 3) uint8, BGR.
    begins
        Whether there is a cut before it, after which the system starts again.
    """

    number: int
    seconds: float
    file: str
    image: NDArray[np.uint8]
    begins: bool = False


def nanoseconds(seconds: float) -> int:
    """Round seconds to nanoseconds: exact for times that were measured in them, up to a hundred days."""
    return round(seconds * 1e9)


@dataclass(frozen=True)
class Damage:
    """Lost and damaged frames of footage.

    Attributes
    ----------
    lost
        Numbers of frames that cannot be decoded.
    damaged
        Numbers of frames that were decoded with errors.
    note
        In words; may be empty.
    """

    lost: Sequence[int] = ()
    damaged: Sequence[int] = ()
    note: str = ""


class Source(ABC):
    """Footage.

    Attributes
    ----------
    name
        For the folder of results.
    is_live
        Whether frames that are not taken in time are lost.
    fps
        Frames a second of the footage.
    size
        (width, height) in pixels of its first frame; others may differ if a phone was turned.
    reached
        Number of the last frame that was looked at, from 1; 0 before the first.
    start
        Nanoseconds since 1970 of the first frame; 0 if the footage does not say.
    """

    name: str
    fps: float
    size: tuple[int, int]
    is_live = False
    reached = 0
    start = 0

    @abstractmethod
    def frames(self, every: int) -> Iterator[Frame]:
        """Decode the first of each `every` frames; of a camera all, as they come."""

    @abstractmethod
    def count(self) -> int | None:
        """Number of frames, probably; None if it is not known."""

    @abstractmethod
    def exact_count(self) -> int:
        """Number of frames, which may take a pass over them.

        Raises
        ------
        PlacecatError
            Of a camera.
        """

    def starts(self) -> NDArray[np.float64] | None:
        """Seconds at which each frame starts and the last one ends; None if they come evenly or live."""
        return None

    def truth(self, classes: Sequence[str], ignored: Collection[str]) -> NDArray[np.int16] | None:
        """(frames,) indices in `classes`, -1 for frames that are not scored; None if it has no labels.

        Parameters
        ----------
        classes
            Classes of the model.
        ignored
            Labels of frames that are not scored.
        """
        return None

    def damage(self) -> Damage:
        """Which of the frames so far are lost or damaged."""
        return Damage()
