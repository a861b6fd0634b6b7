"""SIFT of salient regions, compared with OpenCV's SIFT on full levels and kornia's SIFT on patches.

The regions of a frame lie on different levels of its pyramid. OpenCV is given each level as an 8-bit image,
with a keypoint for each region. The cells of the keypoints are the same size as ours. OpenCV needs one call
to `SIFT.compute` per level, and each call blurs the full level several times before describing a point. The
time to prepare the images and keypoints is not counted.

kornia describes patches, so our code cuts out patches the size of the regions.
"""

from collections.abc import Callable, Iterator, Sequence
from functools import partial
from typing import Any

import cv2
import numpy as np
from numpy.typing import NDArray

from placecat.vision.local import sift
from placecat.vision.maps import FrameMaps
from placecat.vision.patches import cut, region_side, to_bytes
from placecat_bench.comparison import TORCH, Comparison, Peer
from placecat_bench.frames import REGIONS, REPEATS, Described, Image, prepared, size, with_regions

PEER = Peer("OpenCV: SIFT.compute on each level", "opencv-python-headless")
KORNIA = Peer("kornia: SIFTDescriptor of cut patches", "kornia", extra=TORCH)
PIECE = "SIFT of regions"

# A pyramid level and its keypoints.
Points = tuple[Image, list[cv2.KeyPoint]]


def entries(*, frames: Sequence[Image] | None = None, count: int = REGIONS) -> Iterator[Comparison]:
    """Yield comparisons of our time with those of the peers, for `count` regions per frame.

    `frames` must all be the same size; by default, there is one from each rendered home.
    """
    _, pictures = prepared(frames)
    given = with_regions(pictures, count)
    points = [keypoints(*one) for one in given]
    text, spent = f"{count} regions of {size(pictures[0])}", parts(given)
    patches = [cut(maps.grey, regions, region_side(maps.width)) for maps, regions in given]
    for peer, call, faster in (
        (PEER, partial(theirs, points), 4),
        (KORNIA, partial(by_kornia, patches), 2),
    ):
        yield Comparison(
            PIECE, text, peer, partial(ours, given), call, faster=faster, repeats=REPEATS, parts=spent
        )


def ours(given: Sequence[Described]) -> list[NDArray[np.float32]]:
    """Compute the (n, 128) SIFT descriptors of the regions in each frame."""
    return [sift.describe(maps, regions) for maps, regions in given]


def theirs(points: Sequence[Sequence[Points]]) -> list[NDArray[np.float32]]:
    """Compute the (n, 128) descriptors of each frame with OpenCV, level by level."""
    descriptor = cv2.SIFT.create()
    return [np.concatenate([descriptor.compute(level, some)[1] for level, some in frame]) for frame in points]


def by_kornia(patches: Sequence[NDArray[np.floating]]) -> list[NDArray[np.float32]]:
    """Compute the (n, 128) descriptors of the patches in each frame with kornia, on one thread."""
    import torch
    from kornia.feature import SIFTDescriptor

    torch.set_num_threads(1)
    descriptor = SIFTDescriptor(patch_size=patches[0].shape[1])
    with torch.inference_mode():
        return [
            descriptor(torch.from_numpy(np.ascontiguousarray(some[:, None], np.float32))).numpy()
            for some in patches
        ]


def keypoints(maps: FrameMaps, regions: NDArray[np.float32]) -> list[Points]:
    """Convert the levels to 8-bit images, and make upright keypoints whose 4x4 cells cover the regions."""
    # OpenCV's cells are 1.5 times the size of the keypoint.
    across = region_side(maps.width) / 6
    found = []
    for scale, level in maps.grey.items():
        centres = np.floor(regions[regions[:, 2] == scale, :2] / 2**scale + 0.5).tolist()
        if centres:
            found.append((to_bytes(level), [cv2.KeyPoint(x, y, across, 0) for x, y in centres]))
    return found


def parts(given: Sequence[Described]) -> dict[str, Callable[[], Any]]:
    """Create a function for each part of our code."""
    cell = region_side(given[0][0].width) / sift.CELLS
    radius = int(np.ceil((sift.CELLS + 1) / 2 * cell)) - 1
    upright = np.zeros(1)
    patches = [cut(maps.grey, regions, 2 * radius + 3) for maps, regions in given]
    gradients = [sift._gradients(some) for some in patches]
    votes = [sift._votes(*one, upright) for one in gradients]
    weights = sift._upright_weights(radius, cell)
    histograms = [(weights @ some).reshape(len(some), -1) for some in votes]
    return {
        "cutting": lambda: [cut(maps.grey, regions, 2 * radius + 3) for maps, regions in given],
        "gradients": lambda: [sift._gradients(some) for some in patches],
        "votes for bins": lambda: [sift._votes(*one, upright) for one in gradients],
        "sums in cells": lambda: [weights @ some for some in votes],
        "normalising": lambda: [sift._normalised(some) for some in histograms],
    }
