"""From the regions of frames to codewords, and from codewords to the clusters a frame activates."""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from placecat.errors import PlacecatError
from placecat.learning.hierarchical_kmeans import HierarchicalKMeans

# Bytes of padded descriptors taken from their frames at once.
_BLOCK = 1 << 26


def region_mask(counts: ArrayLike, max_regions: int) -> NDArray[np.bool_]:
    """Mark the places that hold a region in padded arrays.

    Parameters
    ----------
    counts : array-like of shape (frames,), integers in [0, max_regions]
        Regions of each frame; they come first in its row.
    max_regions : int

    Returns
    -------
    ndarray of shape (frames, max_regions), bool

    Raises
    ------
    PlacecatError
        If a count is out of range.

    Examples
    --------
    >>> region_mask([2, 0], 3).tolist()
    [[True, True, False], [False, False, False]]
    """
    numbers = np.asarray(counts)
    if numbers.ndim != 1 or numbers.dtype.kind not in "iu":
        raise PlacecatError("counts must hold one whole number a frame")
    wrong = np.flatnonzero((numbers < 0) | (numbers > max_regions))
    if len(wrong):
        raise PlacecatError(
            f"counts[{wrong[0]}]={numbers[wrong[0]]} does not fit the {max_regions} places of a frame"
        )
    return np.arange(max_regions) < numbers[:, None]


def region_codewords(
    codebook: HierarchicalKMeans, X: NDArray[np.floating], counts: ArrayLike, n_clusters: int
) -> NDArray[np.int32]:
    """Assign each region of each frame to its codeword.

    Parameters
    ----------
    codebook : HierarchicalKMeans
        Fitted.
    X : ndarray of shape (frames, max_regions, D)
        Descriptors; what lies beyond a frame's count is not read.
    counts : array-like of shape (frames,), integers
        Regions of each frame.
    n_clusters : int
        A cut of the codebook.

    Returns
    -------
    ndarray of shape (frames, max_regions), int32
        Codewords in [0, n_clusters); -1 where there is no region.

    Raises
    ------
    PlacecatError
        As `region_mask` and `HierarchicalKMeans.assign`, or if X and counts disagree.
    """
    mask = check_regions(X, counts)
    codewords = np.full(mask.shape, -1, np.int32)
    for part in frame_blocks(X):
        codewords[part][mask[part]] = codebook.assign(X[part][mask[part]], n_clusters)
    return codewords


def cell_codewords(
    codebooks: list[HierarchicalKMeans], X: NDArray[np.floating], n_clusters: int
) -> NDArray[np.int32]:
    """Assign each image cell of each frame to a codeword of that cell's own codebook (thesis section 4.2).

    Parameters
    ----------
    codebooks : list of HierarchicalKMeans
        One for each of V cells, fitted.
    X : ndarray of shape (frames, V, D)
        Each cell's part of the holistic descriptor.
    n_clusters : int
        A cut of every codebook.

    Returns
    -------
    ndarray of shape (frames, V), int32
        Codewords in [0, n_clusters).

    Raises
    ------
    PlacecatError
        As `HierarchicalKMeans.assign`, or if X has not one cell for each codebook.
    """
    if X.ndim != 3 or X.shape[1] != len(codebooks):
        raise PlacecatError(f"X has shape {X.shape}: {len(codebooks)} codebooks need (frames, cells, D)")
    return np.stack(
        [codebook.assign(X[:, cell], n_clusters) for cell, codebook in enumerate(codebooks)], axis=1
    )


def activations(
    codewords: ArrayLike,
    n_clusters: int,
    *,
    counts: ArrayLike | None = None,
    offsets: ArrayLike | None = None,
) -> NDArray[np.uint8]:
    """Tell which clusters each frame's regions activate: q_k of thesis section 3.3.2.

    Parameters
    ----------
    codewords : array-like of integers
        Padded, shape (frames, max_regions), with `counts`; or one after the other, shape (n_regions,), with
        `offsets`.
    n_clusters : int
        N, the number of codewords.
    counts : array-like of shape (frames,), integers
        Regions of each frame in a padded array; what lies beyond is not read.
    offsets : array-like of shape (frames + 1,), integers
        Frame i has the regions ``codewords[offsets[i]:offsets[i + 1]]``.

    Returns
    -------
    ndarray of shape (frames, N), uint8
        1 where at least one region of the frame has the codeword, else 0.

    Raises
    ------
    PlacecatError
        If neither or both of counts and offsets are given, if they do not fit, or if a codeword is out of
        range.

    Examples
    --------
    >>> activations([[2, 0, 2], [1, -1, -1]], 3, counts=[3, 1]).tolist()
    [[1, 0, 1], [0, 1, 0]]
    >>> activations([2, 0, 2, 1], 3, offsets=[0, 3, 3, 4]).tolist()
    [[1, 0, 1], [0, 0, 0], [0, 1, 0]]
    """
    words = np.asarray(codewords)
    if counts is not None and offsets is None:
        if words.ndim != 2 or len(words) != len(np.asarray(counts)):
            raise PlacecatError("codewords with counts must have the shape (frames, max_regions)")
        mask = region_mask(counts, words.shape[1])
        frames = np.nonzero(mask)[0]
        words = words[mask]
        n_frames = len(mask)
    elif offsets is not None and counts is None:
        bounds = np.asarray(offsets)
        if words.ndim != 1 or bounds.ndim != 1 or len(bounds) == 0:
            raise PlacecatError("codewords with offsets must have the shape (n_regions,)")
        lengths = np.diff(bounds)
        if bounds[0] != 0 or bounds[-1] != len(words) or (lengths < 0).any():
            raise PlacecatError(f"offsets must rise from 0 to the number of codewords, {len(words)}")
        n_frames = len(lengths)
        frames = np.repeat(np.arange(n_frames), lengths)
    else:
        raise PlacecatError(
            "give either counts (padded codewords) or offsets (codewords one after the other)"
        )
    if len(words) and (words.min() < 0 or words.max() >= n_clusters):
        raise PlacecatError(
            f"codewords lie in [{words.min()}, {words.max()}], outside [0, {n_clusters}): check n_clusters"
        )
    active = np.zeros((n_frames, n_clusters), np.uint8)
    active[frames, words.astype(np.intp)] = 1
    return active


def check_regions(X: NDArray[np.floating], counts: ArrayLike) -> NDArray[np.bool_]:
    """Return `region_mask` of padded descriptors, or raise PlacecatError where X and counts disagree."""
    if X.ndim != 3 or len(X) != len(np.asarray(counts)):
        raise PlacecatError(
            f"X has shape {X.shape}, counts {np.shape(counts)}: "
            "(frames, max_regions, D) and (frames,) are needed"
        )
    return region_mask(counts, X.shape[1])


def frame_blocks(X: NDArray[np.floating]) -> list[slice]:
    """Cut the frames of padded descriptors into blocks of about 64 MB."""
    step = max(1, _BLOCK // max(1, X[:1].nbytes))
    return [slice(start, start + step) for start in range(0, len(X), step)]
