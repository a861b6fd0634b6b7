"""Gist: each feature map's means in the cells of a grid."""

import numpy as np
from numpy.typing import NDArray

from placecat.vision.grid import cell_means
from placecat.vision.maps import FrameMaps

# The fields of `FrameMaps` that this module reads.
MAPS = ("grey", "color", "intensity_contrast", "color_contrast", "orientation")

CELLS = 4


def describe(
    frame: NDArray[np.uint8], maps: FrameMaps, *, color: bool = True, center_surround: bool = True
) -> NDArray[np.float32]:
    """Describe a frame by its feature maps' means in a 4x4 grid (thesis 3.2).

    Parameters
    ----------
    frame
        (H, W, 3) uint8 BGR; not used.
    maps
        The frame's maps.
    color
        Include the colour maps. Thesis 4.2 has a variant without them.
    center_surround
        If true, use the centre-surround maps of intensity and colour; if false, their pyramids (a variant in
        thesis 4.2). Orientation has no centre-surround maps.

    Returns
    -------
    (size,) float32: a block for each of the 16 cells, row by row from the top left. A block contains
    intensity (on, off), colour (R, G, B, Y) and orientation (0, 45, 90, 135 degrees). Within a channel the
    order is sub-channel, scale, radius (radius varies fastest). By default the channels have 16, 32 and 16
    values.

    References
    ----------
    Siagian and Itti, Rapid biologically-inspired scene classification using features shared with visual
    attention, PAMI 2007.
    """
    channels = [maps.orientation]
    if center_surround:
        channels = [maps.intensity_contrast, *([maps.color_contrast] if color else []), *channels]
    else:
        channels = [maps.grey, *([maps.color] if color else []), *channels]
    blocks = []
    for channel in channels:
        # (scale, ..., sub-channel, row, column); radii come before sub-channels.
        means = np.stack([maps.once(_means, channel[scale]) for scale in maps.scales])
        blocks.append(means.transpose(3, 4, 2, 0, 1).reshape(CELLS * CELLS, -1))
    return np.ascontiguousarray(np.concatenate(blocks, axis=1).reshape(-1), np.float32)


def _means(level: NDArray[np.float32]) -> NDArray[np.float32]:
    """Return cell means as (radii, sub-channels, 4, 4); a missing axis has length 1."""
    means = cell_means(level, CELLS)
    return means.reshape((1,) * (4 - means.ndim) + means.shape)
