"""Embedding of a frame, computed by a pretrained network (not in the thesis)."""

from collections.abc import Sequence
from typing import Annotated

import cv2
import numpy as np
from annotated_types import Len
from numpy.typing import NDArray

from placecat.errors import PlacecatError
from placecat.ranges import NonNegative, OneOf, Positive, Side
from placecat.vision import networks
from placecat.vision.maps import FrameMaps
from placecat.vision.networks import efficientnet_lite

MAPS: tuple[str, ...] = ()
# Packages that this module imports by default. All belong to the `deep` extra.
PACKAGES = efficientnet_lite.PACKAGES

_OWNER = "holistic descriptor 'embedding'"
POOLS = ("mean", "first")


def describe(
    frame: NDArray[np.uint8],
    maps: FrameMaps,
    *,
    network: str = "efficientnet_lite1",
    width: Side | None = None,
    height: Side | None = None,
    mean: Annotated[Sequence[NonNegative], Len(3, 3)] | None = None,
    std: Annotated[Sequence[Positive], Len(3, 3)] | None = None,
    output: str | None = None,
    pool: Annotated[str, OneOf(POOLS)] | None = None,
    sha256: str | None = None,
) -> NDArray[np.float32]:
    """Describe a frame by the pooled features of a pretrained network.

    Parameters
    ----------
    frame
        (H, W, 3) uint8 BGR. No map is used.
    network
        ``efficientnet_lite0``, ``efficientnet_lite1``, ``efficientnet_lite2``, or the path of an ONNX file
        relative to the project.
    width, height
        Size in pixels to which the frame is scaled, even if this changes its aspect ratio. If both are None,
        the network's training size is used (224x224 for an ONNX file). If only one is None, the aspect ratio
        is preserved.
    mean, std
        Values for red, green and blue, on a scale from 0 to 1. `mean` is subtracted, and the result is
        divided by `std`. None uses the values that the network was trained with or, for an ONNX file, those
        of ImageNet.
    output
        Name of the ONNX output to use, or None for the first output.
    pool
        How to turn an output with positions, (D, rows, columns), or with tokens, (tokens, D), into a vector.
        ``mean`` averages over all of them, and ``first`` takes the first token. None means that the output is
        already a vector.
    sha256
        The required checksum of the ONNX file in hexadecimal, or None to accept any file. Without a checksum,
        the stages do not detect changes to the file.

    Returns
    -------
    (size,) float32, the output of the network, pooled if `pool` is set.

    Raises
    ------
    PlacecatError
        If the network or a package is missing, if a setting does not suit the network, or if the network
        rejects the image or fails to return a vector of finite numbers.
    """
    rows, columns = frame.shape[:2]
    own = networks.preparation(network)
    if width is not None and height is None:
        height = max(1, round(width * rows / columns))
    elif width is None and height is not None:
        width = max(1, round(height * columns / rows))
    size = width or own.width, height or own.height
    scaled = cv2.resize(frame, size, interpolation=cv2.INTER_AREA)
    rgb = scaled[:, :, ::-1].astype(np.float32) / np.float32(255)
    normal = (rgb - np.array(mean or own.mean, np.float32)) / np.array(std or own.std, np.float32)
    image = np.ascontiguousarray(normal.transpose(2, 0, 1)[None], np.float32)
    try:
        features = networks.load(network, output, sha256)(image)
    except PlacecatError as error:
        raise PlacecatError(f"{_OWNER}: {error}") from None
    if features.ndim < 1 or len(features) != 1:
        raise PlacecatError(
            f"{_OWNER}: {network} returns an array of shape {features.shape} for one image, not (1, ...)"
        )
    return _vector(features[0], network, pool)


def _vector(features: NDArray[np.float32], network: str, pool: str | None) -> NDArray[np.float32]:
    if features.ndim == 3 and pool == "mean":
        features = features.mean(axis=(1, 2))
    elif features.ndim == 2 and pool == "mean":
        features = features.mean(axis=0)
    elif features.ndim == 2 and pool == "first" and len(features):
        features = features[0]
    if features.ndim != 1 or not len(features):
        how = {2: "set pool to mean or first", 3: "set pool to mean"}.get(
            features.ndim, "use another network"
        )
        raise PlacecatError(
            f"{_OWNER}: {network} returns an array of shape {features.shape} for a frame, not a vector: "
            f"{how}, or choose another output"
        )
    if not np.isfinite(features).all():
        raise PlacecatError(f"{_OWNER}: {network} returns numbers that are not finite: check mean and std")
    return np.ascontiguousarray(features, np.float32)
