"""The means and variances of the orientation maps in salient regions."""

from typing import Annotated

import numpy as np
from numpy.typing import NDArray

from placecat.ranges import Index, OneOf
from placecat.vision.grid import mean_variance
from placecat.vision.maps import FrameMaps
from placecat.vision.patches import BORDERS, cut, region_side

SPREAD = 65.0
MAPS = ("orientation",)


def describe(
    maps: FrameMaps,
    regions: NDArray[np.float32],
    *,
    grid: Index = 3,
    border: Annotated[str, OneOf(BORDERS)] = "replicate",
) -> NDArray[np.float32]:
    """Describe regions by the means and variances of the orientation maps (thesis 3.1.2).

    This works like `color_mv`, but with the Gabor responses at 0, 45, 90 and 135 degrees instead of colour
    channels.
    """
    return mean_variance(cut(maps.orientation, regions, region_side(maps.width), border=border), grid)
