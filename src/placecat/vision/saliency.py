"""Fuse feature maps into conspicuity maps and a saliency map (thesis 3.1.1.1)."""

from functools import partial
from typing import NamedTuple

import cv2
import numpy as np
from numpy.typing import NDArray

from placecat.errors import PlacecatError
from placecat.vision.maps import FloatArray, FrameMaps
from placecat.vision.pyramid import level_size

CHANNELS = ("intensity", "color", "orientation", "residual")


class Channel(NamedTuple):
    """One channel of a frame's saliency. All maps are float32.

    Attributes
    ----------
    conspicuity
        (h, w), from 0 to the largest local maximum of `subchannels`, divided by the channel's unit.
    weight
        Weight of the conspicuity map, 1 / sqrt(m) (see `saliency`).
    subchannels
        (k, h, w), the feature maps, added across scales and radii. They are I' (k = 2: bright, dark), C'
        (k = 4: R, G, B, Y), O' (k = 4: 0, 45, 90, 135 degrees) or the residual (k = 1).
    subchannel_weights
        (k,), weights of the sub-channels, 1 / sqrt(m).
    """

    conspicuity: FloatArray
    weight: float
    subchannels: FloatArray
    subchannel_weights: FloatArray


class Saliency(NamedTuple):
    """A frame's saliency map, and its channels by name.

    The saliency map is the weighted sum of the channels, (h, w) float32, >= 0. All maps are as large as the
    pyramid level `scale`, so their pixel (x, y) lies at (x, y) * 2**scale in the frame.
    """

    scale: int
    saliency: FloatArray
    channels: dict[str, Channel]


def feature_maps(maps: FrameMaps, channel: str) -> dict[int, FloatArray]:
    """Return a dict that maps each scale to the feature maps of one of the `CHANNELS`.

    The feature maps are a (radii, subchannels, h, w) view. Channels without centre-surround differences have
    one radius.
    """
    if channel == "intensity":
        return maps.intensity_contrast
    if channel == "color":
        return maps.color_contrast
    if channel == "orientation":
        return {scale: stack[None] for scale, stack in maps.orientation.items()}
    return {scale: plane[None, None] for scale, plane in maps.residual.items()}


def saliency(
    maps: FrameMaps,
    *,
    fusion_scale: int = 2,
    use_residual: bool = True,
    maximum_window: int = 3,
    intensity_unit: float = 255.0,
    color_unit: float = 3.0,
    orientation_unit: float = 127.5,
    residual_unit: float = 4.0,
) -> Saliency:
    """Fuse a frame's feature maps (thesis 3.1.1.1).

    Within each sub-channel, maps are added across scales and radii. Sub-channels are added, with weights
    1 / sqrt(m), to form conspicuity maps. Each conspicuity map is stretched linearly to [0, largest local
    maximum of its sub-channels] and divided by its unit. Then the conspicuity maps are added, again with
    weights 1 / sqrt(m). Here, m is the number of a map's local maxima that are strictly above their median.
    If m is 0, the weight is also 0, so a map with a single peak does not count.

    Parameters
    ----------
    fusion_scale
        Pyramid level on which maps are added, at most the lowest scale. The thesis does not specify this.
    use_residual
        Whether to use the spectral residual as a fourth channel (3.1.1.2).
    maximum_window
        Side length of the neighbourhood that a local maximum dominates; must be odd. The thesis does not
        specify this.
    intensity_unit, color_unit, orientation_unit, residual_unit
        Divisors of the conspicuity maps. They are needed because the largest local maximum of each channel is
        in the units of that channel. The defaults correspond to black against white, pure red, and a wave
        from black to white. Unlike the others, the residual reaches 1 in every frame and at every scale. The
        divisor 4 makes it comparable to them in photographs of homes. The thesis does not specify these
        divisors.

    Raises
    ------
    PlacecatError
        If the fusion scale is above the lowest scale, or if the residual is missing.
    """
    if fusion_scale > maps.scales[0]:
        raise PlacecatError(
            f"fusion_scale must lie between 0 and the lowest scale {maps.scales[0]}, not {fusion_scale}"
        )
    if use_residual and not maps.residual:
        raise PlacecatError(
            "the maps have no spectral residual: compute them with it, or set use_residual to false"
        )
    units = dict(zip(CHANNELS, (intensity_unit, color_unit, orientation_unit, residual_unit), strict=True))
    channels: dict[str, Channel] = {}
    width, height = level_size(maps.width, maps.height, fusion_scale)
    total = np.zeros((height, width), np.float32)
    for channel in CHANNELS if use_residual else CHANNELS[:-1]:
        settings = (channel, fusion_scale, maximum_window, units[channel])
        # Region variants may combine different channels, but each channel is the same in all of them.
        one = maps.remembered((_fuse, *settings), partial(_fuse, maps, *settings))
        total += np.float32(one.weight) * one.conspicuity
        channels[channel] = one
    return Saliency(fusion_scale, total, channels)


