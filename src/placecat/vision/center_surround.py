"""Compute centre-surround responses (thesis 3.1.1.1)."""

from collections.abc import Sequence

import cv2
import numpy as np

from placecat.vision.color import blue_yellow
from placecat.vision.maps import FloatArray

# Responses up to these limits are float32 rounding errors, which would create local maxima in flat areas.
GREY_ROUNDING = 1e-3
COLOR_ROUNDING = 1e-5


def _surround_difference(plane: FloatArray, radius: int, out: FloatArray) -> None:
    """Subtract from each pixel the mean of the other pixels in its k x k neighbourhood.

    The side length k is 2 radius + 1. If m is the mean of all k^2 pixels, the difference is k^2 / (k^2 - 1)
    times (centre - m), so a box blur suffices. The border is mirrored without repeating the edge pixel
    (reflect-101). The thesis does not specify this.
    """
    size = 2 * radius + 1
    cv2.blur(plane, (size, size), dst=out, borderType=cv2.BORDER_REFLECT_101)
    factor = size**2 / (size**2 - 1)
    cv2.addWeighted(plane, factor, out, -factor, 0, dst=out)


def intensity_contrast(grey: FloatArray, radii: Sequence[int]) -> FloatArray:
    """Return the centre-surround responses to bright and dark spots (thesis 3.1.1.1).

    `grey` is (h, w) float32, from 0 to 255, and `radii` are the radii of the centre-surround neighbourhoods.
    Returns (radii, 2, h, w) float32, from 0 to 255: how far the centre lies above and how far it lies below
    the surround. Values up to `GREY_ROUNDING` are set to 0.
    """
    out = np.empty((len(radii), 2, *grey.shape), np.float32)
    for (on, off), radius in zip(out, radii, strict=True):
        _surround_difference(grey, radius, on)
        np.negative(on, out=off)
    return without_rounding(out, GREY_ROUNDING)


def color_contrast(planes: Sequence[FloatArray], radii: Sequence[int]) -> FloatArray:
    """Return by how much R, G, B and Y in the centre exceed the surround (thesis 3.1.1.1).

    `planes` are the colour planes of one level, as in `placecat.vision.color.channels`. Returns
    (radii, 4, h, w) float32. The values are dimensionless and non-negative. Values up to `COLOR_ROUNDING` are
    set to 0.
    """
    out = np.empty((len(radii), 4, *planes[0].shape), np.float32)
    difference = np.empty_like(planes[0])
    for target, radius in zip(out, radii, strict=True):
        # With three planes, the third and fourth channels are computed together.
        for plane, own in zip(planes, target if len(planes) == 4 else (*target[:2], difference), strict=True):
            _surround_difference(plane, radius, own)
        if len(planes) == 3:
            blue_yellow(target[0], target[1], difference, target[2], target[3])
    return without_rounding(out, COLOR_ROUNDING)


def without_rounding(maps: FloatArray, rounding: float) -> FloatArray:
    """Set values up to `rounding` to 0, in place."""
    rows = maps.reshape(-1, maps.shape[-1])
    cv2.threshold(rows, rounding, 0, cv2.THRESH_TOZERO, dst=rows)
    return maps
