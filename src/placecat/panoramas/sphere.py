"""Views of an equirectangular panorama: columns are longitudes, rows latitudes, the middle is ahead."""

import cv2
import numpy as np
from numpy.typing import NDArray

# Pixels added on every side, so that interpolation goes on across the seam and the poles.
_BORDER = 1


def fits(height: int, width: int) -> bool:
    """Whether a picture of this size can be a whole sphere: twice as wide as high."""
    return width == 2 * height


def prepare(picture: NDArray[np.uint8], focal: float) -> NDArray[np.uint8]:
    """Make a panorama ready for :func:`look`.

    Parameters
    ----------
    picture
        (H, 2 H, 3) uint8.
    focal
        Focal length of the longest view, in pixels. A panorama with more pixels an angle than this view
        has in its middle is scaled down, since bilinear interpolation alone would skip pixels.

    Returns
    -------
    (H' + 2, 2 H' + 2, 3) uint8: what continues it on all sides is added.
    """
    side = int(np.ceil(np.pi * focal))
    if side < len(picture):
        picture = cv2.resize(picture, (2 * side, side), interpolation=cv2.INTER_AREA)  # type: ignore[assignment]
    # Beyond a pole the other half of the same row follows.
    half = picture.shape[1] // 2
    rows = [np.roll(picture[:1], half, axis=1), picture, np.roll(picture[-1:], half, axis=1)]
    whole = np.concatenate(rows)
    return np.concatenate([whole[:, -_BORDER:], whole, whole[:, :_BORDER]], axis=1)


def look(prepared: NDArray[np.uint8], rays: NDArray[np.float64]) -> NDArray[np.uint8]:
    """Give what is seen along rays, by bilinear interpolation.

    Parameters
    ----------
    prepared
        From :func:`prepare`.
    rays
        (h, w, 3) directions, as :func:`placecat.panoramas.rays.view_rays` gives them.

    Returns
    -------
    (h, w, 3) uint8.
    """
    height, width = (size - 2 * _BORDER for size in prepared.shape[:2])
    x, y, z = np.moveaxis(rays, -1, 0)
    columns = (np.arctan2(x, z) / (2 * np.pi) + 0.5) * width - 0.5 + _BORDER
    rows = (np.arctan2(y, np.hypot(x, z)) / np.pi + 0.5) * height - 0.5 + _BORDER
    return cv2.remap(  # type: ignore[return-value]
        prepared, columns.astype(np.float32), rows.astype(np.float32), cv2.INTER_LINEAR
    )
