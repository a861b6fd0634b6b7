"""A SIFT descriptor for each salient region."""

from functools import lru_cache
from typing import Annotated, Any

import cv2
import numpy as np
from numpy.typing import NDArray

from placecat.ranges import OneOf
from placecat.vision.maps import FrameMaps
from placecat.vision.patches import BORDERS, cut, region_side

SPREAD = 430.0
MAPS = ("grey",)

ORIENTATIONS = ("upright", "dominant")
CELLS = 4
BINS = 8
SIZE = CELLS * CELLS * BINS
ANGLE_BINS = 36


def describe(
    maps: FrameMaps,
    regions: NDArray[np.float32],
    *,
    orientation: Annotated[str, OneOf(ORIENTATIONS)] = "upright",
    border: Annotated[str, OneOf(BORDERS)] = "replicate",
) -> NDArray[np.float32]:
    """Describe each region with one SIFT descriptor whose 4x4 cells cover it (thesis 3.1.2).

    Each cell is a quarter as wide as the region. As in the implementations by Lowe, Hess and OpenCV,
    a gradient votes for the nearest cells and bins with trilinear weights, so gradients up to half a cell
    outside the region also count. The gradients are weighted by a Gaussian whose sigma is half the region's
    side. The pyramid level is not blurred again.

    `orientation` is ``upright`` or ``dominant``. With ``dominant``, angles are relative to the strongest
    direction (see `dominant_angles`). The thesis does not specify this.

    Returns
    -------
    (n, 128) float32, integer values from 0 to 255. The cells are listed row by row. Each cell has 8 bins over
    360 degrees, counter-clockwise from the x axis or from the dominant angle. Values are clipped at 0.2 times
    the norm and then scaled to a norm of 512. They are 0 for a patch without gradients.

    References
    ----------
    Lowe, Distinctive image features from scale-invariant keypoints, IJCV 2004, sections 5 and 6.
    """
    cell = region_side(maps.width) / CELLS
    upright = orientation == "upright"
    reach = (CELLS + 1) / 2 * cell
    radius = int(np.ceil(reach)) - 1 if upright else round(reach * np.sqrt(2))
    patches = cut(maps.grey, regions, 2 * radius + 3, border=border)
    if not len(patches):
        return np.zeros((0, SIZE), np.float32)
    magnitude, angle = _gradients(patches)
    turn = np.zeros(1) if upright else dominant_angles(magnitude, angle, cell / 3)
    weights = _upright_weights(radius, cell) if upright else _weights(radius, cell, turn)
    histogram = weights @ _votes(magnitude, angle, turn)
    return _normalised(histogram.reshape(len(patches), SIZE))


def _gradients(patches: NDArray[np.float32]) -> tuple[NDArray[np.float32], NDArray[np.float32]]:
    """Return the (n, h - 2, w - 2) magnitudes and angles of central differences.

    Angles range from 0 to 2 pi, counter-clockwise.
    """
    right = patches[:, 1:-1, 2:] - patches[:, 1:-1, :-2]
    up = patches[:, :-2, 1:-1] - patches[:, 2:, 1:-1]
    polar = cv2.cartToPolar(right.reshape(len(right), -1), up.reshape(len(up), -1))
    magnitude, angle = (np.asarray(values, np.float32).reshape(right.shape) for values in polar)
    return magnitude, angle