def _fuse(maps: FrameMaps, channel: str, fusion_scale: int, window: int, unit: float) -> Channel:
    stack = add_across_scales(
        {scale: _sum_radii(levels) for scale, levels in feature_maps(maps, channel).items()},
        maps.width,
        maps.height,
        fusion_scale,
    )
    peaks = [plane.ravel()[local_maxima(plane, window)] for plane in stack]
    own = np.array([weight(values) for values in peaks], np.float32)
    largest = max((float(values.max()) for values in peaks if values.size), default=0.0)
    plane = stretch(_weighted_sum(stack, own), largest / unit)
    return Channel(plane, weight(plane.ravel()[local_maxima(plane, window)]), stack, own)


def add_across_scales(
    levels: dict[int, FloatArray], width: int, height: int, fusion_scale: int
) -> FloatArray:
    """Expand maps from several scales to one level, and add them up (thesis 3.1.1.1).

    Expansion is bilinear. As in the pyramid, pixel (x, y) of level s lies at (x, y) 2**(s - fusion_scale).
    The last pixel of a map is repeated beyond its edge. Repeated doubling yields the same result as direct
    expansion, so the sum of the coarser levels is expanded step by step.

    `levels` maps each scale to its (k, h_s, w_s) float32 maps. `width` and `height` are the size of the frame
    in pixels. `fusion_scale`, at most the lowest scale, is the level of the (k, h, w) float32 result.
    """
    last = max(levels)
    total = levels[last]
    for level in range(last - 1, fusion_scale - 1, -1):
        total = _double(total, *level_size(width, height, level))
        if level in levels:
            total += levels[level]
    return total


