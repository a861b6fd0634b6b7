"""Open footage: a video, a bag, a folder of images, or a camera."""

import re
from collections.abc import Iterator
from pathlib import Path

from placecat.errors import PlacecatError, reading
from placecat.footage.bag_recording import BagRecording
from placecat.footage.bags import is_bag
from placecat.footage.pictures import SUFFIXES, list_frames, read_image
from placecat.footage.recording import Recording
from placecat.footage.timing import Timing, even
from placecat.predict.camera import Camera
from placecat.predict.frame import Damage, Frame, Source
from placecat.sequences import video

# Limits in frames per second. The upper limit is the same as for dataset.fps, and the lower limit is our
# choice.
SLOWEST, FASTEST = 0.001, 1000.0
_CAMERA = re.compile(r"camera(?::([0-9]{1,4}))?")
_STREAM = re.compile(r"(rtsps?|https?)://.+", re.IGNORECASE)


def without_password(text: str) -> str:
    """Remove the user name and password from a stream's address, and leave other text unchanged."""
    return re.sub(r"(?<=://)[^/@]*@", "", text) if _STREAM.fullmatch(text) else text


def open_source(
    text: str, *, fps: float | None, usual_fps: float, size: tuple[int, int], topic: str | None = None
) -> Source:
    """Open footage. Raises PlacecatError if it cannot be read.

    `text` names the footage: a video file, a folder of images, a bag, the address of a stream (rtsp, http),
    ``camera``, or ``camera:NUMBER``. A file or folder takes precedence over a camera of the same name.

    `fps`, in frames per second, overrides the frame rate of the footage. A folder has no frame rate, so its
    default is `usual_fps`. `size` is the (width, height) requested from a camera. `topic` is the image topic
    of a bag. It may be None if the bag has only one.
    """
    if fps is not None and not SLOWEST <= fps <= FASTEST:
        raise PlacecatError(f"--fps is {fps:g}: use a number from {SLOWEST:g} to {FASTEST:g}")
    path = Path(text)
    with reading(path):
        if is_bag(path):
            bag = BagRecording(path, topic, fps)
            return Recorded(path.resolve().name if path.is_dir() else path.stem, bag, bag.timing)
    if topic is not None:
        raise PlacecatError(
            f"--topic works only with bags, but {without_password(text)} is not a bag: leave it out"
        )
    if _STREAM.fullmatch(text):
        name = re.sub(r"[^A-Za-z0-9]+", "_", without_password(text).split("://")[1]).strip("_")
        return Camera(text, name or "stream", fps, size, title=without_password(text))
    with reading(path):
        if path.is_dir():
            return Folder(path, fps if fps is not None else usual_fps)
        if path.is_file():
            return _video(path, fps)
    camera = _CAMERA.fullmatch(text)
    if camera:
        number = int(camera[1] or 0)
        return Camera(number, f"camera_{number}", fps, size, title=f"camera {number}")
    if path.exists():
        raise PlacecatError(f"{text} is not a regular file: use a video or a folder of images")
    raise PlacecatError(
        f"there is no file or folder {text}: use a video, a folder of images, a bag, camera, camera:NUMBER, "
        "the address of a stream (rtsp://..., http://...), or home:NAME for a home in the data set"
    )


def _video(path: Path, fps: float | None) -> "Recorded":
    if path.suffix.lower() not in video.SUFFIXES:
        raise PlacecatError(
            f"{path}: not a video with a supported suffix ({', '.join(video.SUFFIXES)}); convert it, for "
            f"example with `ffmpeg -i {path.name} {path.stem}.mp4`, or put its frames in a folder"
        )
    recording = Recording(path)
    return Recorded(path.stem, recording, recording.timing(fps, "--fps"))


class Recorded(Source):
    """A video or a bag. It is decoded from the start, exactly as in the pipeline stages."""

    timing: Timing

    def __init__(self, name: str, recording: Recording | BagRecording, timing: Timing) -> None:
        self.name, self._recording = name, recording
        self.timing, self.fps, self.size = timing, timing.fps, recording.size()
        if isinstance(recording, BagRecording):
            self.topic, self.start = recording.topic, recording.start

    def frames(self, every: int) -> Iterator[Frame]:
        """From each group of `every` frames, decode the first that is not lost."""
        last = -1
        for picture in self._recording.pictures():
            self.reached = number = picture.number
            if (number - 1) // every > last and (image := picture.image()) is not None:
                last = (number - 1) // every
                yield Frame(number, float(self.timing.seconds[number - 1]), "", image)
        self.reached = self._recording.count

    def damage(self) -> Damage:
        """Return the frames lost or damaged so far."""
        return Damage(self._recording.lost, self._recording.damaged, self._recording.note())


class Folder(Source):
    """A folder of JPEG and PNG files, in the order used by the `folder` layout."""

    timing: Timing

    def __init__(self, path: Path, fps: float) -> None:
        self._images, self._path = list_frames(path), path
        if not self._images:
            raise PlacecatError(
                f"{path}: the folder has no images ({', '.join(SUFFIXES)}); use a folder of frames, "
                "or a video"
            )
        self.name, self.fps, self.timing = path.resolve().name, fps, even(len(self._images), fps)
        first = read_image(path / self._images[0])
        self.size = (first.shape[1], first.shape[0])

    def frames(self, every: int) -> Iterator[Frame]:
        """Decode every `every`-th frame, starting with the first."""
        for number, name in enumerate(self._images, 1):
            self.reached = number
            if (number - 1) % every == 0:
                image = read_image(self._path / name)
                height, width, _ = image.shape
                if (width, height) != self.size:
                    raise PlacecatError(
                        f"{self._path / name}: the image is {width}x{height} pixels, but the first image "
                        f"is {self.size[0]}x{self.size[1]}; convert or remove it"
                    )
                yield Frame(number, (number - 1) / self.fps, name, image)
