"""Exact search for the centres nearest to each point, using blocked matrix products."""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from placecat.learning.memory import content, remembered
from placecat.learning.products import RowProducts

# Number of floats per block of scores. A block takes 4 MB in float32, about a level-2 cache plus a level-3
# slice.
_BLOCK = 1 << 20


def nearest_centers(X: ArrayLike, centers: NDArray[np.floating], n_neighbors: int = 1) -> NDArray[np.int32]:
    """Find each point's nearest centres, nearest first.

    All centres are compared in float32, after their mean is subtracted. Distances that float32 cannot
    distinguish count as equal, and the lowest index wins ties. The result for a point does not depend on
    other points.

    `X` is an (n, D) array of finite points, `centers` is (N, D), and `n_neighbors` is in [1, N]. Returns
    (n, n_neighbors) int32 indices into `centers`.

    Examples
    --------
    >>> centers = np.array([[0.0, 0.0], [4.0, 0.0], [9.0, 0.0]])
    >>> nearest_centers([[1.0, 0.0], [2.0, 0.0], [8.0, 0.0]], centers, 2)
    array([[0, 1],
           [0, 1],
           [2, 1]], dtype=int32)
    """
    points = np.asarray(X, dtype=np.float32)
    return remembered(
        "nearest",
        (content(points), content(centers.astype(np.float64)), n_neighbors),
        lambda: _compare_all(points, centers, n_neighbors),
    )


def _compare_all(
    points: NDArray[np.float32], centers: NDArray[np.floating], n_neighbors: int
) -> NDArray[np.int32]:
    origin = centers.mean(axis=0, dtype=np.float64).astype(np.float32)
    shifted = centers.astype(np.float64) - origin
    half_norms = (0.5 * np.einsum("ij,ij->i", shifted, shifted)).astype(np.float32)
    products = RowProducts(shifted.astype(np.float32))
    found = np.empty((len(points), n_neighbors), np.int32)
    rows = max(1, _BLOCK // max(centers.shape))
    for start in range(0, len(points), rows):
        scores = products(points[start : start + rows] - origin)
        scores -= half_norms
        for rank in range(n_neighbors):
            best = scores.argmax(axis=1)
            found[start : start + rows, rank] = best
            if rank + 1 < n_neighbors:
                scores[np.arange(len(best)), best] = -np.inf
    return found
