"""Find salient points, their scales, and the regions around them (thesis 3.1.1.3)."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from placecat.vision.maps import FloatArray, FrameMaps
from placecat.vision.saliency import Saliency, feature_maps, local_maxima

# Number of points that `accept` processes at once.
BLOCK = 128


def radius(scale: FloatArray | float, width: int) -> FloatArray:
    """Return the radius of a region in frame pixels, width / 128 * 2^s (thesis 3.1.1.3).

    `scale` is s and may have any shape; the float32 result has the same shape. `width` is the width of the
    frame in pixels.
    """
    return np.asarray(width / 128 * np.exp2(np.asarray(scale, np.float64)), np.float32)


def find_scales(maps: FrameMaps, fused: Saliency, points: NDArray[np.intp]) -> NDArray[np.intp]:
    """Find the scale of the strongest feature at each salient point (thesis 3.1.1.3).

    At each point, the function first chooses the conspicuity map with the highest response, then the
    sub-channel, then the scale. It compares conspicuity maps and sub-channels after normalisation and
    weighting, just as they enter the sums. The response at a scale is that of its expanded feature map at the
    radius with the stronger response. This is our interpretation, because the thesis says only "highest
    response". Ties go to the first of intensity, color, orientation and residual, and to the lower scale.

    `fused` is the `Saliency` of `maps`, and `points` are (n,) flat indices into the saliency map. Returns
    (n,) scales from `maps.scales`.
    """
    channels = fused.channels.values()
    terms = [one.conspicuity.ravel()[points] * np.float32(one.weight) for one in channels]
    strongest = np.argmax(terms, axis=0)
    chosen = [np.flatnonzero(strongest == number) for number in range(len(channels))]
    subchannel = np.zeros(points.size, np.intp)
    for one, some in zip(channels, chosen, strict=True):
        stack = one.subchannels.reshape(len(one.subchannels), -1)
        subchannel[some] = np.argmax(stack[:, points[some]] * one.subchannel_weights[:, None], axis=0)
    rows, columns = np.divmod(points, fused.saliency.shape[1])
    sizes = np.array([maps.grey[scale].shape for scale in maps.scales])
    index, share = _corners(rows, columns, sizes, np.array(maps.scales) - fused.scale)
    index += subchannel * sizes.prod(axis=1)[:, None, None]
    responses = np.zeros((len(maps.scales), points.size), np.float32)
    for name, some in zip(fused.channels, chosen, strict=True):
        stacks, own, shares = feature_maps(maps, name), index[:, :, some], share[:, :, some]
        for number, scale in enumerate(maps.scales):
            stack = stacks[scale]
            values = stack.reshape(len(stack), -1).take(own[number], axis=1)
            values *= shares[number]
            responses[number, some] = values.sum(axis=1).max(axis=0)
    return np.array(maps.scales)[np.argmax(responses, axis=0)]


def accept(
    points: FloatArray,
    width: int,
    *,
    max_regions: int = 25,
    scale_distance: float = 1 / 256,
    min_distance: float = 1 / 40,
) -> NDArray[np.intp]:
    """Accept points one by one if they lie far enough from all accepted points (thesis 3.1.1.3).

    A new point q is accepted if every accepted point p satisfies::

        sqrt((p_x - q_x)^2 + (p_y - q_y)^2 + (width/256)^2 (p_s - q_s)^2) > q_s width/40

    Parameters
    ----------
    points
        (n, 3) array with the columns x, y (in frame pixels) and scale, the most salient point first.
    width
        Width of the frame in pixels.
    max_regions
        Maximum number of points, at least 1.
    scale_distance, min_distance
        Factors in the inequality. The thesis uses 1/256 and 1/40.

    Returns
    -------
    Indices of the accepted points in ascending order.
    """
    place = np.array(points, np.float64).reshape(-1, 3).T
    least = (place[2] * width * min_distance) ** 2
    place[2] *= width * scale_distance
    accepted: list[int] = []
    for start in range(0, least.size, BLOCK):
        block = np.arange(start, min(start + BLOCK, least.size))
        if accepted:
            block = block[_far(place, least, accepted, block).all(axis=0)]
        # To make intersections fast, each point gets an integer with a bit for every point that is far enough
        # away.
        far = np.packbits(_far(place, least, block, block), axis=1, bitorder="little")
        open_ = (1 << block.size) - 1
        while open_ and len(accepted) < max_regions:
            new = (open_ & -open_).bit_length() - 1
            accepted.append(int(block[new]))
            open_ &= int.from_bytes(far[new].tobytes(), "little")
        if len(accepted) == max_regions:
            break
    return np.array(accepted, np.intp)


def _far(
    place: NDArray[np.float64],
    least: NDArray[np.float64],
    old: Sequence[int] | NDArray[np.intp],
    new: NDArray[np.intp],
) -> NDArray[np.bool_]:
    """Mark the (old, new) pairs of points that are far enough apart. A point is never far from itself."""
    apart = np.zeros((len(old), len(new)))
    for axis in place:
        difference = axis[old][:, None] - axis[new]
        difference *= difference
        apart += difference
    return apart > least[new]


def select_regions(
    maps: FrameMaps,
    fused: Saliency,
    *,
    max_regions: int = 25,
    maximum_window: int = 3,
    **distances: float,
) -> FloatArray:
    """Find a frame's salient regions from its saliency map (thesis 3.1.1.3).

    `fused` is the `Saliency` of `maps`. See `placecat.vision.saliency.local_maxima` for `maximum_window`, and
    `accept` for the other settings.

    Returns an (n, 4) float32 array, where 0 <= n <= `max_regions`. Its columns are the x and y of the centre
    in frame pixels, the scale and the saliency. The rows are sorted by decreasing saliency, then by y, then
    by x.
    """
    points = local_maxima(fused.saliency, maximum_window)
    strength = fused.saliency.ravel()[points]
    order = np.argsort(-strength, kind="stable")
    points, strength = points[order], strength[order]
    step = 2**fused.scale
    # Weaker points do not affect stronger ones, so consider more points only if needed.
    count = 16 * max_regions
    while True:
        rows, columns = np.divmod(points[:count], fused.saliency.shape[1])
        scales = find_scales(maps, fused, points[:count])
        regions = np.stack([columns * step, rows * step, scales, strength[:count]], axis=1).astype(np.float32)
        accepted = accept(regions[:, :3], maps.width, max_regions=max_regions, **distances)
        if accepted.size >= max_regions or count >= points.size:
            return regions[accepted]
        count *= 4


def _corners(
    rows: NDArray[np.intp], columns: NDArray[np.intp], sizes: NDArray[np.intp], ups: NDArray[np.intp]
) -> tuple[NDArray[np.intp], FloatArray]:
    """Return (maps, 4, n) indices and weights for interpolating maps at n pixels of a finer level.

    Interpolation is bilinear, and the last pixel of a map is repeated beyond its edge. `rows` and `columns`
    are the (n,) positions on the finer level. `sizes` is (maps, 2), the height and width of each map. `ups`
    is (maps,), the number of doublings needed to get from each map to the finer level.
    """
    up = ups[:, None]
    height, width = sizes.T[:, :, None]
    top, left = rows >> up, columns >> up
    corner = top * width + left
    right = left + 1 < width
    down = np.where(top + 1 < height, width, 0)
    step = 1 << up
    y = (rows & (step - 1)) / step
    x = (columns & (step - 1)) / step
    index = np.stack([corner, corner + right, corner + down, corner + down + right], axis=1)
    share = np.stack([(1 - y) * (1 - x), (1 - y) * x, y * (1 - x), y * x], axis=1)
    return index, share.astype(np.float32)
