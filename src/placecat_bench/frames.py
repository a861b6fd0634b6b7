"""Frames for benchmarks of vision code, one from each rendered home."""

from collections.abc import Sequence
from itertools import islice
from pathlib import Path
from typing import Any

import cv2
import numpy as np
from numpy.typing import NDArray

from placecat import settings
from placecat.errors import PlacecatError
from placecat.footage.recording import Recording
from placecat.stages.features import feature_options
from placecat.vision.attention import compute_maps, find_regions
from placecat.vision.maps import FrameMaps
from placecat.vision.memory import keep_freed_memory

HOMES = Path("data/homes")
# Number of regions per frame, as in the thesis.
REGIONS = 25
# Number of pairs of calls. Each call processes all frames.
REPEATS = 15

Image = NDArray[np.uint8]
# The maps and salient regions of a frame.
Described = tuple[FrameMaps, NDArray[np.float32]]


def prepared(frames: Sequence[Image] | None = None) -> tuple[list[Image], list[Image]]:
    """Return frames as JPEG files and as pixels; by default, one frame from each rendered home.

    From now on, the process keeps freed memory, as the `features` stage does.
    """
    keep_freed_memory()
    files = jpegs() if frames is None else [encoded(frame) for frame in frames]
    return files, [decoded(file) for file in files]


def jpegs(homes: Path = HOMES) -> list[Image]:
    """Encode one frame from each rendered home as a JPEG, at OpenCV's default quality.

    The frame is taken one third of the way into the video. Returns the bytes of each JPEG. Raises
    PlacecatError if the folder has no videos or a video cannot be read.
    """
    return [encoded(_frames(path, 1)[0]) for path in _videos(homes)]


def consecutive(count: int, homes: Path = HOMES) -> list[Image]:
    """Decode `count` consecutive frames of the first rendered home, from a third of the way into its video.

    Each frame is (H, W, 3) uint8 BGR. Raises the same errors as `jpegs`.
    """
    return _frames(_videos(homes)[0], count)


def encoded(frame: Image) -> Image:
    """Encode an (H, W, 3) uint8 BGR frame as a JPEG and return its bytes."""
    return np.asarray(cv2.imencode(".jpg", frame)[1])


def decoded(jpeg: Image) -> Image:
    """Decode a JPEG to an (H, W, 3) uint8 BGR frame."""
    return np.asarray(cv2.imdecode(jpeg, cv2.IMREAD_COLOR))


def size(frame: NDArray[Any]) -> str:
    """Return the width and height of a frame as text."""
    return f"{frame.shape[1]}x{frame.shape[0]}"


def options() -> dict[str, Any]:
    """Return the settings of the `features` stage."""
    params = settings.load()
    return feature_options(params, settings.get(params, "descriptors"))


def with_regions(frames: Sequence[Image], count: int = REGIONS) -> list[Described]:
    """Compute the maps and salient regions of (H, W, 3) uint8 BGR frames, as the `features` stage does."""
    own = options()
    maps = [compute_maps(frame, **own["attention"]) for frame in frames]
    return [(one, find_regions(one, **(own["regions"] | {"max_regions": count}))) for one in maps]


def _videos(homes: Path) -> list[Path]:
    videos = sorted(homes.glob("*.mp4"))
    if not videos:
        raise PlacecatError(f"{homes} has no videos: restore the rendered homes from git")
    return videos


def _frames(video: Path, count: int) -> list[Image]:
    recording = Recording(video)
    first = recording.count // 3 + 1
    frames = [picture.image() for picture in islice(recording.pictures(first), count)]
    if len(frames) < count:
        raise PlacecatError(f"{video}: frame {first + len(frames)} cannot be read; restore the file")
    return frames
