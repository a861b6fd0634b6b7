"""The CENTRIST descriptor of a frame: census histograms in the cells of a grid."""

from functools import partial
from typing import Annotated

import cv2
import numpy as np
from numpy.typing import NDArray

from placecat.ranges import OneOf, Pixels
from placecat.vision.census import LAPLACIANS, cell_histograms, census, laplacian
from placecat.vision.color import reduced_grey
from placecat.vision.maps import FrameMaps

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
    """Describe a frame by the census histograms of its Laplacian over a 4x4 grid (thesis 3.2, 4.3).

    Parameters
    ----------
    frame
        (H, W, 3) uint8 BGR. It is converted to grey with OpenCV's weights, 0.299 r + 0.587 g + 0.114 b. The
        thesis does not specify this.
    maps
        Used only to cache the resized image, so that variants can share it. No map is read.
    width
        Width to which the frame is reduced, preserving its aspect ratio. A narrower frame is unchanged. None
        keeps the full size (a variant in thesis 4.3).
    image
        The image to transform: ``laplacian``, or ``intensity`` (a variant in thesis 4.3).
    kernel
        The kernel of the Laplacian (see `placecat.vision.census.laplacian`).
    interpolation
        How to scale the frame down: ``area`` or ``linear``. The thesis does not specify this.

    Returns
    -------
    (4096,) float32, with a histogram of 256 codes for each of the 16 cells, row by row from the top left.
    Each histogram sums to 1. The thesis does not specify the normalisation. The grid covers only pixels that
    have a code.

    Raises
    ------
    PlacecatError
        If the frame is too small for any pixel to have a code.

    References
    ----------
    Wu and Rehg, CENTRIST: a visual descriptor for scene categorization, PAMI 2011.
    """
    reduce = partial(reduced_grey, frame, width, INTERPOLATIONS[interpolation])
    grey = maps.remembered(("grey", width, interpolation), reduce)
    values = laplacian(grey, kernel) if image == "laplacian" else grey
    return cell_histograms(census(values), CELLS).reshape(-1)
