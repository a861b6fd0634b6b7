"""Prediction with the model from the `model` stage: frames arrive one by one and are categorized on one core.

Each decision includes feature extraction, region tracking, all cues, their integration and smoothing.
"""

import subprocess
import sys
import time
from collections.abc import Iterator, Sequence
from functools import cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from placecat import paths
from placecat.categorizer import Categorizer
from placecat.errors import PlacecatError
from placecat.vision.memory import keep_freed_memory
from placecat_bench.comparison import Comparison, Limit, Peer
from placecat_bench.frames import Image, consecutive, decoded, encoded, size
from placecat_bench.timing import median_seconds

PIECE = "Prediction"
PEER = Peer("OpenCV: imdecode", "opencv-python-headless")
# Frame rate of a typical camera in frames per second.
CAMERA = 30
PERCENTILES = (50, 95, 99)
REPEATS = 5
_FIRST_DECISION = """
import sys, numpy
from placecat.categorizer import Categorizer
categorizer = Categorizer.load(sys.argv[1])
width, height = categorizer.frame_sizes[0]
categorizer.update(numpy.zeros((height, width, 3), numpy.uint8))
"""


def entries(*, frames: Sequence[Image] | None = None) -> Iterator[Comparison | Limit]:
    """Yield the ratio to decoding time, the frame rate, the latencies, and the time to the first decision.

    `frames` must be consecutive; by default, 100 frames of a rendered home are used. The frame rate and the
    latencies include decoding. Raises PlacecatError if there is no model.
    """
    if not paths.MODEL.is_file():
        raise PlacecatError(f"{paths.MODEL} does not exist: run `make repro`")
    keep_freed_memory()
    files = [encoded(frame) for frame in (consecutive(100) if frames is None else frames)]
    pictures = [decoded(file) for file in files]
    categorizer = Categorizer.load(paths.MODEL, resize=True)
    text = f"{size(pictures[0])} JPEG"

    def decide() -> list[Any]:
        categorizer.reset()
        return [categorizer.update(picture) for picture in pictures]

    @cache
    def latencies() -> NDArray[np.float64]:
        return np.concatenate([_latencies(categorizer, files) for _ in range(REPEATS)])

    def decode() -> list[Any]:
        return [decoded(file) for file in files]

    # This limit is our choice. The frame rate below shows whether we can keep up with a camera.
    yield Comparison(PIECE, text, PEER, decide, decode, at_most=12, parts={"decisions": decide})
    yield Limit(
        PIECE,
        text,
        "frames/s on one core, with decoding",
        lambda: 1 / latencies().mean(),
        at_least=CAMERA,
        parts={"decisions": decide, "decoding": decode},
    )
    for percent in PERCENTILES:
        yield Limit(
            PIECE,
            f"{text}: latency of {percent}% of the frames",
            "seconds",
            lambda percent=percent: float(np.percentile(latencies(), percent)),  # type: ignore[misc]
            at_most=round(1 / CAMERA, 3),
        )
    yield Limit(
        PIECE,
        "from the start of Python to the first decision",
        "seconds",
        lambda: median_seconds(first_decision, REPEATS),
        at_most=2,
    )


def _latencies(categorizer: Categorizer, files: Sequence[Image]) -> NDArray[np.float64]:
    """Decode and categorize frames, and return the time each one takes, in seconds."""
    categorizer.reset()
    times = [time.perf_counter()]
    for file in files:
        categorizer.update(decoded(file))
        times.append(time.perf_counter())
    return np.diff(times)


def first_decision() -> None:
    """Load the model and categorize a frame in a new process."""
    subprocess.run([sys.executable, "-c", _FIRST_DECISION, str(paths.MODEL)], check=True)
