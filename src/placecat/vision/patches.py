"""Cut a square patch around each salient region, from the pyramid level at the region's scale."""

from collections.abc import Mapping
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from placecat.errors import PlacecatError

MIN_SIDE = 4
BORDERS = ("replicate", "reflect")


def region_side(width: int) -> int:
    """Return the side length of a patch: the region's diameter, 2 width / 128 (thesis 3.1.1.3).

    `width` is the width of the frame in pixels (level 0). The side length is in pixels of the region's level,
    rounded to an integer, and at least 4. It is the same at every scale, because the radius doubles with each
    level.
    """
    return max(MIN_SIDE, round(width / 64))


def cut(
    levels: Mapping[int, NDArray[np.float32]],
    regions: NDArray[np.float32],
    side: int,
    *,
    border: str = "replicate",
) -> NDArray[np.float32]:
    """Cut a square around each region from the pyramid level at its scale.

    Position x on level 0 corresponds to x / 2**s on level s, because cv2.pyrDown keeps the even pixels. A
    square with an odd side length is centred on the nearest pixel, and one with an even side length on the
    nearest corner between pixels.

    Parameters
    ----------
    levels
        A dict from `FrameMaps` that maps each scale s to a (..., h_s, w_s) float32 array.
    regions
        (n, 4) float32 with the columns x, y (in pixels of level 0), scale (a key of `levels`) and strength.
    side
        Side length of the squares, in pixels of the level.
    border
        How to fill pixels outside the image. ``replicate`` repeats the outermost pixels, and ``reflect``
        mirrors the image about them. The thesis does not specify this.

    Returns
    -------
    (n, ..., side, side) float32. Raises PlacecatError if `border` is unknown.
    """
    if border not in BORDERS:
        raise PlacecatError(f"border={border} is unknown for region patches: use {' or '.join(BORDERS)}")
    regions = np.asarray(regions, np.float32)
    channels = next(iter(levels.values())).shape[:-2]
    patches = np.empty((len(regions), *channels, side, side), np.float32)
    shapes = tuple((scale, *level.shape[-2:]) for scale, level in levels.items())
    for scale, members, pixels in _places(shapes, regions.tobytes(), side, border):
        found = levels[scale].reshape(*channels, -1).take(pixels, axis=-1)
        patches[members] = np.moveaxis(found, len(channels), 0) if channels else found
    return patches


# Cache the positions, because most descriptors cut the same squares out of a frame.
@lru_cache(maxsize=4)
def _places(
    shapes: tuple[tuple[int, int, int], ...], regions: bytes, side: int, border: str
) -> list[tuple[int, NDArray[np.intp], NDArray[np.intp]]]:
    """Find the regions on each level, and their pixels.

    `shapes` lists the scale, height and width of each level, and `regions` contains the bytes of an (n, 4)
    float32 array. For each level that has regions, returns the scale, the (m,) indices of the regions, and
    the (m, side, side) flat indices of their pixels.
    """
    x, y, scales, _ = np.frombuffer(regions, np.float32).reshape(-1, 4).astype(np.float64).T
    order = np.argsort(scales, kind="stable")
    centres = np.stack([y, x])[:, order] / 2.0 ** scales[order]
    corners = np.floor(centres - (side - 1) / 2 + 0.5).astype(np.intp)
    rows, columns = corners[:, :, None] + np.arange(side)
    sizes = {scale: size for scale, *size in shapes}
    listed = scales[order].tolist()
    height, width = np.array([sizes[scale] for scale in listed], np.intp).reshape(-1, 2).T[:, :, None]
    rows, columns = _inside(rows, height, border), _inside(columns, width, border)
    pixels = (rows * width)[:, :, None] + columns[:, None]
    places, start = [], 0
    for scale in sorted(sizes):
        stop = start + listed.count(scale)
        if stop > start:
            places.append((scale, order[start:stop], pixels[start:stop]))
        start = stop
    return places


def _inside(index: NDArray[np.intp], length: NDArray[np.intp], border: str) -> NDArray[np.intp]:
    """Replace (n, side) pixel indices outside the image with indices inside it; `length` is (n, 1)."""
    if border == "replicate":
        return np.minimum(np.maximum(index, 0), length - 1)
    period = np.maximum(2 * length - 2, 1)
    index = np.abs(index) % period
    return np.minimum(index, period - index)


def to_bytes(patches: NDArray[np.float32]) -> NDArray[np.uint8]:
    """Round float32 grey levels of any shape to uint8 (0 to 255), as in an 8-bit image."""
    return np.clip(np.rint(patches), 0, 255).astype(np.uint8)
