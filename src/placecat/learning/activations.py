"""Find the clusters that a frame's regions activate."""

import numpy as np
from numpy.typing import NDArray


def activations(codewords: NDArray[np.integer], n_clusters: int) -> NDArray[np.uint8]:
    """Mark the clusters that each frame's regions activate (q_k in thesis section 3.3.2).

    `codewords` is a (frames, max_regions) array of integers in [0, n_clusters), padded with -1. Returns a
    (frames, n_clusters) uint8 array, with 1 where at least one region of the frame has the codeword.

    Examples
    --------
    >>> activations(np.array([[2, 0, 2], [1, -1, -1]]), 3).tolist()
    [[1, 0, 1], [0, 1, 0]]
    """
    frames, regions = np.nonzero(codewords >= 0)
    active = np.zeros((len(codewords), n_clusters), np.uint8)
    active[frames, codewords[frames, regions]] = 1
    return active
