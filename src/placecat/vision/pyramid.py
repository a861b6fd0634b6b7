"""Gaussian and Laplacian pyramids, and their geometry."""

import cv2
import numpy as np

from placecat.errors import PlacecatError
from placecat.vision.maps import FloatArray


def level_size(width: int, height: int, level: int) -> tuple[int, int]:
    """Return the (width, height) of a pyramid level in pixels, each ceil(n / 2**level)."""
    return -(-width >> level), -(-height >> level)


def check_scales(scales: tuple[int, ...], width: int, height: int) -> None:
    """Raise PlacecatError if a frame's coarsest level would be less than two pixels wide or high."""
    if min(level_size(width, height, scales[-1])) < 2:
        raise PlacecatError(
            f"a frame of {width}x{height} pixels is too small for the scales {scales}: its shorter side must "
            f"be at least {2 ** scales[-1] + 1} pixels long; use larger frames or omit the highest scales"
        )


def reduce(plane: FloatArray) -> FloatArray:
    """Blur with the 5x5 binomial kernel and keep every second row and column (thesis 3.1.1.1).

    An (h, w) float32 plane becomes (ceil(h / 2), ceil(w / 2)) float32. Pixel (x, y) of the result lies at
    (2x, 2y) in the input. The border is mirrored without repeating the edge pixel (reflect-101).
    """
    return np.asarray(cv2.pyrDown(plane), np.float32)


def expand(plane: FloatArray, width: int, height: int) -> FloatArray:
    """Double the size of a (ceil(height / 2), ceil(width / 2)) float32 level with the kernel of `reduce`.

    Returns (height, width) float32. Pixel (x, y) of the input moves to (2x, 2y). OpenCV mirrors the left and
    upper borders, and repeats the last pixel at the right and lower borders.
    """
    return np.asarray(cv2.pyrUp(plane, dstsize=(width, height)), np.float32)


def gaussian_pyramid(plane: FloatArray, first: int, last: int) -> dict[int, FloatArray]:
    """Repeatedly reduce an (h, w) float32 plane, which is level `first` (thesis 3.1.1.1).

    Returns a dict that maps each level from `first` to `last` to its float32 plane.
    """
    levels = {first: plane}
    for level in range(first + 1, last + 1):
        levels[level] = reduce(levels[level - 1])
    return levels


def laplacian(gaussian: dict[int, FloatArray], level: int) -> FloatArray:
    """Return one level of the approximate Laplacian pyramid (thesis 3.1.1.1).

    The signed (h, w) float32 result is the given Gaussian level minus the expanded next level, in the same
    units as the pyramid.
    """
    plane = gaussian[level]
    height, width = plane.shape
    return plane - expand(gaussian[level + 1], width, height)
