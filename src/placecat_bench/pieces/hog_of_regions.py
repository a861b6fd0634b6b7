"""HOG of salient regions, compared with OpenCV's HOG, called once per region.

Our code and OpenCV's are given the maps and regions of the frames. For OpenCV, our function cuts out the
patches, which are then resized and described one by one. The descriptors are identical.
"""

from collections.abc import Iterator, Sequence

import cv2
import numpy as np
from numpy.typing import NDArray

from placecat.vision.local import hog
from placecat.vision.maps import FrameMaps
from placecat.vision.patches import cut, region_side, to_bytes
from placecat_bench.comparison import Absent, Comparison, Entry, Limit, Peer
from placecat_bench.frames import REGIONS, REPEATS, Described, Image, prepared, size, with_regions

PIECE = "HOG of regions"
PEER = Peer("OpenCV: HOGDescriptor.compute for each region", "opencv-python-headless")
DLIB = Absent(
    PIECE, "", "dlib 20.0.1: fhog", "no wheel, and only the detectors that use it are available in Python"
)


def entries(*, frames: Sequence[Image] | None = None, count: int = REGIONS) -> Iterator[Entry]:
    """Yield comparisons of run times and descriptors, for `count` regions per frame.

    `frames` must all be the same size; by default, there is one from each rendered home.
    """
    _, pictures = prepared(frames)
    text = f"{count} regions of {size(pictures[0])}"
    given = with_regions(pictures, count)
    patches = [patches_of(*one) for one in given]
    yield Comparison(
        PIECE,
        text,
        PEER,
        lambda: ours(given),
        lambda: theirs(given),
        faster=2,
        repeats=REPEATS,
        parts={
            "cutting": lambda: [patches_of(*one) for one in given],
            "resizing": lambda: [[resized(patch) for patch in some] for some in patches],
            # The rest is OpenCV's code, called for all regions at once.
        },
    )
    yield Limit(
        PIECE,
        text,
        "largest difference between values",
        lambda: float(np.abs(np.concatenate(ours(given)) - np.concatenate(theirs(given))).max()),
        at_most=0,
        peer=PEER,
    )
    yield DLIB


def ours(given: Sequence[Described]) -> list[NDArray[np.float32]]:
    """Compute the (n, 128) HOG descriptors of the regions in each frame."""
    return [hog.describe(maps, regions) for maps, regions in given]


def theirs(given: Sequence[Described]) -> list[NDArray[np.float32]]:
    """Compute the same descriptors with OpenCV, region by region."""
    window = (hog.WINDOW, hog.WINDOW)
    descriptor = cv2.HOGDescriptor(window, (64, 64), (32, 32), (16, 16), 8)
    return [
        np.array([descriptor.compute(resized(patch)) for patch in patches_of(maps, regions)], np.float32)
        for maps, regions in given
    ]


def patches_of(maps: FrameMaps, regions: NDArray[np.float32]) -> Image:
    """Cut out the (n, side, side) patches of the regions."""
    return to_bytes(cut(maps.grey, regions, region_side(maps.width)))


def resized(patch: Image) -> Image:
    """Resize a patch to the size of the descriptor's window."""
    return np.asarray(cv2.resize(patch, (hog.WINDOW, hog.WINDOW)))
