"""Footage, its frames, and their times."""

from abc import ABC, abstractmethod
from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from placecat.footage.timing import Timing


@dataclass(frozen=True, eq=False)
class Frame:
    """A frame of footage.

    `number` starts at 1 and does not count frames dropped by a camera. `seconds` is the time since the first
    frame. `file` is the name of the image file, or "" if there is none. `image` is (H, W, 3) uint8 BGR.
    If `begins` is true, the frame follows a cut and the system restarts.
    """

    number: int
    seconds: float
    file: str
    image: NDArray[np.uint8]
    begins: bool = False


def nanoseconds(seconds: float) -> int:
    """Convert seconds to whole nanoseconds.

    Times measured in nanoseconds are recovered exactly, up to a hundred days.
    """
    return round(seconds * 1e9)


def clock(seconds: float) -> str:
    """Format a time as minutes and seconds, with hours if needed, such as "0:07" or "1:02:03"."""
    minutes, rest = divmod(int(seconds), 60)
    hours, minutes = divmod(minutes, 60)
    return f"{hours}:{minutes:02d}:{rest:02d}" if hours else f"{minutes}:{rest:02d}"


class Damage(NamedTuple):
    """The numbers of the lost and damaged frames, and a note for the user.

    A lost frame cannot be decoded. A damaged frame was decoded with errors.
    """

    lost: Sequence[int] = ()
    damaged: Sequence[int] = ()
    note: str = ""


class Source(ABC):
    """Base class for footage.

    `name` is the default name of the results folder, and `fps` is in frames per second. `size` is the (width,
    height) of the first frame in pixels; later frames may differ if a phone was rotated. `timing` contains
    the times of all frames, including lost ones, or is None for a camera. If `is_live` is true, frames that
    are not read in time are dropped. `reached` is the number of the last frame read, counted from 1, or 0
    before the first frame. `start` is the time of the first frame in nanoseconds since 1970, or 0 if it is
    unknown. `topic` is the image topic of a bag, or "" for other footage.
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
        """From each group of `every` frames, decode the first that is not lost. Cameras ignore `every`."""

    def truth(self, classes: Sequence[str], ignored: Collection[str]) -> NDArray[np.int16] | None:
        """Return the true place of each frame, or None if there are no labels.

        The places are (frames,) indices into the model's `classes`, or -1 for frames that are not scored,
        such as those with a label in `ignored`.
        """
        return None

    def damage(self) -> Damage:
        """Return the frames lost or damaged so far."""
        return Damage()
