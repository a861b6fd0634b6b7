"""Read the newest frame from a camera or stream, and drop older frames."""

import threading
import time
from collections.abc import Iterator

import cv2
import numpy as np
from numpy.typing import NDArray

from placecat.errors import PlacecatError
from placecat.footage.timing import MOST_RATE
from placecat.predict.frame import Frame, Source

# The frame rate to assume if a camera reports none, or an implausible one. Some streams report 90,000.
USUAL_FPS = 30.0
# The camera is considered disconnected after this many failed reads in a row. The second number is the pause
# after each failed read, in seconds.
_FAILURES, _PAUSE = 10, 0.05
PATIENCE = 10.0
"""The camera is considered disconnected after this many seconds without a frame."""


class Camera(Source):
    """A live camera or stream.

    A thread reads every frame and keeps only the newest, so old frames do not queue up in the driver. The
    footage ends when the camera stops delivering frames. Raises PlacecatError if the camera cannot be opened
    or delivers no frames.

    `address` is the number of a camera or the address of a stream. `name` is used for the results folder, and
    `title` in messages. `fps`, in frames per second, overrides the frame rate that the camera reports. `size`
    is the (width, height) requested from a numbered camera, which may still deliver a different size. The
    attribute `arrived` counts the frames that the camera has delivered, up to the last one used.
    """

    is_live, timing = True, None

    def __init__(
        self, address: int | str, name: str, fps: float | None, size: tuple[int, int], *, title: str
    ) -> None:
        self.name = name
        self.arrived = 0
        if isinstance(address, int):
            question = "is it connected and not in use? Other cameras are camera:1, camera:2, ..."
            self._capture = cv2.VideoCapture(address)
            self._capture.set(cv2.CAP_PROP_FRAME_WIDTH, size[0])
            self._capture.set(cv2.CAP_PROP_FRAME_HEIGHT, size[1])
        else:
            question = "is the address correct, and is the stream running?"
            self._capture = cv2.VideoCapture(address, cv2.CAP_FFMPEG)
        if not self._capture.isOpened():
            raise PlacecatError(f"{title} cannot be opened: {question}")
        done, first = self._capture.read()
        if not done or first is None:
            self._capture.release()
            raise PlacecatError(f"{title} opens but delivers no frames: is another program using it?")
        self.size = (first.shape[1], first.shape[0])
        known = self._capture.get(cv2.CAP_PROP_FPS)
        self.fps = fps if fps is not None else known if 0 < known <= MOST_RATE else USUAL_FPS
        self._news = threading.Condition()
        self._newest: tuple[NDArray[np.uint8], float] | None = None
        self._delivered = 0
        self._is_over = False

    def frames(self, every: int) -> Iterator[Frame]:
        """Wait for new frames and yield the newest. `every` applies only to files, and is ignored here."""
        thread = threading.Thread(target=self._read, name="camera", daemon=True)
        thread.start()
        start: float | None = None
        try:
            while True:
                with self._news:
                    # Wait briefly each time: on some systems, Ctrl-C does not interrupt a long wait.
                    until = time.monotonic() + PATIENCE
                    while self._newest is None and not self._is_over and time.monotonic() < until:
                        self._news.wait(0.2)
                    if self._newest is None:
                        return
                    (image, when), self._newest = self._newest, None
                    self.arrived = self._delivered
                start = when if start is None else start
                self.reached += 1
                yield Frame(self.reached, round(when - start, 3), "", image)
        finally:
            self._is_over = True
            thread.join(timeout=2.0)
            if not thread.is_alive():
                self._capture.release()

    def _read(self) -> None:
        failures = 0
        while not self._is_over:
            done, image = self._capture.read()
            if not done or image is None:
                failures += 1
                if failures < _FAILURES:
                    time.sleep(_PAUSE)
                    continue
            with self._news:
                if done and image is not None:
                    failures = 0
                    self._newest = (image, time.monotonic())  # type: ignore[assignment]
                    self._delivered += 1
                else:
                    self._is_over = True
                self._news.notify_all()
