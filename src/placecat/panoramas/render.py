"""Render the frames that show one panorama, as seen by a pinhole camera that turns on the spot.

Directions are (x, y, z): x to the right, y down, z forward, as seen from a camera at zero pan and tilt.
"""

from pathlib import Path

import cv2
import numpy as np
from numpy.typing import NDArray

from placecat.errors import PlacecatError
from placecat.footage.pictures import read_image
from placecat.panoramas import cube, sphere


def render(
    files: tuple[Path, ...], origin: str, path: NDArray[np.float64], width: int, height: int, quality: int
) -> list[bytes]:
    """Render views of a panorama; return each as the content of a JPEG file.

    Raises PlacecatError if an image cannot be read, if an equirectangular image is not twice as wide as it
    is high, or if the faces are not squares of the same size.

    Parameters
    ----------
    files, origin
        The fields of `placecat.panoramas.panorama.Panorama`, but with full paths.
    path
        (frames, 3) float64: pan, tilt and horizontal field of view in degrees.
    width, height, quality
        Frame size in pixels, and JPEG quality from 1 to 100.
    """
    pictures = [read_image(file) for file in files]
    focal = focal_length(float(path[:, 2].min()), width)
    if len(pictures) == 1:
        rows, columns = pictures[0].shape[:2]
        if columns != 2 * rows:
            raise PlacecatError(
                f"{files[0]}: the image is {columns}x{rows}, but a full sphere must be twice as wide as "
                f"it is high ({origin}); export it as an equirectangular image."
            )
        prepared, look = sphere.prepare(pictures[0], focal), sphere.look
    else:
        side = len(pictures[0])
        for file, picture in zip(files, pictures, strict=True):
            if picture.shape[:2] != (side, side):
                raise PlacecatError(
                    f"{file} is {picture.shape[1]}x{picture.shape[0]}, but all faces of this cube must be "
                    f"{side}x{side} ({origin}); replace it."
                )
        prepared, look = cube.prepare(pictures, focal), cube.look
    views = (look(prepared, view_rays(pan, tilt, fov, width, height)) for pan, tilt, fov in path)
    return [cv2.imencode(".jpg", view, [cv2.IMWRITE_JPEG_QUALITY, quality])[1].tobytes() for view in views]


def focal_length(fov: float, width: int) -> float:
    """Return the focal length, in pixels, of a view that is `width` pixels wide.

    `fov` is the horizontal field of view in degrees, between 0 and 180 (exclusive).

    Examples
    --------
    >>> round(focal_length(90.0, 640), 6)
    320.0
    """
    return float(width / 2 / np.tan(np.radians(fov) / 2))


def view_rays(pan: float, tilt: float, fov: float, width: int, height: int) -> NDArray[np.float64]:
    """Return the unnormalised direction of each pixel centre, (height, width, 3) float64.

    `pan`, positive to the right, and `tilt`, positive upwards, are in degrees. See :func:`focal_length` for
    `fov`. Pixels are square, and the optical axis passes through the centre of the view.

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
