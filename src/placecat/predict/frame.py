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
        Frame number, from 1; a camera's unused frames do not count.
    seconds
        Time since the first frame.
    file
        Name of the image file; "" if there is none.
    image
        (H, W, 3) uint8, BGR.
    begins
        Whether a cut precedes the frame; the system restarts after a cut.
    """

    number: int
    seconds: float
    file: str
    image: NDArray[np.uint8]
    begins: bool = False


def nanoseconds(seconds: float) -> int:
    """Convert seconds to whole nanoseconds; exact up to a hundred days for times measured in nanoseconds."""
    return round(seconds * 1e9)


class Damage(NamedTuple):
    """The numbers of the lost (undecodable) and damaged (decoded with errors) frames, and a note."""

    lost: Sequence[int] = ()
    damaged: Sequence[int] = ()
    note: str = ""


class Source(ABC):
    """Base class for footage.

    Attributes
    ----------
    name
        Name of the results folder.
    fps
        Frame rate in frames per second.
    size
        (width, height) of the first frame in pixels; later frames may differ if a phone was turned.
    timing
        Times of all frames, including lost ones; None for a camera.
    is_live
        Whether frames that are not read in time are lost.
    reached
        Number of the last frame read, from 1; 0 before the first.
    start
        Time of the first frame in nanoseconds since 1970; 0 if unknown.
    topic
        A bag's image topic; "" otherwise.
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
        """Decode the first frame that is not lost in each group of `every`; a camera ignores `every`."""

    def truth(self, classes: Sequence[str], ignored: Collection[str]) -> NDArray[np.int16] | None:
        """Return (frames,) indices into the model's `classes`, or -1 if unscored; None without labels.

        Frames with a label in `ignored` are not scored.
        """
        return None

    def damage(self) -> Damage:
        """Return the frames lost or damaged so far."""
        return Damage()
