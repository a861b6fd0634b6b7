"""CENTRIST of a frame: census histograms in the cells of a grid."""

from typing import Annotated, Any

import cv2
import numpy as np
from numpy.typing import NDArray

from placecat.errors import PlacecatError
from placecat.ranges import OneOf, Pixels
from placecat.vision.census import LAPLACIANS, cell_histograms, census, check_kernel, laplacian
from placecat.vision.maps import FrameMaps

# The fields of `FrameMaps` that this module reads.
MAPS: tuple[str, ...] = ()

CELLS = 4
IMAGES = ("laplacian", "intensity")
INTERPOLATIONS = {"area": cv2.INTER_AREA, "linear": cv2.INTER_LINEAR}


def describe(
    frame: NDArray[np.uint8],
    maps: FrameMaps,
    *,
    width: Pixels | None = 320,
    image: Annotated[str, OneOf(IMAGES)] = "laplacian",
    kernel: Annotated[str, OneOf(LAPLACIANS)] = "cross",
    interpolation: Annotated[str, OneOf(INTERPOLATIONS)] = "area",
) -> NDArray[np.float32]:
    """Describe a frame by the census histograms of its Laplacian in a 4x4 grid (thesis 3.2, 4.3).

    Parameters
    ----------
    frame
        (H, W, 3) uint8 BGR. It is converted to grey like in OpenCV, 0.299 r + 0.587 g + 0.114 b (not given in
        the thesis).
    maps
        Cache of the resized image, shared by variants; no map is used.
    width
        Reduce the frame to this width, in proportion; a narrower frame is unchanged. None for the full size
        (variant in thesis 4.3).
    image
        The image to transform: ``laplacian``, or ``intensity`` (variant in thesis 4.3).
    kernel
        Kernel of the Laplacian, as in `placecat.vision.census.laplacian`.
    interpolation
        ``area`` or ``linear``, used to reduce the frame. The thesis does not give this.

    Returns
    -------
    (4096,) float32: the 16 cells row by row from the top left, each a histogram of 256 codes with sum 1 (the
    thesis does not give the normalisation). The cells divide the pixels that have a code.

    Raises
    ------
    PlacecatError
        For an unknown image, kernel or interpolation, a width below 16, or a frame without a pixel that
        has a code.

    References
    ----------
    Wu and Rehg, CENTRIST: a visual descriptor for scene categorization, PAMI 2011.
    """
    owner = "holistic descriptor 'centrist'"
    if image not in IMAGES:
        raise PlacecatError(f"Unknown image '{image}' of {owner}: choose one of {', '.join(IMAGES)}.")
    if interpolation not in INTERPOLATIONS:
        valid = ", ".join(INTERPOLATIONS)
        raise PlacecatError(f"Unknown interpolation '{interpolation}' of {owner}: choose one of {valid}.")
    if width is not None and width < 16:
        raise PlacecatError(f"The width {width} of {owner} is too small: it must be at least 16, or null.")
    check_kernel(kernel)
    grey = maps.once(_grey, frame)
    if width is not None and width < frame.shape[1]:
        grey = maps.once(_reduced, grey, width, INTERPOLATIONS[interpolation])
    values = laplacian(grey, kernel) if image == "laplacian" else grey
    return cell_histograms(census(values), CELLS).reshape(-1)


def _grey(frame: NDArray[np.uint8]) -> NDArray[Any]:
    return cv2.cvtColor(frame, cv2.COLOR_BGR2GRAY)


def _reduced(grey: NDArray[np.uint8], width: int, interpolation: int) -> NDArray[Any]:
    height, full = grey.shape
    return cv2.resize(grey, (width, max(1, round(height * width / full))), interpolation=interpolation)
