"""Handle padded arrays of salient regions and the clusters that a frame's regions activate."""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from placecat.errors import PlacecatError

# Size of one block of padded descriptors, in bytes.
_BLOCK = 1 << 26


def region_mask(counts: ArrayLike, max_regions: int) -> NDArray[np.bool_]:
    """Mark the rows of padded arrays that hold a region: (frames, max_regions) bool.

    `counts` holds each frame's number of regions, (frames,) integers; a frame's regions fill its first rows.
    Raises PlacecatError for a count outside [0, max_regions].

    Examples
    --------
    >>> region_mask([2, 0], 3).tolist()
    [[True, True, False], [False, False, False]]
    """
    numbers = np.asarray(counts)
    if numbers.ndim != 1 or numbers.dtype.kind not in "iu":
        raise PlacecatError("counts must hold one whole number per frame")
    wrong = np.flatnonzero((numbers < 0) | (numbers > max_regions))
    if len(wrong):
        raise PlacecatError(
            f"counts[{wrong[0]}]={numbers[wrong[0]]} is invalid: a frame has 0 to {max_regions} regions"
        )
    return np.arange(max_regions) < numbers[:, None]


def activations(codewords: NDArray[np.integer], n_clusters: int, counts: ArrayLike) -> NDArray[np.uint8]:
    """Mark the clusters that each frame's regions activate: q_k of thesis section 3.3.2.

    `codewords` holds (frames, max_regions) integers, and `counts` each frame's number of regions, (frames,)
    integers; codewords after a frame's last region are ignored. Returns (frames, n_clusters) uint8, 1 where
    at least one region of the frame has the codeword. Raises PlacecatError if the shapes do not match, or a
    codeword is out of range.

    Examples
    --------
    >>> activations(np.array([[2, 0, 2], [1, -1, -1]]), 3, counts=[3, 1]).tolist()
    [[1, 0, 1], [0, 1, 0]]
    """
    if codewords.ndim != 2 or len(codewords) != len(np.asarray(counts)):
        raise PlacecatError("codewords must have the shape (frames, max_regions), and counts (frames,)")
    mask = region_mask(counts, codewords.shape[1])
    words = codewords[mask]
    if len(words) and (words.min() < 0 or words.max() >= n_clusters):
        raise PlacecatError(
            f"codewords range from {words.min()} to {words.max()}, not within [0, {n_clusters}): "
            "check n_clusters"
        )
    active = np.zeros((len(mask), n_clusters), np.uint8)
    active[np.nonzero(mask)[0], words.astype(np.intp)] = 1
    return active


def check_regions(X: NDArray[np.floating], counts: ArrayLike) -> NDArray[np.bool_]:
    """Return the `region_mask` of padded descriptors; raises PlacecatError if X and counts disagree."""
    if X.ndim != 3 or len(X) != len(np.asarray(counts)):
        raise PlacecatError(
            f"X has the shape {X.shape} and counts {np.shape(counts)}: "
            "they must be (frames, max_regions, D) and (frames,)"
        )
    return region_mask(counts, X.shape[1])


def frame_blocks(X: NDArray[np.floating]) -> list[slice]:
    """Split the frames of padded descriptors into blocks of about 64 MB."""
    step = max(1, _BLOCK // max(1, X[:1].nbytes))
    return [slice(start, start + step) for start in range(0, len(X), step)]
