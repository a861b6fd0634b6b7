"""Split one node of a k-means hierarchy, using k-means++ seeding and Lloyd's algorithm."""

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

# Number of floats per block of points. A block takes 1 MB in float32, half of a level-2 cache.
_BLOCK = 1 << 18
# The float32 result of |x|^2 - 2xc + |c|^2 has too few significant digits if it is below this fraction of
# |x|^2 + |c|^2.
_CANCELLATION = 1e-4


@dataclass
class Node:
    """A cluster in the growing tree. `path` is its position in the tree."""

    path: tuple[int, ...]
    members: NDArray[np.int32]
    # The members' descriptors minus the centre. Empty after the split.
    points: NDArray[np.float32]
    center: NDArray[np.float64]
    sse: float
    children: list["Node"] = field(default_factory=list)


def make_root(points: NDArray[np.float32]) -> Node:
    """Create the root node, which contains all (n, D) points."""
    # Subtract the rounded centre, not the exact mean.
    center = _mean(points).astype(np.float32)
    centred = points - center
    members = np.arange(len(points), dtype=np.int32)
    return Node((), members, centred, center.astype(np.float64), _sum_of_squares(centred))


def split_node(node: Node, branching: int, max_iter: int, rng: np.random.Generator) -> list[Node]:
    """Split a node by k-means. If it has fewer than `branching` distinct points, return no children."""
    points, node.points = node.points, node.points[:0]
    if len(points) < branching:
        return []
    labels = seed_clusters(points, branching, rng)
    if labels is None:
        return []
    labels = lloyd(points, labels, branching, max_iter)
    order = np.argsort(labels, kind="stable")
    ends = np.cumsum(np.bincount(labels, minlength=branching))
    points = np.take(points, order, axis=0)
    members = node.members[order]
    children = []
    for number, (part, own) in enumerate(
        zip(np.split(points, ends[:-1]), np.split(members, ends[:-1]), strict=True)
    ):
        shift = _mean(part).astype(np.float32)
        part -= shift
        children.append(Node((*node.path, number), own, part, node.center + shift, _sum_of_squares(part)))
    return children


def seed_clusters(
    points: NDArray[np.float32], n_clusters: int, rng: np.random.Generator
) -> NDArray[np.uint16] | None:
    """Draw k-means++ seeds, with one trial each as in FLANN. Return the index of each point's nearest seed.

    Returns None if there are too few distinct points.
    """
    n = len(points)
    norms = np.einsum("ij,ij->i", points, points)
    labels = np.zeros(n, np.uint16)
    closest = _squared_distances(points, norms, int(rng.integers(n)))
    for number in range(1, n_clusters):
        cumulated = np.cumsum(closest, dtype=np.float64)
        if cumulated[-1] == 0:
            return None
        seed = int(np.searchsorted(cumulated, rng.random() * cumulated[-1], side="right"))
        if seed == n:
            seed = int(np.searchsorted(cumulated, cumulated[-1]))
        distances = _squared_distances(points, norms, seed)
        labels[distances < closest] = number
        np.minimum(closest, distances, out=closest)
    return labels


def _squared_distances(
    points: NDArray[np.float32], norms: NDArray[np.float32], seed: int
) -> NDArray[np.float32]:
    """Compute the squared distance of every point from one of them. It is exactly 0 for duplicates."""
    distances = points @ points[seed]
    distances *= -2
    distances += norms
    distances += norms[seed]
    close = np.flatnonzero(distances <= _CANCELLATION * (norms + norms[seed]))
    differences = points[close] - points[seed]
    distances[close] = np.einsum("ij,ij->i", differences, differences)
    return distances


def lloyd(
    points: NDArray[np.float32], labels: NDArray[np.uint16], n_clusters: int, max_iter: int
) -> NDArray[np.uint16]:
    """Run k-means iterations from initial labels, keeping at least one point in every cluster."""
    sums = _sums(points, labels, n_clusters)
    for _ in range(max_iter):
        counts = np.bincount(labels, minlength=n_clusters)
        centers = sums / counts[:, None]
        new = nearest(points, centers)
        fill_empty(points, new, centers)
        changed = np.flatnonzero(new != labels)
        if len(changed) == 0:
            break
        if 2 * len(changed) < len(points):
            moved = np.take(points, changed, axis=0)
            sums += _sums(moved, new[changed], n_clusters) - _sums(moved, labels[changed], n_clusters)
        else:
            sums = _sums(points, new, n_clusters)
        labels = new
    return labels


def _blocks(points: NDArray[np.float32]) -> list[slice]:
    rows = max(64, _BLOCK // points.shape[1])
    return [slice(start, start + rows) for start in range(0, len(points), rows)]


def nearest(points: NDArray[np.float32], centers: NDArray[np.float64]) -> NDArray[np.uint16]:
    """Find the nearest of a few (K, D) centres for each of (n, D) points. The lowest index wins ties."""
    # For a handful of centres, the transposed product is faster than nearest_centers.
    half_norms = (0.5 * np.einsum("ij,ij->i", centers, centers))[:, None].astype(np.float32)
    centers32 = centers.astype(np.float32)
    labels = np.empty(len(points), np.uint16)
    for block in _blocks(points):
        scores = centers32 @ points[block].T
        scores -= half_norms
        # Equivalent to scores.argmax(axis=0), but twice as fast.
        labels[block] = (scores == scores.max(axis=0)).argmax(axis=0)
    return labels


def _sums(points: NDArray[np.float32], labels: NDArray[np.integer], n_clusters: int) -> NDArray[np.float64]:
    """Sum the points with each label, in float32 within a block and in float64 across blocks."""
    numbers = np.arange(n_clusters, dtype=labels.dtype)[:, None]
    sums = np.zeros((n_clusters, points.shape[1]))
    for block in _blocks(points):
        sums += (labels[block] == numbers).astype(np.float32) @ points[block]
    return sums


def _mean(points: NDArray[np.float32]) -> NDArray[np.float64]:
    mean: NDArray[np.float64] = _sums(points, np.zeros(len(points), np.uint8), 1)[0] / len(points)
    return mean


def fill_empty(points: NDArray[np.float32], labels: NDArray[np.uint16], centers: NDArray[np.float64]) -> None:
    """Move the point farthest from its cluster's centre to each empty cluster, without emptying another."""
    counts = np.bincount(labels, minlength=len(centers))
    empty = np.flatnonzero(counts == 0)
    if len(empty) == 0:
        return
    differences = points - centers[labels]
    distances = np.einsum("ij,ij->i", differences, differences)
    for number in empty:
        farthest = int(np.argmax(np.where(counts[labels] > 1, distances, -1.0)))
        counts[labels[farthest]] -= 1
        counts[number] = 1
        labels[farthest] = number


def _sum_of_squares(points: NDArray[np.float32]) -> float:
    return float(np.einsum("ij,ij->i", points, points).sum(dtype=np.float64))
