"""Pretrained networks that compute image features.

Each network imports its packages when it is loaded. Nothing is downloaded. The weights come from a package,
or from a file specified in the settings.
"""

from collections.abc import Callable
from functools import lru_cache
from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from placecat.errors import PlacecatError
from placecat.vision.networks import efficientnet_lite, onnx_file

#: Maps a (1, 3, height, width) float32 image to features of any shape. The first axis is the image.
Network = Callable[[NDArray[np.float32]], NDArray[np.float32]]

NAMED = tuple(efficientnet_lite.WEIGHTS)
ENDING = ".onnx"


class Preparation(NamedTuple):
    """How to prepare an image: the size in pixels, and the mean and std of red, green and blue (0 to 1)."""

    width: int
    height: int
    mean: tuple[float, ...]
    std: tuple[float, ...]


# Most networks trained on ImageNet expect these values. They are assumed for ONNX files, which do not specify
# any.
_IMAGENET = Preparation(224, 224, (0.485, 0.456, 0.406), (0.229, 0.224, 0.225))


def preparation(network: str) -> Preparation:
    """Return how the training images of a network were prepared.

    For an ONNX file, ImageNet's values are assumed.
    """
    if network not in NAMED:
        return _IMAGENET
    side = efficientnet_lite.WEIGHTS[network].side
    return Preparation(side, side, efficientnet_lite.MEAN, efficientnet_lite.STD)


@lru_cache(maxsize=4)
def load(network: str, output: str | None = None, sha256: str | None = None) -> Network:
    """Load a network once per process.

    `network` is one of `NAMED` or the path of an ONNX file. See `onnx_file.load` for `output` and `sha256`.
    Raises PlacecatError if the network is unknown, if its packages or its file are missing, or if the file
    cannot be used.
    """
    if network.endswith(ENDING):
        return onnx_file.load(Path(network), output, sha256)
    if network not in NAMED:
        raise PlacecatError(
            f"the network {network!r} is unknown: use {', '.join(NAMED)}, or the path of an ONNX file "
            f"({ENDING})"
        )
    for name, value in (("output", output), ("sha256", sha256)):
        if value is not None:
            raise PlacecatError(
                f"{name} applies only to ONNX files: set it to null for the network {network}"
            )
    return efficientnet_lite.load(network)
