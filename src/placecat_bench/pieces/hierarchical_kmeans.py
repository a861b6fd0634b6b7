"""Hierarchical k-means beside FLANN's: the centres of a codebook of SIFT descriptors.

Both split into 16 clusters from k-means++ seeds, with at most 11 of Lloyd's iterations, and cut the tree
where the variance falls most. FLANN grows the tree down to cells of less than 16 points before it cuts; ours
grows as far as the cut needs, which gives the same as cutting a whole tree. The draws of the seeds differ, so
the inertia is compared too: the sum of squared distances of all points to the nearest centre.

The points are the project's SIFT descriptors of random places and scales in frames of a rendered home.
"""

from collections.abc import Iterator
from itertools import islice
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from placecat.errors import PlacecatError
from placecat.footage.recording import Recording
from placecat.learning.hierarchical_kmeans import HierarchicalKMeans
from placecat.learning.nearest import nearest_centers
from placecat.vision.attention import compute_maps
from placecat.vision.local import sift
from placecat_bench.comparison import Comparison, Limit, Peer
from placecat_bench.timing import Latest

PIECE = "Hierarchical k-means"
PEER = Peer("FLANN: hierarchical_kmeans", "pyflann-ibeis")
HOMES = Path("data/homes")
BRANCHING = 16
ITERATIONS = 11
_FRAME_STEP = 13
_REGIONS = 4096
# Points whose differences are in memory at once.
_BLOCK = 1 << 14


def entries(
    *, points: int = 200_000, clusters: tuple[int, int] = (196, 496), homes: Path = HOMES
) -> Iterator[Comparison | Limit]:
    """Yield time and inertia of two cuts; `homes` is a folder of videos.

    The first number of clusters should be 2.5 times faster than FLANN's, the second twice.
    """
    descriptors = draw_descriptors(points, homes)
    for number, faster in zip(clusters, (2.5, 2.0), strict=True):
        yield from _cut(descriptors, number, faster)


def _cut(points: NDArray[np.float32], n_clusters: int, faster: float) -> Iterator[Comparison | Limit]:
    text = f"{len(points)} x {points.shape[1]}, {n_clusters} clusters"
    centers = Latest(ours=lambda: ours(points, n_clusters), theirs=lambda: theirs(points, n_clusters))

    def relative_inertia() -> float:
        return inertia(points, centers.result("ours")) / inertia(points, centers.result("theirs"))

    parts = {"first split": lambda: ours(points, BRANCHING)}
    # No warm-up: FLANN takes half a minute.
    yield Comparison(PIECE, text, PEER, *centers.calls, faster=faster, warm_up=False, parts=parts)
    yield Limit(PIECE, text, "inertia by FLANN's", relative_inertia, at_most=1.02, peer=PEER)


def draw_descriptors(points: int, homes: Path = HOMES, seed: int = 0) -> NDArray[np.float32]:
    """Describe random places and scales in every 13th frame of as many videos as necessary.

    Returns (points, 128) float32, whole numbers from 0 to 255. Raises PlacecatError if the videos have too
    few frames.
    """
    rng = np.random.default_rng(seed)
    parts: list[NDArray[np.float32]] = []
    for frame in islice(_frames(homes), -(-points // _REGIONS)):
        maps = compute_maps(frame, fields=("grey",))
        places = rng.random((_REGIONS, 2)) * (maps.width, maps.height)
        scales = rng.choice(maps.scales, _REGIONS)
        regions = np.column_stack([places, scales, np.ones(_REGIONS)]).astype(np.float32)
        parts.append(sift.describe(maps, regions))
    if len(parts) * _REGIONS < points:
        raise PlacecatError(
            f"{homes}: the videos are too short, they give {len(parts) * _REGIONS} descriptors"
        )
    return np.concatenate(parts)[:points]


def _frames(homes: Path) -> Iterator[NDArray[np.uint8]]:
    for path in sorted(homes.glob("*.mp4")):
        for picture in Recording(path).pictures():
            if (picture.number - 1) % _FRAME_STEP == 0:
                yield picture.image()


def ours(points: NDArray[np.float32], n_clusters: int) -> NDArray[np.float32]:
    """Grow our tree and give the centres of its cut."""
    tree = HierarchicalKMeans(branching=BRANCHING, max_clusters=n_clusters, max_iter=ITERATIONS)
    return tree.fit(points).centers(n_clusters)


def theirs(points: NDArray[np.float32], n_clusters: int) -> NDArray[np.float32]:
    """Give the centres of FLANN's cut, of shape (n_clusters, D), float32."""
    from pyflann_ibeis import FLANN

    splits = (n_clusters - 1) // (BRANCHING - 1)
    found: NDArray[np.float32] = FLANN().hierarchical_kmeans(
        points, BRANCHING, splits, max_iterations=ITERATIONS, centers_init="kmeanspp", random_seed=0
    )
    return found


def inertia(points: NDArray[np.float32], centers: NDArray[np.float32]) -> float:
    """Sum of squared distances of all points to the nearest centre, computed in float64."""
    nearest = nearest_centers(points, centers)[:, 0]
    total = 0.0
    for start in range(0, len(points), _BLOCK):
        block = slice(start, start + _BLOCK)
        total += float(np.square(points[block].astype(np.float64) - centers[nearest[block]]).sum())
    return total
