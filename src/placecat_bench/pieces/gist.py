"""Gist descriptor of a frame, including the maps that our code needs, compared with torchgist.

Our code averages visual attention maps over the cells of a grid (thesis section 3.2), while torchgist applies
32 Gabor filters to a 256x256 greyscale image (Oliva and Torralba 2001). The descriptors differ but serve the
same purpose.
"""

from collections.abc import Iterator, Sequence
from typing import Any

import cv2
import numpy as np
from numpy.typing import NDArray

from placecat.vision.attention import compute_maps
from placecat.vision.holistic import gist
from placecat_bench.comparison import TORCH, Comparison, Peer
from placecat_bench.frames import REPEATS, Image, options, prepared, size

PEER = Peer("torchgist: GIST", "torchgist", extra=TORCH)
_SIDE = 256


def entries(*, frames: Sequence[Image] | None = None) -> Iterator[Comparison]:
    """Yield the comparison of run times, by default on one frame from each rendered home."""
    _, pictures = prepared(frames)
    attention = options()["attention"]
    maps = [compute_maps(picture, gist.MAPS, **attention) for picture in pictures]
    squares = [np.asarray(cv2.resize(picture, (_SIDE, _SIDE)), np.uint8) for picture in pictures]
    yield Comparison(
        "Gist",
        size(pictures[0]),
        PEER,
        lambda: [ours(picture, attention) for picture in pictures],
        lambda: theirs(squares),
        faster=5,
        repeats=REPEATS,
        parts={
            "maps": lambda: [compute_maps(picture, gist.MAPS, **attention) for picture in pictures],
            "means": lambda: [gist.describe(*one) for one in zip(pictures, maps, strict=True)],
        },
    )


def ours(frame: Image, attention: dict[str, Any]) -> NDArray[np.float32]:
    """Compute the maps and the Gist of a frame, and return the (D,) Gist."""
    return np.asarray(gist.describe(frame, compute_maps(frame, gist.MAPS, **attention)))


def theirs(squares: Sequence[NDArray[np.uint8]]) -> list[NDArray[np.float32]]:
    """Compute the (512,) torchgist descriptors of (256, 256, 3) images on one thread."""
    import torch
    from torchgist.models.models import GIST

    torch.set_num_threads(1)
    descriptor = GIST()
    with torch.inference_mode():
        return [
            descriptor(torch.from_numpy(some.transpose(2, 0, 1).astype(np.float32))).numpy()
            for some in squares
        ]
