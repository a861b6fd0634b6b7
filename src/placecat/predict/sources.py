"""Footage to predict: a video file, a folder of images, or a camera, frame by frame."""

import re
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import cv2
import numpy as np
from numpy.typing import NDArray

from placecat.errors import PlacecatError, reading
from placecat.predict.camera import Camera
from placecat.predict.frame import Frame, Source
from placecat.sequences import video
from placecat.sequences.base import open_video
from placecat.sequences.pictures import SUFFIXES, list_frames, read_image

_CAMERA = re.compile(r"camera(?::([0-9]{1,4}))?")
_STREAM = re.compile(r"(rtsps?|https?)://.+", re.IGNORECASE)
# A container's number of frames is an estimate; a file that ends this much earlier is cut off.
_WHOLE = 0.95


def without_password(text: str) -> str:
    """The address of a stream without user and password; anything else as it is."""
    return re.sub(r"(?<=://)[^/@]*@", "", text) if _STREAM.fullmatch(text) else text


def open_source(text: str, *, fps: float | None, usual_fps: float, size: tuple[int, int]) -> Source:
    """Open footage.

    Parameters
    ----------
    text
        A video file, a folder of images, ``camera`` or ``camera:NUMBER``, or the address of a stream
        (rtsp, http). A file or folder is taken before a camera of its name.
    fps
        Frames a second; None takes what the footage says.
    usual_fps
        Taken for a folder, which does not say.
    size
        (width, height) that a camera is asked for.

    Raises
    ------
    PlacecatError
        If it is none of these, or cannot be read.
    """
    if fps is not None and not (np.isfinite(fps) and fps > 0):
        raise PlacecatError(f"--fps is {fps:g}: give a positive number")
    path = Path(text)
    if _STREAM.fullmatch(text):
        name = re.sub(r"[^A-Za-z0-9]+", "_", without_password(text).split("://")[1]).strip("_")
        return Camera(text, name or "stream", fps, size, title=without_password(text))
    with reading(path):
        if path.is_dir():
            return Folder(path, fps if fps is not None else usual_fps)
        if path.is_file():
            return Video(path, fps)
    camera = _CAMERA.fullmatch(text)
    if camera:
        number = int(camera[1] or 0)
        return Camera(number, f"camera_{number}", fps, size, title=f"camera {number}")
    raise PlacecatError(
        f"{text}: no such file or folder: give a video, a folder of images, camera, camera:NUMBER, or the "
        "address of a stream (rtsp://..., http://...)"
    )


class Video(Source):
    """A video file, decoded from its start as the stages decode it."""

    def __init__(self, path: Path, fps: float | None) -> None:
        if path.suffix.lower() not in video.SUFFIXES:
            raise PlacecatError(
                f"{path}: not a video by its ending ({', '.join(video.SUFFIXES)}); convert it, e.g. "
                f"`ffmpeg -i {path.name} {path.stem}.mp4`; images go into a folder"
            )
        self.name = path.stem
        self._path = path
        with self._opened() as capture:
            done, first = capture.read()
            known = capture.get(cv2.CAP_PROP_FPS)
            self._announced = int(capture.get(cv2.CAP_PROP_FRAME_COUNT))
        if not done:
            raise PlacecatError(f"{path}: the video has no readable frame; restore or convert it")
        rate = fps if fps is not None else known
        if not (np.isfinite(rate) and rate > 0):
            raise PlacecatError(f"{path}: the video does not say its frame rate: give it with --fps")
        self.fps = float(rate)
        self.size = (first.shape[1], first.shape[0])

    def frames(self, every: int) -> Iterator[Frame]:
        """Decode the first of each `every` frames."""
        self.reached = 0
        with self._opened() as capture:
            while capture.grab():
                self.reached += 1
                if (self.reached - 1) % every:
                    continue
                done, image = capture.retrieve()
                if not done or image is None:
                    raise PlacecatError(
                        f"{self._path}: frame {self.reached} cannot be decoded; restore the file"
                    )
                yield Frame(self.reached, (self.reached - 1) / self.fps, "", image)  # type: ignore[arg-type]

    @contextmanager
    def _opened(self) -> Iterator[cv2.VideoCapture]:
        capture = open_video(self._path)
        try:
            yield capture
        finally:
            capture.release()

    def count(self) -> int | None:
        """Number of frames as the container has it, often an estimate."""
        return self._announced if self._announced > 0 else None

    def exact_count(self) -> int:
        """Number of frames, by passing over the whole video."""
        with self._opened() as capture:
            return sum(1 for _ in iter(capture.grab, False))

    def warning(self) -> str:
        """Whether the file ends long before its header says; only after all its frames were taken."""
        if self.reached >= _WHOLE * self._announced:
            return ""
        return (
            f"{self._path}: only {self.reached} of the {self._announced} frames that the file announces can "
            "be read; it may be cut off or damaged"
        )


class Folder(Source):
    """JPEG and PNG files, as the layout `folder` lists them."""

    def __init__(self, path: Path, fps: float) -> None:
        self._images = list_frames(path)
        if not self._images:
            raise PlacecatError(
                f"{path}: no images here ({', '.join(SUFFIXES)}); give a folder of frames, or a video"
            )
        self.name = path.resolve().name
        self.fps = fps
        self._path = path
        first = read_image(path / self._images[0])
        self.size = (first.shape[1], first.shape[0])

    def frames(self, every: int) -> Iterator[Frame]:
        """Decode the first of each `every` frames."""
        for number, name in enumerate(self._images, 1):
            self.reached = number
            if (number - 1) % every == 0:
                yield Frame(number, (number - 1) / self.fps, name, self._read(name))

    def _read(self, name: str) -> NDArray[np.uint8]:
        image = read_image(self._path / name)
        size = (image.shape[1], image.shape[0])
        if size != self.size:
            raise PlacecatError(
                f"{self._path / name}: {size[0]}x{size[1]} pixels, but the first image has "
                f"{self.size[0]}x{self.size[1]}; convert it or take it out"
            )
        return image

    def count(self) -> int:
        """Number of images."""
        return len(self._images)

    exact_count = count
