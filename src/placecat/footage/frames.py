"""The frames of a home, decoded."""

from collections.abc import Iterator
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
    """Decode frames in the order of the rows.

    A video or a bag is read from its start, over the frames between rows; a row before the last one starts
    again. Rows in increasing position cost one pass. The file is never asked to seek: containers answer with
    a nearby frame without saying so.

    Parameters
    ----------
    home_root
        `Home.root`.
    frames
        Any rows of `Home.frames`, in any order.
    size
        (width, height) in pixels that every frame must have, once turned; None takes that of the first row.

    Yields
    ------
    (H, W, 3) uint8, BGR, turned as the column ``turn`` says, where there is one.

    Raises
    ------
    PlacecatError
        If a frame is missing, unreadable, or of another size, naming its file.
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
                    f"{where}: the frame is {width}x{height}, the others of this home are "
                    f"{size[0]}x{size[1]}; a home needs one frame size: convert the frame or take it out."
                )
            yield image


class _Video:
    """A video or a bag that is read forwards; to go back, from its start."""

    def __init__(self, path: Path) -> None:
        self.path = path
        self._recording = Bag(path) if is_bag(path) else Recording(path)
        self._pictures = self._recording.pictures()
        self._last: Any = None

    def close(self) -> None:
        self._pictures.close()

    def read(self, position: int) -> NDArray[np.uint8]:
        number = position + 1
        if self._last is not None and number < self._last.number:
            self.close()
            self._pictures, self._last = self._recording.pictures(), None
        if self._last is None or self._last.number < number:
            self._last = next((one for one in self._pictures if one.number >= number), None)
        if self._last is None or self._last.number != number:
            count = self._recording.count
            why = f"it ends after {count}" if number > count else "it is damaged there"
            raise PlacecatError(
                f"{self.path}: frame {number} is missing or unreadable ({why}); restore the file."
            )
        return self._last.image()
