"""Compute and reduce the intensity and the intensity-normalised opponent colours of a frame in one pass.

After division by the intensity i = (r + g + b) / 3, the three colours sum to 3, so the thesis's channels R,
G, B and Y follow from three planes, R, G and D = |R - G|::

    R = 1.5 (r/i - 1)        G = 1.5 (g/i - 1)        B = -(R + G)        Y = 2 (R + G) - 4/3 D

Reduction and centre-surround differences are linear, so they are applied to R, G, D. B and Y are computed
only where needed. A black pixel has no colour and is treated as grey. Then R = G = D = 0 yields B = Y = 0, so
the identities still hold.
"""

from collections.abc import Sequence

import cv2
import numpy as np
from numpy.typing import NDArray

from placecat.errors import PlacecatError
from placecat.vision.maps import FloatArray
from placecat.vision.pyramid import level_size

# Strips with fewer rows would fit in a core's cache, but the extra calls would cost more time than this
# saves.
STRIP_ROWS = 144
SHIFT = np.float32(1.5)


def check_frame(frame: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """Return an (H, W, 3) uint8 BGR frame as a C-contiguous array.

    Raises TypeError if it is not a uint8 array, and PlacecatError if it is empty or its shape is not
    (H, W, 3).
    """
    if not isinstance(frame, np.ndarray) or frame.dtype != np.uint8:
        kind = frame.dtype if isinstance(frame, np.ndarray) else type(frame).__name__
        raise TypeError(f"a frame must be a uint8 array, not {kind}")
    if frame.ndim != 3 or frame.shape[2] != 3 or frame.size == 0:
        raise PlacecatError(
            f"a frame must have the shape (height, width, 3), not {frame.shape}: decode it as BGR"
        )
    return np.ascontiguousarray(frame)


def reduced_planes(
    frame: NDArray[np.uint8], *, color: bool = True, clip: bool = False, strip_rows: int = STRIP_ROWS
) -> tuple[FloatArray, list[FloatArray]]:
    """Return the sum r + g + b and the colour planes at pyramid level 1 (thesis 3.1.1.1).

    To save memory, the frame is processed in strips of `strip_rows` rows, an even number of at least 4. The
    strip size does not affect the result.

    Parameters
    ----------
    frame
        (H, W, 3) uint8, BGR.
    color
        If false, only the sum is computed.
    clip
        If false, the planes are R, G, D. If true, negative colour values are set to 0 in each pixel, as Itti
        et al. do, and the planes are R, G, B, Y. The thesis does not specify this.

    Returns
    -------
    total
        (ceil(H / 2), ceil(W / 2)) float32, three times the intensity, from 0 to 765.
    planes
        3 or 4 float32 planes of the same size. They are either R and G from -1.5 to 3 and D from 0 to 4.5, or
        R, G, B, Y from 0 to 3. Empty if `color` is false.
    """
    height, width = frame.shape[:2]
    out_width, out_height = level_size(width, height, 1)
    number = 1 if not color else 5 if clip else 4
    reduced = [np.empty((out_height, out_width), np.float32) for _ in range(number)]
    # The 5x5 kernel needs two extra rows above and below.
    work = np.empty((4, min(strip_rows + 4, height), width), np.float32)
    split = np.empty((3, *work.shape[1:]), np.uint8)
    for start in range(0, height, strip_rows):
        top = max(start - 2, 0)
        bottom = min(start + strip_rows + 2, height)
        count = bottom - top
        planes = _full_planes(frame[top:bottom], list(split[:, :count]), work[:, :count], color, clip)
        rows = slice(top // 2, (bottom + 1) // 2)
        for target, plane in zip(reduced, planes, strict=True):
            # The outermost rows of the strip lack neighbours. The next strip rewrites the lower row, and the
            # upper row is already correct.
            above = target[top // 2].copy()
            cv2.pyrDown(plane, dst=target[rows])
            if top:
                target[top // 2] = above
    total, *colors = reduced
    if not clip:
        for plane in colors[:2]:
            plane -= SHIFT
    return total, colors


def channels(planes: Sequence[FloatArray]) -> FloatArray:
    """Compute R, G, B, Y from the planes of `reduced_planes`, or from linear functions of these planes.

    Each plane is (h, w) float32. R, G, D are combined using the identities at the top of this module, whereas
    R, G, B, Y are merely stacked. Returns (4, h, w) float32. In each pixel, R, G and B lie between -1.5 and
    3, and Y lies between -6 and 3.
    """
    out = np.empty((4, *planes[0].shape), np.float32)
    out[0], out[1] = planes[:2]
    if len(planes) == 4:
        out[2], out[3] = planes[2:]
    else:
        red, green, difference = planes
        blue_yellow(red, green, difference, out[2], out[3])
    return out


def blue_yellow(
    red: FloatArray, green: FloatArray, difference: FloatArray, blue: FloatArray, yellow: FloatArray
) -> None:
    """Write B = -(R + G) and Y = 2 (R + G) - 4/3 D to `blue` and `yellow`.

    All planes are (h, w) float32, and `blue` and `yellow` must be contiguous.
    """
    np.add(red, green, out=blue)
    cv2.addWeighted(blue, 2, difference, -4 / 3, 0, dst=yellow)
    np.negative(blue, out=blue)


def reduced_grey(
    frame: NDArray[np.uint8], width: int | None, interpolation: int = cv2.INTER_AREA
) -> NDArray[np.uint8]:
    """Convert an (H, W, 3) uint8 BGR frame to grey as OpenCV does, and reduce it to a given width.

    Returns (max(1, round(H width / W)), width) uint8. A frame no wider than `width` keeps its size.
    """
    grey = cv2.cvtColor(frame, cv2.COLOR_BGR2GRAY)
    height, full = grey.shape
    if width is not None and width < full:
        grey = cv2.resize(grey, (width, max(1, round(height * width / full))), interpolation=interpolation)
    return np.asarray(grey, np.uint8)


def _full_planes(
    strip: NDArray[np.uint8], colors: list[NDArray[np.uint8]], work: FloatArray, color: bool, clip: bool
) -> list[FloatArray]:
    """Return r + g + b at full size and, if `color`, also R + 1.5, G + 1.5, D (with `clip`, R, G, B, Y)."""
    cv2.split(strip, colors)
    b, g, r = colors
    total, red, green, difference = work
    np.copyto(red, r)
    np.copyto(green, g)
    np.copyto(difference, b)
    np.add(red, green, out=total)
    total += difference
    if not color:
        return [total]
    scale = difference
    if total.min() > 0:
        np.divide(SHIFT * 3, total, out=scale)
    else:
        black = total == 0
        red[black] = green[black] = 1
        np.divide(SHIFT * 3, np.where(black, np.float32(3), total), out=scale)
    red *= scale
    green *= scale
    cv2.absdiff(red, green, dst=difference)
    if clip:
        return [total, *np.maximum(channels((red - SHIFT, green - SHIFT, difference)), np.float32(0))]
    return [total, red, green, difference]
