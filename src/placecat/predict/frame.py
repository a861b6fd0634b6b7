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
    """One frame.

    `number` counts from 1, without a camera's unused frames; `seconds` is the time since the first frame.
    `file` is the name of the image file, or "". `image` is (H, W, 3) uint8, BGR. If `begins`, a cut precedes
    the frame, and the system restarts.
    """

    number: int
    seconds: float
    file: str
    image: NDArray[np.uint8]
    begins: bool = False


def nanoseconds(seconds: float) -> int:
    """Convert seconds to whole nanoseconds; exact up to a hundred days for times measured in nanoseconds."""
    return round(seconds * 1e9)


def clock(seconds: float) -> str:
    """Format seconds as minutes and seconds, and hours if needed, such as "0:07" or "1:02:03"."""
    minutes, rest = divmod(int(seconds), 60)
    hours, minutes = divmod(minutes, 60)
    return f"{hours}:{minutes:02d}:{rest:02d}" if hours else f"{minutes}:{rest:02d}"


class Damage(NamedTuple):
    """The numbers of the lost (undecodable) and damaged (decoded with errors) frames, and a note."""

    lost: Sequence[int] = ()
    damaged: Sequence[int] = ()
    note: str = ""


class Source(ABC):
    """Base class for footage.

    `name` is the default name of the results folder, `fps` is in frames per second, and `size` is the (width,
    height) of the first frame in pixels; later frames may differ if a phone was turned. `timing` has the
    times of all frames, including lost ones; it is None for a camera. If `is_live`, frames that are not read
    in time are lost. `reached` is the number of the last frame read, from 1, or 0 before the first. `start`
    is the time of the first frame in nanoseconds since 1970, or 0 if unknown. `topic` is a bag's image topic,
    or "".
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
        """Decode one frame in `every`, the first that is not lost; a camera ignores `every`."""

    def truth(self, classes: Sequence[str], ignored: Collection[str]) -> NDArray[np.int16] | None:
        """Return (frames,) indices into the model's `classes`, or -1 if unscored; None without labels.

        Frames with a label in `ignored` are not scored.
        """
        return None

    def damage(self) -> Damage:
        """Return the frames lost or damaged so far."""
        return Damage()
