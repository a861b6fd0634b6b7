"""Hierarchical k-means, which finds the centres of a codebook of SIFT descriptors, compared with three peers.

FLANN and our code split each cluster into 16, from k-means++ seeds and with at most 11 Lloyd iterations. They
cut the tree where this reduces the variance most. FLANN first grows the tree down to cells of fewer than 16
points, and then cuts it. Our code grows it only as far as the cut needs, with the same result. The seeds are
drawn in different ways, so the inertias are compared, too. Inertia is the sum of the squared distances from
all points to their nearest centres.

Two more peers find the same number of centres without such a tree: the hierarchical mode of superkmeans with
its default iterations (3 coarse, 5 fine), and the flat k-means of faiss with our number of iterations on all
points. Their run times are comparable with ours if their inertia is the same.

The points are SIFT descriptors at random positions and scales in frames of rendered homes.
"""

from collections.abc import Callable, Iterator
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
from placecat_bench.frames import HOMES
from placecat_bench.timing import Latest

PIECE = "Hierarchical k-means"
PEER = Peer("FLANN: hierarchical_kmeans", "pyflann-ibeis")
SUPERKMEANS = Peer("superkmeans: SuperKMeans, hierarchical", "superkmeans")
FAISS = Peer("faiss: Kmeans", "faiss-cpu")
BRANCHING = 16
ITERATIONS = 11
_FRAME_STEP = 13
_REGIONS = 4096
# Number of points processed at once.
_BLOCK = 1 << 14


def entries(
    *, points: int = 200_000, clusters: tuple[int, int] = (196, 496), homes: Path = HOMES
) -> Iterator[Comparison | Limit]:
    """Yield comparisons of the run time and inertia of two cuts; `homes` is a folder of videos.

    The target is to be 2.5 times as fast as FLANN for the first number of clusters and twice as fast for the
    second.
    """
    descriptors = draw_descriptors(points, homes)
    for number, faster in zip(clusters, (2.5, 2.0), strict=True):
        yield from _cut(descriptors, number, PEER, theirs, faster)
        yield from _cut(descriptors, number, SUPERKMEANS, by_superkmeans, 1)
        yield from _cut(descriptors, number, FAISS, by_faiss, 1)


def _cut(
    points: NDArray[np.float32],
    n_clusters: int,
    peer: Peer,
    call: Callable[[NDArray[np.float32], int], NDArray[np.float32]],
    faster: float,
) -> Iterator[Comparison | Limit]:
    text = f"{len(points)} x {points.shape[1]}, {n_clusters} clusters"
    our, their = Latest(ours, points, n_clusters), Latest(call, points, n_clusters)
    parts = {"first split": lambda: ours(points, BRANCHING)}
    # FLANN takes half a minute.
    yield Comparison(PIECE, text, peer, our, their, faster=faster, warm_up=False, parts=parts)

    def relative_inertia() -> float:
        return inertia(points, our.result()) / inertia(points, their.result())

    quantity = f"inertia relative to {peer.name.partition(':')[0]}'s"
    yield Limit(PIECE, text, quantity, relative_inertia, at_most=1.02, peer=peer)


def draw_descriptors(points: int, homes: Path) -> NDArray[np.float32]:
    """Describe every 13th frame at random positions and scales, in as many videos as necessary.

    Returns a (points, 128) float32 array of whole numbers from 0 to 255. Raises PlacecatError if the videos
    have too few frames.
    """
    rng = np.random.default_rng(0)
    parts: list[NDArray[np.float32]] = []
    for frame in islice(_frames(homes), -(-points // _REGIONS)):
        maps = compute_maps(frame, fields=("grey",))
        places = rng.random((_REGIONS, 2)) * (maps.width, maps.height)
        scales = rng.choice(maps.scales, _REGIONS)
        regions = np.column_stack([places, scales, np.ones(_REGIONS)]).astype(np.float32)
        parts.append(sift.describe(maps, regions))
    if len(parts) * _REGIONS < points:
        raise PlacecatError(
            f"{homes}: the videos are too short for more than {len(parts) * _REGIONS} descriptors"
        )
    return np.concatenate(parts)[:points]


def _frames(homes: Path) -> Iterator[NDArray[np.uint8]]:
    for path in sorted(homes.glob("*.mp4")):
        for picture in Recording(path).pictures():
            if (picture.number - 1) % _FRAME_STEP == 0:
                yield picture.image()


def ours(points: NDArray[np.float32], n_clusters: int) -> NDArray[np.float32]:
    """Grow and cut our tree, and return the centres."""
    tree = HierarchicalKMeans(branching=BRANCHING, max_clusters=n_clusters, max_iter=ITERATIONS)
    return tree.fit(points).centers(n_clusters)


def theirs(points: NDArray[np.float32], n_clusters: int) -> NDArray[np.float32]:
    """Return the (n_clusters, D) float32 centres of FLANN's cut."""
    from pyflann_ibeis import FLANN

    splits = (n_clusters - 1) // (BRANCHING - 1)
    found: NDArray[np.float32] = FLANN().hierarchical_kmeans(
        points, BRANCHING, splits, max_iterations=ITERATIONS, centers_init="kmeanspp", random_seed=0
    )
    return found


def by_superkmeans(points: NDArray[np.float32], n_clusters: int) -> NDArray[np.float32]:
    """Return the (n_clusters, D) float32 centres that superkmeans finds."""
    from superkmeans import SuperKMeans

    model = SuperKMeans(n_clusters, points.shape[1], hierarchical=True, n_threads=1)
    return np.asarray(model.train(points))


def by_faiss(points: NDArray[np.float32], n_clusters: int) -> NDArray[np.float32]:
    """Return the (n_clusters, D) float32 centres that faiss finds."""
    import faiss

    faiss.omp_set_num_threads(1)
    # By default, faiss uses at most 256 points per centre.
    own = {"niter": ITERATIONS, "max_points_per_centroid": len(points)}
    model = faiss.Kmeans(points.shape[1], n_clusters, seed=0, **own)
    model.train(points)
    return np.asarray(model.centroids)


def inertia(points: NDArray[np.float32], centers: NDArray[np.float32]) -> float:
    """Return the sum of the squared distances from all points to their nearest centres, in float64."""
    nearest = nearest_centers(points, centers)[:, 0]
    total = 0.0
    for start in range(0, len(points), _BLOCK):
        block = slice(start, start + _BLOCK)
        total += float(np.square(points[block].astype(np.float64) - centers[nearest[block]]).sum())
    return total
