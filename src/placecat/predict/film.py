"""Write images to a video file."""

from fractions import Fraction
from pathlib import Path

import av
import cv2
import numpy as np
from av.video.frame import VideoFrame
from av.video.stream import VideoStream
from numpy.typing import NDArray

from placecat.errors import PlacecatError

# Maps each suffix to a codec and its options. The options favour speed. Browsers can play both formats.
_CODECS = {
    ".mp4": ("libx264", {"preset": "ultrafast"}),
    ".webm": ("libvpx", {"deadline": "good", "cpu-used": "5", "crf": "20", "b": "2M"}),
}


class Film:
    """Writes a video file in a ``with`` block.

    `path` ends in .mp4 (for H.264) or .webm (for VP8). `fps` is in frames per second. `size` is the (width,
    height), and both must be even. Raises PlacecatError if FFmpeg cannot write the format, or if the file is
    incomplete at the end of the block.
    """

    def __init__(self, path: Path, fps: float, size: tuple[int, int]) -> None:
        codec, options = _CODECS[path.suffix]
        self._path, self._fps, self._count = path, fps, 0
        av.logging.set_level(av.logging.PANIC)
        try:
            self._container = av.open(str(path), "w")
            rate = Fraction(fps).limit_denominator(1001)
            stream = self._container.add_stream(codec, rate=rate, options=options)
        except (av.FFmpegError, ValueError):
            raise PlacecatError(
                f"this FFmpeg cannot write {path.suffix} with {codec}: use the other "
                "option (--video or --webm), or neither"
            ) from None
        assert isinstance(stream, VideoStream)
        self._stream = stream
        self._stream.width, self._stream.height = size
        self._stream.pix_fmt = "yuv420p"

    def add(self, picture: NDArray[np.uint8], seconds: float) -> None:
        """Add a (height, width, 3) uint8 BGR image taken at `seconds`.

        The image is repeated to fill the time since the previous one, so the video plays in real time.
        """
        for _ in range(round(seconds * self._fps) + 1 - self._count):
            self._write(VideoFrame.from_ndarray(picture, "bgr24"))
            self._count += 1

    def _write(self, frame: VideoFrame | None) -> None:
        try:
            self._container.mux(self._stream.encode(frame))
        except av.FFmpegError:
            raise self._cut() from None

    def __enter__(self) -> "Film":
        return self

    def __exit__(self, kind: type[BaseException] | None, *_: object) -> None:
        try:
            if kind is None:
                self._write(None)
        finally:
            try:
                self._container.close()
            except av.FFmpegError:
                if kind is None:
                    raise self._cut() from None
        if kind is None and self._count and not self._is_whole():
            raise self._cut()

    def _cut(self) -> PlacecatError:
        return PlacecatError(f"the video {self._path.name} could not be written in full: is the disk full?")

    def _is_whole(self) -> bool:
        """Return whether the file contains its last image. FFmpeg does not always report a failed write."""
        film = cv2.VideoCapture(str(self._path), cv2.CAP_FFMPEG)
        try:
            film.set(cv2.CAP_PROP_POS_FRAMES, self._count - 1)
            return bool(film.grab())
        finally:
            film.release()
