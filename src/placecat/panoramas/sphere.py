"""Render views of an equirectangular panorama.

Columns are longitudes, rows are latitudes, and the centre is straight ahead.
"""

import cv2
import numpy as np
from numpy.typing import NDArray

# Number of pixels added on every side for interpolation across the seam and the poles.
_BORDER = 1


def prepare(picture: NDArray[np.uint8], focal: float) -> NDArray[np.uint8]:
    """Prepare a panorama, (H, 2 H, 3) uint8, for :func:`look`.

    `focal` is the largest focal length of the views, in pixels. A panorama is scaled down if its angular
    resolution is finer than that at the centre of such a view, because bilinear interpolation alone would
    skip pixels. Returns (H' + 2, 2 H' + 2, 3) uint8: the panorama with a border.
    """
    side = int(np.ceil(np.pi * focal))
    if side < len(picture):
        picture = cv2.resize(picture, (2 * side, side), interpolation=cv2.INTER_AREA)  # type: ignore[assignment]
    # Across a pole, the image continues in the same row, half a turn away.
    half = picture.shape[1] // 2
    rows = [np.roll(picture[:1], half, axis=1), picture, np.roll(picture[-1:], half, axis=1)]
    whole = np.concatenate(rows)
    return np.concatenate([whole[:, -_BORDER:], whole, whole[:, :_BORDER]], axis=1)


def look(prepared: NDArray[np.uint8], rays: NDArray[np.float64]) -> NDArray[np.uint8]:
    """Render the view along the given rays with bilinear interpolation; return (h, w, 3) uint8.

    `prepared` comes from :func:`prepare`, and `rays`, (h, w, 3), from `placecat.panoramas.render.view_rays`.
    """
    height, width = (size - 2 * _BORDER for size in prepared.shape[:2])
    x, y, z = np.moveaxis(rays, -1, 0)
    columns = (np.arctan2(x, z) / (2 * np.pi) + 0.5) * width - 0.5 + _BORDER
    rows = (np.arctan2(y, np.hypot(x, z)) / np.pi + 0.5) * height - 0.5 + _BORDER
    return cv2.remap(  # type: ignore[return-value]
        prepared, columns.astype(np.float32), rows.astype(np.float32), cv2.INTER_LINEAR
    )