def dominant_angles(
    magnitude: NDArray[np.float32], angle: NDArray[np.float32], scale: float
) -> NDArray[np.float64]:
    """Find the strongest gradient direction around each patch's centre (Lowe 2004, section 5).

    `magnitude` and `angle` (in radians) are (n, 2 R + 1, 2 R + 1) float32. `scale` is the region's scale in
    pixels, which Lowe defines as a third of a cell. The window is a Gaussian with a sigma of 1.5 scales,
    truncated at 4.5 scales or at the edge of the patch.

    Returns (n,) float64 angles in radians, in [0, 2 pi). The angle is that of the highest of 36 smoothed
    bins, refined by parabolic interpolation, or 0 for a patch without gradients.
    """
    count, centre = len(magnitude), magnitude.shape[1] // 2
    radius = min(round(4.5 * scale), centre)
    window = slice(centre - radius, centre + radius + 1)
    offset = np.arange(-radius, radius + 1)
    gauss = np.exp(-(offset[:, None] ** 2 + offset**2) / (2 * (1.5 * scale) ** 2))
    votes = magnitude[:, window, window] * gauss
    bins = np.rint(angle[:, window, window] * (ANGLE_BINS / (2 * np.pi))).astype(np.intp) % ANGLE_BINS
    bins += np.arange(count)[:, None, None] * ANGLE_BINS
    raw = np.bincount(bins.ravel(), votes.ravel(), count * ANGLE_BINS).reshape(count, ANGLE_BINS)
    smooth = np.zeros(raw.shape)
    for bins_on, weight in zip(range(-2, 3), (1 / 16, 4 / 16, 6 / 16, 4 / 16, 1 / 16), strict=True):
        smooth += weight * np.roll(raw, bins_on, axis=1)
    rows = np.arange(count)
    peak = smooth.argmax(axis=1)
    left, top, right = (smooth[rows, (peak + d) % ANGLE_BINS] for d in (-1, 0, 1))
    bend = left - 2 * top + right
    shift = np.where(bend < 0, 0.5 * (left - right) / np.where(bend < 0, bend, 1), 0)
    turn: NDArray[np.float64] = (peak + shift) % ANGLE_BINS * (2 * np.pi / ANGLE_BINS)
    return turn


def _weights(radius: int, cell: float, turn: NDArray[np.float64]) -> NDArray[np.float32]:
    """Return the (n, 16, pixels) weights of the pixels in each cell, for cells rotated by (n,) angles."""
    offset = np.arange(-radius, radius + 1) / cell
    down, right = (axis.reshape(1, -1) for axis in np.meshgrid(offset, offset, indexing="ij"))
    cosine, sine = np.cos(turn)[:, None], np.sin(turn)[:, None]
    column, row = right * cosine - down * sine, right * sine + down * cosine
    cells = np.arange(CELLS)[:, None] - (CELLS - 1) / 2
    across = np.clip(1 - np.abs(column[:, None] - cells), 0, None)
    along = np.clip(1 - np.abs(row[:, None] - cells), 0, None)
    along *= np.exp(-(column**2 + row**2) / (CELLS * CELLS / 2))[:, None]
    weights = along[:, :, None] * across[:, None]
    return weights.reshape(len(turn), CELLS * CELLS, -1).astype(np.float32)


@lru_cache(maxsize=8)
def _upright_weights(radius: int, cell: float) -> NDArray[np.float32]:
    weights = _weights(radius, cell, np.zeros(1))
    weights.flags.writeable = False
    return weights


def _votes(
    magnitude: NDArray[np.float32], angle: NDArray[np.float32], turn: NDArray[np.float64]
) -> NDArray[np.float32]:
    """Split each pixel's vote linearly between the two nearest bins, and return (n, pixels, 8) votes."""
    count = len(magnitude)
    magnitude = magnitude.reshape(count, -1)
    position = (angle.reshape(count, -1) - turn[:, None].astype(np.float32)) * np.float32(BINS / (2 * np.pi))
    lower = np.floor(position)
    position -= lower
    upper_part = np.multiply(position, magnitude, out=position)
    # BINS is a power of two, so the mask yields the remainder, even for negative numbers.
    first = lower.astype(np.intp)
    first &= BINS - 1
    second = first + 1
    second &= BINS - 1
    start = _starts(*position.shape)
    first += start
    second += start
    votes = np.zeros((*position.shape, BINS), np.float32)
    flat = votes.reshape(-1)
    flat[first] = magnitude - upper_part
    flat[second] = upper_part
    return votes


@lru_cache(maxsize=8)
def _starts(count: int, pixels: int) -> NDArray[np.intp]:
    """Return the (n, pixels) flat indices of the first bin of each pixel."""
    starts = np.arange(count * pixels).reshape(count, pixels) * BINS
    starts.flags.writeable = False
    return starts


def _normalised(histogram: NDArray[Any]) -> NDArray[np.float32]:
    norm = np.linalg.norm(histogram, axis=1, keepdims=True)
    clipped = np.minimum(histogram, 0.2 * norm)
    norm = np.linalg.norm(clipped, axis=1, keepdims=True)
    scaled = clipped * (512 / np.maximum(norm, np.finfo(np.float32).eps))
    return np.minimum(np.rint(scaled), 255).astype(np.float32)