def local_maxima(plane: FloatArray, window: int = 3) -> NDArray[np.intp]:
    """Find a map's local maxima.

    A local maximum is positive and at least as high as every pixel in the window around it. Pixels outside
    the map count as lower. Adjacent pixels of equal value count only once, at the first of them in row order,
    and only if all of them are local maxima. A flat area next to a higher pixel therefore has no maximum, and
    neither does a constant map.

    `plane` is (h, w) float32 and finite. `window` is the side length of the neighbourhood, which must be odd
    and at least 3. The thesis does not specify it. Returns flat indices in ascending order.
    """
    if plane.size < 2:
        return np.zeros(0, np.intp)
    around = np.ones((window, window), np.uint8)
    around[window // 2, window // 2] = 0
    highest = cv2.dilate(plane, around)
    positive = plane > 0
    peak = plane > highest
    peak &= positive
    tied = plane == highest
    tied &= positive
    if tied.any():
        peak.ravel()[_plateaus(plane, tied)] = True
    return np.flatnonzero(peak)


def weight(peaks: FloatArray) -> float:
    """Compute a map's weight from the (n,) strengths of its local maxima (thesis 3.1.1.1).

    The weight is 1 / sqrt(m), where m is the number of strengths strictly above their median, or 0 if m is 0.
    """
    if peaks.size == 0:
        return 0.0
    ordered = np.sort(peaks)  # np.median would take 80 microseconds
    middle = peaks.size // 2
    median = ordered[middle] if peaks.size % 2 else (ordered[middle - 1] + ordered[middle]) / 2
    count = int(np.count_nonzero(peaks > median))
    return count**-0.5 if count else 0.0


def stretch(plane: FloatArray, high: float) -> FloatArray:
    """Map an (h, w) float32 plane linearly to [0, high]; a flat plane becomes 0.

    This normalises the conspicuity maps (thesis 3.1.1.1).
    """
    least, most = float(plane.min()), float(plane.max())
    if most <= least:
        return np.zeros_like(plane)
    out: FloatArray = plane - np.float32(least)
    out *= np.float32(high / (most - least))
    return out


def _sum_radii(stack: FloatArray) -> FloatArray:
    total = stack[0]
    for own in stack[1:]:
        total = total + own
    return total


def _weighted_sum(stack: FloatArray, weights: FloatArray) -> FloatArray:
    # Add plane by plane, because the summation order of a matrix product may depend on the number of threads.
    total = stack[0] * weights[0]
    for plane, own in zip(stack[1:], weights[1:], strict=True):
        total += plane * own
    return total


def _double(stack: FloatArray, width: int, height: int) -> FloatArray:
    """Double the size of (k, ceil(height / 2), ceil(width / 2)) maps by bilinear interpolation.

    Even pixels keep their values.
    """
    count, rows, columns = stack.shape
    flat = stack.reshape(-1, columns)
    between = np.empty_like(flat)
    between[:, -1] = flat[:, -1]
    _halfway(flat[:, :-1], flat[:, 1:], between[:, :-1])
    wide = cv2.merge([flat, between])
    out = np.empty((count, 2 * rows, 2 * columns), np.float32)
    pairs = out.reshape(count * rows, 2, 2 * columns)
    pairs[:, 0] = wide.reshape(count * rows, 2 * columns)
    # Treat all planes as one. Rows that mix two planes are overwritten later.
    _halfway(pairs[:-1, 0], pairs[1:, 0], pairs[:-1, 1])
    out[:, -1] = out[:, -2]
    return np.ascontiguousarray(out[:, :height, :width])


def _halfway(first: FloatArray, second: FloatArray, out: FloatArray) -> None:
    """Write the mean of two planes to `out`. Halving is exact, so only the sum is rounded."""
    if out.size:
        cv2.addWeighted(first, 0.5, second, 0.5, 0, dst=out)


def _plateaus(plane: FloatArray, tied: NDArray[np.bool_]) -> NDArray[np.intp]:
    """Return the flat index of the first pixel of each plateau that is a maximum.

    `tied` marks the pixels that equal their highest neighbour.
    """
    height, width = plane.shape
    found = np.flatnonzero(tied)
    if found.size == plane.size:  # The plane is constant.
        return found[:0]
    rows, columns = np.divmod(found, width)
    # If a tied pixel is next to an equal pixel that is not tied, there is an uphill path.
    near = np.arange(-1, 2)[:, None]
    down = np.clip(rows + near, 0, height - 1) * width
    around = down[:, None] + np.clip(columns + near, 0, width - 1)
    others = (plane.ravel()[around] == plane.ravel()[found]) & ~tied.ravel()[around]
    uphill = others.any(axis=(0, 1))
    if uphill.all():
        return found[:0]
    # Label only the bounding box of the ties. Except in synthetic images, ties are rare and close together.
    rows -= rows.min()
    columns -= columns.min()
    mask = np.zeros((rows.max() + 1, columns.max() + 1), np.uint8)
    mask[rows, columns] = 1
    count, image = cv2.connectedComponents(mask, connectivity=8)
    labels = image[rows, columns]
    first = np.empty(count, np.intp)
    first[labels[::-1]] = found[::-1]
    top = np.arange(count) > 0
    top[labels[uphill]] = False
    return first[top]
