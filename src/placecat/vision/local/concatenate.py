"""Combine a region's shape descriptor with its vertical position and colour (thesis 4.4.1)."""

import numpy as np
from numpy.typing import NDArray

from placecat.errors import PlacecatError


def concatenate(
    shape: NDArray[np.float32],
    y: NDArray[np.float32] | None,
    color: NDArray[np.float32] | None = None,
    *,
    y_weight: float = 1.0,
    color_weight: float = 1.0,
    shape_spread: float = 1.0,
    color_spread: float = 1.0,
) -> NDArray[np.float32]:
    """Append the vertical position and the colour descriptor to a shape descriptor.

    The parts have different magnitudes (SIFT reaches 255, HOG 1), and the thesis does not specify their
    weights. So each descriptor is divided by its spread, its module's constant ``SPREAD``. Its total standard
    deviation over indoor regions is then about 1, and parts with equal weights influence a distance equally.

    Parameters
    ----------
    shape
        (n, D) float32.
    y
        (n,) float32: the centre's vertical position divided by the image height, 0 to 1 (top to bottom); None
        to omit it.
    color
        (n, C) float32; None to omit it.
    y_weight, color_weight
        Factors for y and for the colour descriptor, >= 0.
    shape_spread, color_spread
        Spreads of the shape and colour descriptors, > 0; 1 leaves a descriptor unchanged.

    Returns
    -------
    (n, D + 1 + C) float32: shape, y, colour; parts that are None are omitted.

    Raises
    ------
    PlacecatError
        If the parts have different lengths, a weight is negative or a spread is not positive.
    """
    for name, weight in (("y_weight", y_weight), ("color_weight", color_weight)):
        if not (np.isfinite(weight) and weight >= 0):
            raise PlacecatError(f"The setting {name} is {weight}: it must be 0 or more.")
    for name, spread in (("shape_spread", shape_spread), ("color_spread", color_spread)):
        if not (np.isfinite(spread) and spread > 0):
            raise PlacecatError(f"The setting {name} is {spread}: it must be positive.")
    parts = [np.asarray(shape, np.float32) * np.float32(1 / shape_spread)]
    if y is not None:
        parts.append(np.asarray(y, np.float32).reshape(-1, 1) * np.float32(y_weight))
    if color is not None:
        parts.append(np.asarray(color, np.float32) * np.float32(color_weight / color_spread))
    if len({len(part) for part in parts}) > 1:
        lengths = ", ".join(str(len(part)) for part in parts)
        raise PlacecatError(
            f"The parts of a concatenated descriptor have different numbers of regions: {lengths}."
        )
    return np.concatenate(parts, axis=1)
