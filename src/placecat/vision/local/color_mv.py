"""The means and variances of the colour channels in salient regions."""

from typing import Annotated

import numpy as np
from numpy.typing import NDArray

from placecat.ranges import Index, OneOf
from placecat.vision.grid import mean_variance
from placecat.vision.maps import FrameMaps
from placecat.vision.patches import BORDERS, cut, region_side

SPREAD = 2.5
MAPS = ("color",)


def describe(
    maps: FrameMaps,
    regions: NDArray[np.float32],
    *,
    grid: Index = 3,
    border: Annotated[str, OneOf(BORDERS)] = "replicate",
) -> NDArray[np.float32]:
    """Describe regions by the means and variances of the channels R, G, B, Y (thesis 3.1.2).

    `grid` is the number of cells along each axis, or 0 for the whole region only. The thesis uses 3. A
    variant in thesis 4.4.2 uses 0, which yields 8 dimensions.

    Returns (n, 8 (1 + grid**2)) float32. The whole region comes first, then the cells row by row from the top
    left. Each of these areas contributes 4 means, then 4 variances (>= 0). All cells have the same size, so
    cell borders may cut through pixels.
    """
    return mean_variance(cut(maps.color, regions, region_side(maps.width), border=border), grid)
