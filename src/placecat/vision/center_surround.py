"""Centre-surround responses (thesis 3.1.1.1)."""

from collections.abc import Sequence

import cv2
import numpy as np

from placecat.vision.color import blue_yellow
from placecat.vision.maps import FloatArray

# Responses up to these are rounding of float32, which would give flat areas local maxima.
GREY_ROUNDING = 1e-3
COLOR_ROUNDING = 1e-5


def surround_difference(plane: FloatArray, radius: int) -> FloatArray:
    """Subtract from each pixel the mean of the pixels around it.

    The neighbourhood has k x k pixels, k = 2 radius + 1; the centre is not part of its surround. With the
    mean m of all k^2 pixels the difference is (centre - m) k^2 / (k^2 - 1), so a box blur does it. The border
    is mirrored without repeating the edge pixel (reflect-101; the thesis does not give this).

    Parameters
    ----------
    plane
        (h, w) float32.
    radius
        1 for 3x3, 3 for 7x7.

    Returns
    -------
    ndarray
        (h, w) float32, signed, in the units of `plane`.
    """
    size = 2 * radius + 1
    mean = cv2.blur(plane, (size, size), borderType=cv2.BORDER_REFLECT_101)
    factor = size**2 / (size**2 - 1)
    cv2.addWeighted(plane, factor, mean, -factor, 0, dst=mean)
    return np.asarray(mean, np.float32)


def intensity_contrast(grey: FloatArray, radii: Sequence[int] = (1, 3)) -> FloatArray:
    """Return the bright-spot and dark-spot responses of the intensity (thesis 3.1.1.1).

    Parameters
    ----------
    grey
        (h, w) float32, 0 to 255.
    radii
        Radii of the neighbourhoods.

    Returns
    -------
    ndarray
        (radii, 2, h, w) float32, 0 to 255: positive part of the difference and of its opposite; up to
        `GREY_ROUNDING` counts as zero.
    """
    out = np.empty((len(radii), 2, *grey.shape), np.float32)
    for on_off, radius in zip(out, radii, strict=True):
        difference = surround_difference(grey, radius)
        _positive(difference, GREY_ROUNDING, on_off[0])
        _positive(np.negative(difference, out=difference), GREY_ROUNDING, on_off[1])
    return out


def color_contrast(planes: Sequence[FloatArray], radii: Sequence[int] = (1, 3)) -> FloatArray:
    """Return the responses of R, G, B, Y, centre above surround (thesis 3.1.1.1).

    Parameters
    ----------
    planes
        The colour planes of one level, as `placecat.vision.color.channels` takes them.
    radii
        Radii of the neighbourhoods.

    Returns
    -------
    ndarray
        (radii, 4, h, w) float32, dimensionless, >= 0; up to `COLOR_ROUNDING` counts as zero.
    """
    out = np.empty((len(radii), 4, *planes[0].shape), np.float32)
    for target, radius in zip(out, radii, strict=True):
        signed = [surround_difference(plane, radius) for plane in planes]
        if len(signed) == 3:
            red, green, difference = signed
            blue_yellow(red, green, difference, target[2], target[3])
            signed = [red, green, *target[2:]]
        for plane, positive in zip(signed, target, strict=True):
            _positive(plane, COLOR_ROUNDING, positive)
    return out


def _positive(plane: FloatArray, rounding: float, out: FloatArray) -> None:
    cv2.threshold(plane, rounding, 0, cv2.THRESH_TOZERO, dst=out)
