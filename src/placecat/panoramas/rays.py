"""Directions of a view's pixels, for a pinhole camera that turns on the spot.

Directions are (x, y, z): x to the right, y down, z ahead, as seen from a camera at zero pan and tilt.
"""

import numpy as np
from numpy.typing import NDArray


def focal_length(fov: float, width: int) -> float:
    """Return the focal length, in pixels, of a view that is `width` pixels wide.

    `fov` is the horizontal field of view in degrees, above 0 and below 180.

    Examples
    --------
    >>> round(focal_length(90.0, 640), 6)
    320.0
    """
    return float(width / 2 / np.tan(np.radians(fov) / 2))


def view_rays(pan: float, tilt: float, fov: float, width: int, height: int) -> NDArray[np.float64]:
    """Return the direction of each pixel's centre, as (height, width, 3) float64, not normalized.

    `pan`, positive to the right, and `tilt`, positive upwards, are in degrees; `fov` is as for
    :func:`focal_length`. Pixels are square, and the optical axis passes through the view's centre.

    Examples
    --------
    A view of one pixel looks along the optical axis, here to the right and then straight up.

    >>> view_rays(90.0, 0.0, 60.0, 1, 1).round(6).ravel().tolist()
    [1.0, 0.0, 0.0]
    >>> (view_rays(0.0, 90.0, 60.0, 1, 1).round(6) + 0.0).ravel().tolist()
    [0.0, -1.0, 0.0]
    """
    focal = focal_length(fov, width)
    across = (np.arange(width) + 0.5 - width / 2) / focal
    down = ((np.arange(height) + 0.5 - height / 2) / focal)[:, None]
    sin, cos = np.sin(np.radians(tilt)), np.cos(np.radians(tilt))
    y, ahead = down * cos - sin, down * sin + cos
    sin, cos = np.sin(np.radians(pan)), np.cos(np.radians(pan))
    x, z = across * cos + ahead * sin, ahead * cos - across * sin
    return np.stack(np.broadcast_arrays(x, y, z), axis=-1)
