"""Embedding: a pretrained network's features of a frame (not in the thesis)."""

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

# The fields of `FrameMaps` that this module reads.
MAPS: tuple[str, ...] = ()
# Packages that this module imports by default, all from the extra `deep`.
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
    """Describe a frame by a pretrained network's pooled features.

    Parameters
    ----------
    frame
        (H, W, 3) uint8 BGR.
    maps
        Not used.
    network
        ``efficientnet_lite0``, ``1`` or ``2``, or an ONNX file's path, relative to the project.
    width, height
        Size in pixels to which the frame is scaled, even if this changes its aspect ratio. If both are None,
        the network's training size is used (224x224 for an ONNX file). If one is None, the aspect ratio is
        preserved.
    mean, std
        Values for red, green and blue, on a scale from 0 to 1: `mean` is subtracted, then the result is
        divided by `std`. None for the values used to train the network (ImageNet's for an ONNX file).
    output
        Name of the ONNX file's output to use; None for the first.
    pool
        How to turn an output with positions, (D, rows, columns), or tokens, (tokens, D), into a vector: the
        ``mean`` over all of them, or the ``first`` token. None if the output is already a vector.
    sha256
        The ONNX file's required checksum, in hexadecimal; None accepts any. Without a checksum, the stages do
        not notice if the file changes.

    Returns
    -------
    (size,) float32, the network's output, after pooling if `pool` is set.

    Raises
    ------
    PlacecatError
        If a setting is invalid, if the network or a package is missing, or if the network rejects the image
        or does not return a vector of finite numbers.
    """
    image = _input(frame, _prepared(frame, networks.preparation(network), width, height, mean, std))
    return _vector(_features(image, network, output, sha256), network, pool)


def _prepared(
    frame: NDArray[np.uint8],
    own: networks.Preparation,
    width: int | None,
    height: int | None,
    mean: Sequence[float] | None,
    std: Sequence[float] | None,
) -> networks.Preparation:
    """Return how to prepare a frame, filling in missing settings with the network's defaults."""
    if min(width or 1, height or 1) < 1 or 0 in (width, height):
        raise PlacecatError(f"The width and height of {_OWNER} must be at least 1, not {width} and {height}.")
    if mean is not None and len(mean) != 3:
        raise PlacecatError(f"The mean of {_OWNER} must be three numbers, not {list(mean)}.")
    if std is not None and (len(std) != 3 or min(std) <= 0):
        raise PlacecatError(f"The std of {_OWNER} must be three positive numbers, not {list(std)}.")
    rows, columns = frame.shape[:2]
    if width is None and height is None:
        width, height = own.width, own.height
    elif width is None:
        assert height is not None
        width = max(1, round(height * columns / rows))
    elif height is None:
        height = max(1, round(width * rows / columns))
    return networks.Preparation(
        width, height, own.mean if mean is None else tuple(mean), own.std if std is None else tuple(std)
    )


def _input(frame: NDArray[np.uint8], prepared: networks.Preparation) -> NDArray[np.float32]:
    """Convert the frame to (1, 3, height, width) float32 RGB."""
    scaled = cv2.resize(frame, (prepared.width, prepared.height), interpolation=cv2.INTER_AREA)
    rgb = scaled[:, :, ::-1].astype(np.float32) / np.float32(255)
    normal = (rgb - np.array(prepared.mean, np.float32)) / np.array(prepared.std, np.float32)
    return np.ascontiguousarray(normal.transpose(2, 0, 1)[None])


def _features(
    image: NDArray[np.float32], network: str, output: str | None, sha256: str | None
) -> NDArray[np.float32]:
    """Return the network's output for one image, without the image axis."""
    try:
        features = networks.load(network, output, sha256)(image)
    except PlacecatError as error:
        raise PlacecatError(f"{_OWNER}: {error}") from None
    if features.ndim < 1 or len(features) != 1:
        raise PlacecatError(f"{_OWNER}: {network} gives {features.shape} for one image, not (1, ...)")
    only: NDArray[np.float32] = features[0]
    return only


def _vector(features: NDArray[np.float32], network: str, pool: str | None) -> NDArray[np.float32]:
    if pool is not None and pool not in POOLS:
        raise PlacecatError(f"Unknown pool '{pool}' of {_OWNER}: choose one of {', '.join(POOLS)}, or null.")
    if features.ndim == 3 and pool == "mean":
        features = features.mean(axis=(1, 2))
    elif features.ndim == 2 and pool == "mean":
        features = features.mean(axis=0)
    elif features.ndim == 2 and pool == "first" and len(features):
        features = features[0]
    if features.ndim != 1 or not len(features):
        how = {2: "set pool to mean or first", 3: "set pool to mean"}.get(features.ndim, "it cannot be used")
        raise PlacecatError(
            f"{_OWNER}: {network} gives {features.shape} for a frame, not a vector: "
            f"{how}, or name another output"
        )
    if not np.isfinite(features).all():
        raise PlacecatError(f"{_OWNER}: {network} returns numbers that are not finite: check mean and std")
    return np.ascontiguousarray(features, np.float32)
