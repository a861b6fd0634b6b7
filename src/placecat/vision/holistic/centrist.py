"""A frame's CENTRIST: census histograms in the cells of a grid."""

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
    """Describe a frame by the census histograms of its Laplacian in a 4x4 grid (thesis 3.2, 4.3).

    Parameters
    ----------
    frame
        (H, W, 3) uint8 BGR, converted to grey as OpenCV does, 0.299 r + 0.587 g + 0.114 b (not specified in
        the thesis).
    maps
        Caches the resized image, so that variants share it; no map is used.
    width
        Width to which the frame is reduced, with its aspect ratio preserved; a narrower frame is unchanged.
        None for the full size (a variant in thesis 4.3).
    image
        The image to transform: ``laplacian``, or ``intensity`` (a variant in thesis 4.3).
    kernel
        The Laplacian's kernel, as in `placecat.vision.census.laplacian`.
    interpolation
        How to reduce the frame: ``area`` or ``linear``. The thesis does not specify this.

    Returns
    -------
    (4096,) float32: a histogram of 256 codes for each of the 16 cells, row by row from the top left. Each
    histogram sums to 1 (the thesis does not specify the normalisation). The cells divide the pixels that have
    a code.

    Raises
    ------
    PlacecatError
        If no pixel of the frame has a code.

    References
    ----------
    Wu and Rehg, CENTRIST: a visual descriptor for scene categorization, PAMI 2011.
    """
    reduce = partial(reduced_grey, frame, width, INTERPOLATIONS[interpolation])
    grey = maps.remembered(("grey", width, interpolation), reduce)
    values = laplacian(grey, kernel) if image == "laplacian" else grey
    return cell_histograms(census(values), CELLS).reshape(-1)
