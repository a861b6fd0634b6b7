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

# Patches per row of a mosaic, few enough for the cache.
_COLUMNS = 5


def describe(
    maps: FrameMaps,
    regions: NDArray[np.float32],
    *,
    interpolation: Annotated[str, OneOf(INTERPOLATIONS)] = "linear",
    border: Annotated[str, OneOf(BORDERS)] = "replicate",
) -> NDArray[np.float32]:
    """Describe regions by OpenCV's HOG: window 64, block 64, stride 32, cell 16, 8 bins (thesis 3.1.2).

    Each intensity patch, in whole grey levels, is resized to 64x64. The result equals
    `cv2.HOGDescriptor.compute` on each patch, but one call handles all patches, placed side by side with
    mirrored borders.

    `interpolation` is the method of resizing; the thesis does not specify this.

    Returns
    -------
    (n, 128) float32 in [0, 1]: the columns from the left, each column's 4 cells from the top, each cell's 8
    bins over 180 degrees. L2-Hys normalised; 0 for a patch without gradients.

    References
    ----------
    Dalal and Triggs, Histograms of oriented gradients for human detection, CVPR 2005.
    """
    patches = to_bytes(cut(maps.grey, regions, region_side(maps.width), border=border))
    if not len(patches):
        return np.zeros((0, _SIZE), np.float32)
    return _mosaic_hog(patches, INTERPOLATIONS[interpolation])


def _mosaic_hog(patches: NDArray[np.uint8], interpolation: int) -> NDArray[Any]:
    """Compute HOG on (n, side, side) patches in one mosaic; each is resized and framed by mirrored pixels."""
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
