"""Render the frames of a walk that show one panorama."""

from pathlib import Path

import cv2
import numpy as np
from numpy.typing import NDArray

from placecat.errors import PlacecatError
from placecat.footage.pictures import read_image
from placecat.panoramas import cube, sphere
from placecat.panoramas.rays import focal_length, view_rays


def render(
    files: tuple[Path, ...], origin: str, path: NDArray[np.float64], width: int, height: int, quality: int
) -> list[bytes]:
    """Render views of a panorama; return each as the content of a JPEG file.

    Parameters
    ----------
    files
        One equirectangular picture, or six faces of a cube in the order of `placecat.panoramas.cube.FACES`.
    origin
        The place that lists the files, for messages.
    path
        (frames, 3) float64: pan, tilt and horizontal field of view in degrees.
    width, height, quality
        Frame size in pixels, and JPEG quality from 1 to 100.

    Raises
    ------
    PlacecatError
        If a picture cannot be read, an equirectangular picture is not 2:1, or the faces are not squares of
        the same size.
    """
    pictures = [read_image(file) for file in files]
    focal = focal_length(float(path[:, 2].min()), width)
    if len(pictures) == 1:
        size = pictures[0].shape[:2]
        if not sphere.fits(*size):
            raise PlacecatError(
                f"{files[0]}: {size[1]}x{size[0]} is not a whole sphere, which is twice as wide as high "
                f"({origin}); export it as an equirectangular picture."
            )
        prepared, look = sphere.prepare(pictures[0], focal), sphere.look
    else:
        side = len(pictures[0])
        for file, picture in zip(files, pictures, strict=True):
            if picture.shape[:2] != (side, side):
                raise PlacecatError(
                    f"{file}: {picture.shape[1]}x{picture.shape[0]} is not a face of a cube of "
                    f"{side}x{side} ({origin})."
                )
        prepared, look = cube.prepare(pictures, focal), cube.look
    return [
        _jpeg(look(prepared, view_rays(pan, tilt, fov, width, height)), quality) for pan, tilt, fov in path
    ]


def _jpeg(frame: NDArray[np.uint8], quality: int) -> bytes:
    return cv2.imencode(".jpg", frame, [cv2.IMWRITE_JPEG_QUALITY, quality])[1].tobytes()
