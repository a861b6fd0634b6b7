"""The toy problem of thesis 4.8: four disjoint circles in the plane and the area around them."""

import numpy as np
from numpy.typing import NDArray

CENTRES = ((-2.0, -2.0), (-2.0, 2.0), (2.0, -2.0), (2.0, 2.0))
# Of the classes in order.
NAMES = ("circle_1", "circle_2", "circle_3", "circle_4", "around")


def toy_circles(
    n: int, seed: int, radius: float = 0.5, half_width: float = 4.0, around: float = 0.5
) -> tuple[NDArray[np.float64], NDArray[np.int16]]:
    """Draw points of the five classes, uniformly within each.

    The thesis does not give centres, radii, area or counts. Here: centres (+-2, +-2), radius 0.5, the square
    [-4, 4]^2, half of the points around the circles and an eighth in each (so that nu = 0.2 is feasible).
    With gamma = 2 and 2000 points this gives about the thesis's accuracies.

    Parameters
    ----------
    n
        Points, at least 16.
    seed
        Of the generator.
    radius
        Of each circle; below 2 they are disjoint.
    half_width
        Half the side of the square.
    around
        Share of the points around the circles, between 0 and 1. 0.2 makes the classes equal.

    Returns
    -------
    X, y
        (n, 2) float64, and (n,) int16: 0 to 3 the circles in the order of `CENTRES`, 4 the area around.
        Sorted by class.

    Examples
    --------
    >>> X, y = toy_circles(800, seed=1)
    >>> X.shape, np.bincount(y).tolist()
    ((800, 2), [100, 100, 100, 100, 400])
    """
    rng = np.random.default_rng(seed)
    in_circle = [round(n * (1.0 - around) / 4)] * 4
    y = np.repeat(np.arange(5, dtype=np.int16), [*in_circle, n - sum(in_circle)])
    parts = []
    for centre, count in zip(CENTRES, in_circle, strict=True):
        distance = radius * np.sqrt(rng.random(count))
        angle = 2.0 * np.pi * rng.random(count)
        parts.append(
            np.array(centre) + np.stack([distance * np.cos(angle), distance * np.sin(angle)], axis=1)
        )
    needed = n - sum(in_circle)
    rest = np.empty((0, 2))
    while len(rest) < needed:
        points = rng.uniform(-half_width, half_width, (2 * needed, 2))
        inside = [np.hypot(*(points - np.array(centre)).T) <= radius for centre in CENTRES]
        rest = np.concatenate([rest, points[~np.any(inside, axis=0)]])
    return np.concatenate([*parts, rest[:needed]]), y
