"""The gist of a frame: the mean of each feature map over each cell of a grid."""

from functools import partial

import numpy as np
from numpy.typing import NDArray

from placecat.vision.grid import cell_means
from placecat.vision.maps import FrameMaps

MAPS = ("grey", "color", "intensity_contrast", "color_contrast", "orientation")

CELLS = 4


def describe(
    frame: NDArray[np.uint8], maps: FrameMaps, *, color: bool = True, center_surround: bool = True
) -> NDArray[np.float32]:
    """Describe a frame by the means of its feature maps over the cells of a 4x4 grid (thesis 3.2).

    `color` adds the colour maps; thesis 4.2 has a variant without them. If `center_surround` is true, the
    centre-surround maps of intensity and colour are used. Otherwise, their pyramids are used (a variant in
    thesis 4.2). Orientation has no centre-surround maps. The frame itself is not read.

    Returns
    -------
    (size,) float32, with a block for each of the 16 cells, row by row from the top left. A block contains
    intensity (on, off), colour (R, G, B, Y) and orientation (0, 45, 90, 135 degrees). Within a channel,
    values are sorted by sub-channel, then by scale, then by radius. By default, the channels have 16, 32 and
    16 values.

    References
    ----------
    Siagian and Itti, Rapid biologically-inspired scene classification using features shared with visual
    attention, PAMI 2007.
    """
    fields = ["intensity_contrast", "color_contrast"] if center_surround else ["grey", "color"]
    blocks = []
    for field in (*fields[: 1 + color], "orientation"):
        levels = getattr(maps, field)
        # The axes are (scale, ..., sub-channel, row, column), and radii come before sub-channels.
        means = np.stack(
            [maps.remembered(("means", field, s), partial(_means, levels[s])) for s in maps.scales]
        )
        blocks.append(means.transpose(3, 4, 2, 0, 1).reshape(CELLS * CELLS, -1))
    return np.ascontiguousarray(np.concatenate(blocks, axis=1).reshape(-1), np.float32)


def _means(level: NDArray[np.float32]) -> NDArray[np.float32]:
    """Return cell means as (radii, sub-channels, 4, 4). Missing axes have length 1."""
    means = cell_means(level, CELLS)
    return means.reshape((1,) * (4 - means.ndim) + means.shape)
