"""Pictures into a video."""

from pathlib import Path

import cv2
import numpy as np
from numpy.typing import NDArray

from placecat.errors import PlacecatError

CODECS = {".mp4": "mp4v", ".webm": "VP80"}
"""Of those that OpenCV writes everywhere: MPEG-4 takes 2 ms for 640x480 pixels and opens in most players, but
not in browsers; VP8 opens in browsers, but takes 70 ms."""


class Film:
    """A video file that is being written.

    Parameters
    ----------
    path
        Ends with one of `CODECS`.
    fps
        Frames a second.
    size
        (width, height), both even.

    Raises
    ------
    PlacecatError
        If OpenCV cannot write it, at once or, at the end of a ``with`` block, all of it.
    """

    def __init__(self, path: Path, fps: float, size: tuple[int, int]) -> None:
        codec = cv2.VideoWriter.fourcc(*CODECS[path.suffix])
        self._writer = cv2.VideoWriter(str(path), cv2.CAP_FFMPEG, codec, fps, size)
        self._path = path
        self._fps = fps
        self._count = 0
        if not self._writer.isOpened():
            raise PlacecatError(
                f"this OpenCV writes no {path.suffix} of {size[0]}x{size[1]} pixels at {fps:g} frames/s: "
                "leave out --video, or try the other of --video and --webm"
            )

    def add(self, picture: NDArray[np.uint8], seconds: float) -> None:
        """Add a picture.

        Parameters
        ----------
        picture
            (height, width, 3) uint8, BGR.
        seconds
            When it was taken: it is repeated up to this time, so that the film runs as time did.
        """
        times = round(seconds * self._fps) + 1 - self._count
        for _ in range(times):
            self._writer.write(picture)
        self._count += max(times, 0)

    def __enter__(self) -> "Film":
        return self

    def __exit__(self, kind: type[BaseException] | None, *_: object) -> None:
        self._writer.release()
        if kind is None and self._count and not self._is_whole():
            raise PlacecatError(
                f"the film {self._path.name} could not be written to its end: is the disk full?"
            )

    def _is_whole(self) -> bool:
        """Whether the last picture is there: OpenCV does not say that writing failed."""
        film = cv2.VideoCapture(str(self._path), cv2.CAP_FFMPEG)
        try:
            film.set(cv2.CAP_PROP_POS_FRAMES, self._count - 1)
            return bool(film.grab())
        finally:
            film.release()
