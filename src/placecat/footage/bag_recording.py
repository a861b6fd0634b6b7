"""Read the frames of one topic in a bag, with their numbers and times, and detect lost frames."""

from collections.abc import Generator
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from placecat.errors import PlacecatError
from placecat.footage import timing
from placecat.footage.bags import Bag, Picture
from placecat.footage.image_messages import Damaged
from placecat.footage.recording import Size, are, named

MOST_LATE = 1.0
"""Largest backward step in time between frames, in seconds. A larger step means that the clock was set back.
This limit is our choice."""
_NANOSECOND = Fraction(1, 10**9)


@dataclass(frozen=True, eq=False)
class BagFrame:
    """A frame in a bag, not yet decoded. Frame numbers start at 1."""

    number: int
    _picture: Picture
    _recording: "BagRecording"

    def image(self) -> NDArray[np.uint8] | None:
        """Decode the frame to (H, W, 3) uint8 BGR; return None if it is lost."""
        try:
            return self._picture.image()
        except Damaged as error:
            self._recording.lose(self.number, str(error))
            return None

    @property
    def size(self) -> Size | None:
        """The (width, height) in pixels, or None if the frame is lost."""
        image = self.image()
        return None if image is None else (image.shape[1], image.shape[0])


class BagRecording:
    """The frames of a bag: the images of one topic, ordered by their stamps.

    Opening reads the topic once. Frames that are no later than a preceding frame (late arrivals and
    duplicates) are skipped and not numbered. Raises PlacecatError if the bag cannot be read, if the topic has
    no images, or if its times are implausible.

    Parameters
    ----------
    topic
        The topic; None selects the only topic with images.
    fps
        Frame rate in frames per second, for bags with wrong stamps. If it is set, the frames are assumed to
        be evenly spaced, and none are skipped. None uses the stamps or, if any stamp is zero, the reception
        times.
    settings
        Prefix of the settings ``topic`` and ``fps`` in messages.

    Attributes
    ----------
    count, lost
        `count` is the number of frames, including lost ones. `lost` lists the frames that could not be
        decoded, numbered from 1.
    positions, received
        `placecat.footage.bags.Picture.number` minus 1 and the reception time in nanoseconds, for each frame.
        Both are (count,) int64.
    start
        The stamp of the first frame, in nanoseconds since 1970.
    """

    # An image either decodes without errors or is lost.
    damaged: tuple[int, ...] = ()

    def __init__(
        self, path: Path, topic: str | None = None, fps: float | None = None, *, settings: str = "--"
    ) -> None:
        self.path = path
        self._bag = Bag(path)
        self.topic = self._bag.topic_of_pictures(topic, f"{settings}topic")
        self._remarks: list[str] = []
        self.lost: list[int] = []
        self._why = ""
        found = [(one.number - 1, one.received, one.stamp) for one in self._bag.pictures(self.topic)]
        if not found:
            raise PlacecatError(f"{path}: the topic {self.topic!r} has no messages; correct {settings}topic.")
        self.positions, self.received, stamps = np.array(found, np.int64).T
        if (stamps == 0).any():
            stamps = self.received
            self._remarks.append("some stamps are zero, so the reception times are used instead")
        if fps is None:
            stamps = self._without_late(stamps, f"{settings}fps")
        self.count, self.start = len(self.positions), int(stamps[0])
        self.timing = self._timing(stamps, fps, f"{settings}fps")

    def pictures(self) -> Generator[BagFrame, None, None]:
        """Iterate over the frames without decoding pixels."""
        self.lost, self._why = [], ""
        number = 0
        for picture in self._bag.pictures(self.topic):
            if number < self.count and picture.number - 1 == self.positions[number]:
                number += 1
                yield BagFrame(number, picture, self)

    def lose(self, number: int, why: str) -> None:
        """Record that a frame cannot be decoded, but keep only the first reason."""
        self.lost.append(number)
        self._why = self._why or why

    def size(self) -> Size:
        """Return the (width, height) of the first readable frame, in pixels.

        Raises PlacecatError if no frame is readable.
        """
        for frame in self.pictures():
            if (size := frame.size) is not None:
                return size
        raise PlacecatError(f"{self.path}: no image on {self.topic} can be decoded: {self._why}")

    def note(self) -> str:
        """Describe the problems found on opening the bag and during the last pass; "" if there were none."""
        parts = self._remarks
        if self.lost:
            lost = f"{named(self.lost)} of {self.count} cannot be decoded and {are(self.lost)} lost"
            parts = [f"{lost} ({self._why.rstrip('.')})", *parts]
        return f"{self.path}: {'; '.join(parts)}." if parts else ""

    def _without_late(self, stamps: NDArray[np.int64], setting: str) -> NDArray[np.int64]:
        before = np.maximum.accumulate(stamps)
        behind = (before - stamps) / 1e9
        if behind.max() > MOST_LATE:
            number = int(behind.argmax()) + 1
            raise PlacecatError(
                f"{self.path}: frame {number} of {self.topic} is {behind.max():.3g} s earlier than a "
                "previous frame, so the clock was set back or the stamps are damaged; split the bag there, "
                f"or set the frame rate with {setting}."
            )
        is_late = np.append(False, stamps[1:] <= before[:-1])
        if is_late.any():
            self._remarks.append(
                f"{is_late.sum()} of {len(stamps)} frames are left out because they are no later than a "
                "preceding frame"
            )
        self.positions, self.received = self.positions[~is_late], self.received[~is_late]
        return stamps[~is_late]

    def _timing(self, stamps: NDArray[np.int64], fps: float | None, setting: str) -> timing.Timing:
        if fps is not None:
            return timing.even(self.count, fps)
        found = timing.measure(stamps, _NANOSECOND, 0, [])
        if found is None:
            raise PlacecatError(
                f"{self.path}: no frame rate can be computed from the stamps of {self.topic} ({self.count} "
                f"frame{'s' if self.count > 1 else ''} in {(stamps[-1] - stamps[0]) / 1e9:.3g} s); set the "
                f"frame rate with {setting}."
            )
        timing.check_gaps(found, str(self.path), setting)
        return found
