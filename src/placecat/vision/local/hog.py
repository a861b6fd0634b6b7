"""Histograms of oriented gradients in salient regions."""

from typing import Annotated, Any

import cv2
import numpy as np
from numpy.typing import NDArray

from placecat.ranges import OneOf
from placecat.vision.maps import FrameMaps
from placecat.vision.patches import BORDERS, cut, region_side, to_bytes

SPREAD = 0.7
MAPS = ("grey",)

WINDOW = 64
INTERPOLATIONS = {"nearest": cv2.INTER_NEAREST, "linear": cv2.INTER_LINEAR, "cubic": cv2.INTER_CUBIC}

_HOG = cv2.HOGDescriptor((WINDOW, WINDOW), (64, 64), (32, 32), (16, 16), 8)
_SIZE = int(_HOG.getDescriptorSize())

# Number of patches per row of a mosaic. A mosaic of this width fits in the cache.
_COLUMNS = 5


def describe(
    maps: FrameMaps,
    regions: NDArray[np.float32],
    *,
    interpolation: Annotated[str, OneOf(INTERPOLATIONS)] = "linear",
    border: Annotated[str, OneOf(BORDERS)] = "replicate",
) -> NDArray[np.float32]:
    """Describe regions with OpenCV's HOG (thesis 3.1.2).

    The window and the block are 64 pixels wide, the stride is 32 pixels, cells are 16 pixels wide, and there
    are 8 bins. Each intensity patch is rounded to integer grey levels and resized to 64x64. The result is the
    same as calling `cv2.HOGDescriptor.compute` on each patch, but a single call handles all patches, which
    are placed side by side with mirrored borders.

    `interpolation` is the resizing method. The thesis does not specify it.

    Returns
    -------
    (n, 128) float32 in [0, 1], L2-Hys normalised. Columns of cells run from left to right. Each column has 4
    cells from top to bottom, and each cell has 8 bins over 180 degrees. All values are 0 for a patch without
    gradients.

    References
    ----------
    Dalal and Triggs, Histograms of oriented gradients for human detection, CVPR 2005.
    """
    patches = to_bytes(cut(maps.grey, regions, region_side(maps.width), border=border))
    if not len(patches):
        return np.zeros((0, _SIZE), np.float32)
    return _mosaic_hog(patches, INTERPOLATIONS[interpolation])


def _mosaic_hog(patches: NDArray[np.uint8], interpolation: int) -> NDArray[Any]:
    """Compute HOG on (n, side, side) patches, resized, padded by mirroring and tiled into one mosaic."""
    tile = WINDOW + 2
    places = [divmod(index, _COLUMNS) for index in range(len(patches))]
    mosaic = np.zeros((places[-1][0] + 1, tile, _COLUMNS, tile), np.uint8)
    for patch, (row, column) in zip(patches, places, strict=True):
        inside = mosaic[row, 1:-1, column, 1:-1]
        cv2.resize(patch, (WINDOW, WINDOW), dst=inside, interpolation=interpolation)
    mosaic[:, 0], mosaic[:, -1] = mosaic[:, 2], mosaic[:, -3]
    mosaic[..., 0], mosaic[..., -1] = mosaic[..., 2], mosaic[..., -3]
    corners = [(tile * column + 1, tile * row + 1) for row, column in places]
    found = _HOG.compute(mosaic.reshape(-1, tile * _COLUMNS), (WINDOW, WINDOW), (0, 0), corners)
    return np.asarray(found).reshape(len(patches), _SIZE)
