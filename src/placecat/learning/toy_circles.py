"""The toy problem of thesis 4.8, with four disjoint circles in the plane and the area around them."""

import math

import numpy as np
from numpy.typing import NDArray

# Class names, in the order of the labels.
NAMES = ("circle_1", "circle_2", "circle_3", "circle_4", "around")
# The centres of the circles, in class order. The unit is half the side length of the square.
_MIDDLES = ((-0.5, -0.5), (-0.5, 0.5), (0.5, -0.5), (0.5, 0.5))


def toy_circles(
    n: int, seed: int, radius: float = 1.0, inside: float = 0.5
) -> tuple[NDArray[np.float64], NDArray[np.int16]]:
    """Draw points uniformly from a square that has a circle in the middle of each quadrant.

    The thesis does not specify the centres, radii, area or counts. conf/toy explains our choices.

    Parameters
    ----------
    n
        Number of points, at least 1.
    seed
        Seed of the random number generator.
    radius
        Radius of each circle, above 0.
    inside
        Share of the square that the circles cover, above 0 and below pi / 4 (where they touch). Half the side
        length of the square is ``radius sqrt(pi / inside)``.

    Returns
    -------
    X, y
        (n, 2) float64 points and (n,) int16 labels. Labels 0 to 3 are the circles (lower left, upper left,
        lower right, upper right), and 4 is the area around them.

    Examples
    --------
    >>> X, y = toy_circles(800, seed=1)
    >>> X.shape, np.bincount(y).tolist()
    ((800, 2), [103, 98, 90, 101, 408])
    """
    half = radius * math.sqrt(math.pi / inside)
    X = np.random.default_rng(seed).uniform(-half, half, (n, 2))
    y = np.full(n, len(_MIDDLES), np.int16)
    for label, middle in enumerate(_MIDDLES):
        y[np.hypot(*(X - half * np.array(middle)).T) <= radius] = label
    return X, y
