"""The nearest of some centres to each point, exactly, by blocked matrix products."""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from placecat.learning.products import RowProducts

# Floats of one block of scores: 4 MB of float32, about a level-2 cache and a level-3 slice.
_BLOCK = 1 << 20


def nearest_centers(X: ArrayLike, centers: NDArray[np.floating], n_neighbors: int = 1) -> NDArray[np.int32]:
    """Find the nearest centres of each point, nearest first.

    Every centre is compared (no tree descent, no approximation). The comparison is in float32 after the
    centres' mean is taken off both sides, so centres whose distances differ by less than float32 resolves
    count as equal; of equal ones the lowest index comes first. What a point gets does not depend on the
    other points.

    Parameters
    ----------
    X : array-like of shape (n, D), float32
        Points, finite.
    centers : ndarray of shape (N, D)
        Centres.
    n_neighbors : int
        How many, in [1, N].

    Returns
    -------
    ndarray of shape (n, n_neighbors), int32
        Indices into `centers`.

    Examples
    --------
    >>> import numpy as np
    >>> centers = np.array([[0.0, 0.0], [4.0, 0.0], [9.0, 0.0]])
    >>> nearest_centers([[1.0, 0.0], [2.0, 0.0], [8.0, 0.0]], centers, 2)
    array([[0, 1],
           [0, 1],
           [2, 1]], dtype=int32)
    """
    points = np.asarray(X, dtype=np.float32)
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
