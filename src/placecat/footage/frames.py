"""Decode the frames of a home."""

from collections.abc import Generator, Iterator
from contextlib import ExitStack, closing
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
from numpy.typing import NDArray

from placecat.errors import PlacecatError
from placecat.footage.bags import Bag, is_bag
from placecat.footage.names import relative
from placecat.footage.pictures import read_image, turned
from placecat.footage.recording import Recording


def read_frames(
    home_root: Path | str, frames: pd.DataFrame, *, size: tuple[int, int] | None = None
) -> Iterator[NDArray[np.uint8]]:
    """Decode frames in row order.

    In a video, decoding starts at the latest frame from which the first row can be decoded. A bag is read
    from the beginning. If a frame precedes the previously read frame in its file, reading restarts, so rows
    in ascending order need only one pass. The code never seeks within a file, because some containers would
    silently return a nearby frame.

    `home_root` is `Home.root`, and `frames` are any rows of `Home.frames`, in any order. `size` is the
    (width, height) in pixels that every frame must have after rotation; None uses the size of the first
    frame. Yields (H, W, 3) uint8 BGR. Each frame is rotated by the angle in the ``turn`` column, if there is
    one. Raises a PlacecatError that names the file if a frame is missing, unreadable, or of a different size.
    """
    root = Path(home_root)
    turns = frames["turn"] if "turn" in frames else [0] * len(frames)
    with ExitStack() as opened:
        video: _Video | None = None
        for source, position, turn in zip(frames["source"], frames["position"], turns, strict=True):
            path = root / relative(source, "frame list")
            if position < 0:
                image = read_image(path)
            else:
                if video is None or video.path != path:
                    opened.close()
                    video = opened.enter_context(closing(_Video(path)))
                image = video.read(int(position))
            image = turned(image, int(turn))
            height, width = image.shape[:2]
            size = size or (width, height)
            if (width, height) != size:
                where = str(path) if position < 0 else f"{path} frame {position + 1}"
                raise PlacecatError(
                    f"{where}: the frame is {width}x{height}, but the other frames of this home are "
                    f"{size[0]}x{size[1]}; all must be the same size: convert or remove the frame."
                )
            yield image


# Reopening a video takes about as long as decoding this many frames.
_WORTH_A_JUMP = 30


class _Video:
    """Read a video or a bag forwards; in a video, reading can start at a later frame."""

    def __init__(self, path: Path) -> None:
        self.path = path
        self._recording = Bag(path) if is_bag(path) else Recording(path)
        self._pictures: Generator[Any, None, None] | None = None
        # The last image read; None before the first one and after the end.
        self._last: Any = None

    def close(self) -> None:
        if self._pictures is not None:
            self._pictures.close()

    def read(self, position: int) -> NDArray[np.uint8]:
        number = position + 1
        if self._pictures is None or self._is_elsewhere(number):
            self.close()
            recording = self._recording
            self._pictures = (
                recording.pictures() if isinstance(recording, Bag) else recording.pictures(number)
            )
            self._last = next(self._pictures, None)
        while self._last is not None and self._last.number < number:
            self._last = next(self._pictures, None)
        if self._last is None or self._last.number != number:
            count = self._recording.count
            why = f"the file ends after {count}" if number > count else "the file is damaged there"
            raise PlacecatError(
                f"{self.path}: frame {number} is missing or unreadable ({why}); restore the file."
            )
        image: NDArray[np.uint8] = self._last.image()
        return image

    def _is_elsewhere(self, number: int) -> bool:
        """Return whether the frame has been passed or is so far ahead that restarting saves time."""
        if self._last is None or number < self._last.number:
            return True
        if isinstance(self._recording, Bag):
            return False
        return self._recording.start_before(number) - self._last.number > _WORTH_A_JUMP
