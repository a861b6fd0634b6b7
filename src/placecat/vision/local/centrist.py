"""The CENTRIST descriptor of salient regions: one census histogram per region."""

from typing import Annotated

import numpy as np
from numpy.typing import NDArray

from placecat.ranges import OneOf
from placecat.vision.census import LAPLACIANS, census, histograms
from placecat.vision.maps import FrameMaps
from placecat.vision.patches import BORDERS, cut, region_side, to_bytes

SPREAD = 0.3
MAPS = ("grey",)

IMAGES = ("intensity", "laplacian")


def describe(
    maps: FrameMaps,
    regions: NDArray[np.float32],
    *,
    image: Annotated[str, OneOf(IMAGES)] = "intensity",
    kernel: Annotated[str, OneOf(LAPLACIANS)] = "cross",
    quantise: bool = True,
    border: Annotated[str, OneOf(BORDERS)] = "replicate",
) -> NDArray[np.float32]:
    """Describe each region by the histogram of its census codes (thesis 3.1.2).

    Parameters
    ----------
    image
        The image to transform: ``intensity``, as in the thesis, or ``laplacian``, a variant that the thesis
        mentions.
    kernel
        The kernel of the Laplacian (see `placecat.vision.census.laplacian`).
    quantise
        Whether to round intensities to integer grey levels first, as in an 8-bit image. Flat areas then
        produce ties instead of noise. The thesis does not specify this.

    Returns
    -------
    (n, 256) float32. Each row sums to 1, which the thesis does not specify. Only pixels whose neighbours are
    all inside the patch have a code. Adding an integer to all intensities does not change the result.

    References
    ----------
    Wu and Rehg, CENTRIST: a visual descriptor for scene categorization, PAMI 2011.
    """
    filtered = image == "laplacian"
    # Add one pixel on each side, so that every pixel of the patch has real neighbours.
    patches = cut(maps.grey, regions, region_side(maps.width) + 2 * filtered, border=border)
    values = to_bytes(patches).astype(np.int16) if quantise else patches
    return histograms(census(_laplacians(values, kernel) if filtered else values))


def _laplacians(patches: NDArray[np.generic], kernel: str) -> NDArray[np.generic]:
    """Return the (n, h - 2, w - 2) Laplacians of (n, h, w) patches. Borders are dropped."""
    height, width = patches.shape[1] - 2, patches.shape[2] - 2
    total = np.zeros((len(patches), height, width), patches.dtype)
    for (down, right), weight in np.ndenumerate(LAPLACIANS[kernel].astype(patches.dtype)):
        if weight:
            total += weight * patches[:, down : down + height, right : right + width]
    return total
