"""Hierarchical k-means, which grows one tree of clusters and cuts it to the desired number of codewords."""

import heapq
from collections.abc import Mapping, Sequence
from typing import Annotated, Any, Self

import numpy as np
from annotated_types import Interval
from numpy.typing import ArrayLike, NDArray
from sklearn.base import BaseEstimator
from sklearn.utils.validation import check_is_fitted

from placecat.errors import NotComputable, PlacecatError
from placecat.learning.checks import check_samples, check_width
from placecat.learning.kmeans_split import make_root, split_node
from placecat.learning.nearest import nearest_centers
from placecat.learning.single_thread import single_blas_thread
from placecat.ranges import Count, Two
from placecat.schema.signatures import check_parameters


def check_cluster_number(n_clusters: int, branching: int = 16) -> None:
    """Raise PlacecatError if a tree with this branching factor cannot be cut to `n_clusters` clusters.

    Each split replaces one cluster with `branching` clusters, so k splits produce (branching - 1) k + 1
    clusters. The message names the two nearest valid numbers.

    Examples
    --------
    >>> check_cluster_number(91)
    >>> check_cluster_number(100)
    Traceback (most recent call last):
        ...
    placecat.errors.PlacecatError: a tree with branching 16 cannot be cut to n_clusters=100: use 91 or 106
    """
    step = branching - 1
    if n_clusters >= 1 and (n_clusters - 1) % step == 0:
        return
    below = max(0, (int(n_clusters) - 1) // step) * step + 1
    raise PlacecatError(
        f"a tree with branching {branching} cannot be cut to n_clusters={n_clusters}: "
        f"use {below} or {below + step}"
    )


class HierarchicalKMeans(BaseEstimator):
    """Hierarchical k-means as in FLANN, which the thesis uses for codebooks (sections 3.3.2 and 4.2).

    K-means (k-means++ seeds, then Lloyd iterations) splits the points into `branching` clusters, then
    splits each cluster into `branching` smaller ones, and so on. A cut of this tree starts at the root and
    always splits the node whose split most reduces the total variance (the sum of squared distances to the
    centres). Every larger cut begins with the same splits. One tree therefore provides every number of
    clusters of the form (branching - 1) k + 1.

    A node can be split only if it has at least `branching` distinct points. An empty cluster receives the
    point that is farthest from its cluster's centre. A node's centre is the mean of its points. Distances are
    computed in float32 relative to the node's centre, so a split can resolve distances down to about 1/1000
    of the node's radius.

    The tree is grown lazily, which does not change the result. A split gains at most the node's sum of
    squares, so a node is split only when this bound reaches the best known gain. A node's random draws depend
    on its position in the tree, not on the order of the splits.

    Parameters
    ----------
    branching : int
        Number of children per node, 16 in the thesis.
    max_clusters : int
        Number of clusters in the largest cut, of the form (branching - 1) k + 1. The thesis uses at most 991.
    max_iter : int
        Maximum number of Lloyd iterations per split. The thesis does not specify this. The default of 11
        is FLANN's.
    seed : int
        Seed of the k-means++ draws, at least 0.

    Attributes
    ----------
    max_clusters_ : int
        Size of the largest possible cut, which is `max_clusters`, or less if there are too few distinct
        points.
    node_centers_ : ndarray of shape (n_nodes, D), float32
        Centre of each node. Node 0 is the root, and the children of split k start at node 1 + branching k.
    node_sizes_ : ndarray of shape (n_nodes,), int64
        Number of training points in each node.
    node_sse_ : ndarray of shape (n_nodes,), float64
        Sum of the squared distances between each node's training points and its centre.
    split_nodes_ : ndarray of shape (n_splits,), int32
        The node that is split at each step of the cut.
    training_nodes_ : ndarray of shape (n,), int32 or None
        The node of each training point in the largest cut, or None if the tree comes from `from_arrays`.
    n_features_in_ : int
        D.

    References
    ----------
    Muja and Lowe, "Fast approximate nearest neighbors with automatic algorithm configuration", VISAPP 2009.
    Arthur and Vassilvitskii, "k-means++: the advantages of careful seeding", SODA 2007.

    Examples
    --------
    >>> X = np.array([[0, 0], [0, 1], [9, 0], [9, 1], [9, 2]], dtype=np.float32)
    >>> tree = HierarchicalKMeans(branching=2, max_clusters=3).fit(X)
    >>> codes = tree.assign(X, n_clusters=2)
    >>> bool(codes[0] == codes[1] != codes[2] == codes[3] == codes[4])
    True
    >>> tree.centers(3).shape
    (3, 2)
    """

    #: Attributes that stored systems omit, because prediction does not need them.
    TRAINING_ONLY = ("training_nodes_",)
    training_nodes_: NDArray[np.int32] | None = None

    def __init__(
        self,
        branching: Two = 16,
        max_clusters: Count = 991,
        max_iter: Count = 11,
        seed: Annotated[int, Interval(ge=0)] = 0,
    ) -> None:
        self.branching = branching
        self.max_clusters = max_clusters
        self.max_iter = max_iter
        self.seed = seed

    @staticmethod
    def settings_for(numbers: Sequence[int]) -> dict[str, Any]:
        """Return the settings of an estimator that provides these numbers of clusters."""
        return {"max_clusters": max(numbers)}

    def fit(self, X: ArrayLike, y: object = None) -> Self:
        """Grow the tree until it can be cut to `max_clusters`.

        This needs memory for two float32 copies of X. The result is exactly the same for any number of
        threads. `y` is ignored.

        `X` is an (n, D) array of finite descriptors, which are converted to float32. Raises PlacecatError if
        `X` or a setting is invalid.
        """
        check_parameters(self)
        check_cluster_number(self.max_clusters, self.branching)
        points = check_samples(X)
        self.n_features_in_ = points.shape[1]
        n_splits = (self.max_clusters - 1) // (self.branching - 1)
        with single_blas_thread():
            self._grow(points, n_splits)
        return self

    def _grow(self, points: NDArray[np.float32], n_splits: int) -> None:
        root = make_root(points)
        nodes = [root]
        # Entries: (negative gain or bound, whether the gain is known, node). Bounds come before equal gains.
        queue: list[tuple[float, bool, int]] = [(-root.sse, False, 0)]
        split_nodes: list[int] = []
        while queue and len(split_nodes) < n_splits:
            _, gain_known, index = heapq.heappop(queue)
            node = nodes[index]
            if not gain_known:
                rng = np.random.default_rng(np.random.SeedSequence(self.seed, spawn_key=node.path))
                node.children = split_node(node, self.branching, self.max_iter, rng)
                if node.children:
                    gain = node.sse - sum(child.sse for child in node.children)
                    heapq.heappush(queue, (-min(gain, node.sse), True, index))
                continue
            for child in node.children:
                heapq.heappush(queue, (-child.sse, False, len(nodes)))
                nodes.append(child)
            split_nodes.append(index)

        self.node_centers_ = np.array([node.center for node in nodes]).astype(np.float32)
        self.node_sizes_ = np.array([len(node.members) for node in nodes], np.int64)
        self.node_sse_ = np.array([node.sse for node in nodes], np.float64)
        self.split_nodes_ = np.array(split_nodes, np.int32)
        self.max_clusters_ = 1 + (self.branching - 1) * len(split_nodes)
        self.training_nodes_ = training_nodes = np.empty(len(points), np.int32)
        for index in self._cut(self.max_clusters_):
            training_nodes[nodes[index].members] = index

    def centers(self, n_clusters: int) -> NDArray[np.float32]:
        """Return a copy of a cut's centres, (n_clusters, D) float32, in the order of the tree's nodes.

        Raises PlacecatError if no cut has this size, if the tree was not grown that far, or if the training
        data yield fewer clusters. The message names the two nearest sizes or the maximum.
        """
        cut = self._cut(n_clusters)
        return self.node_centers_[cut]

    def assign(self, X: ArrayLike, n_clusters: int) -> NDArray[np.int32]:
        """Assign each point to its codeword, the nearest centre in the cut.

        All centres are compared (see `nearest_centers`), and the lowest index wins ties. The thesis does not
        say whether it descends the tree instead.

        `X` is an (n, D) array of finite descriptors, where n may be 0. Returns (n,) int32 in [0, n_clusters).
        Raises PlacecatError in the same cases as `centers`, and if D differs from that of the training data.
        """
        centers = self.centers(n_clusters)
        points = check_samples(X, least=0)
        check_width(points, self)
        return nearest_centers(points, centers)[:, 0]

    def labels(self, n_clusters: int) -> NDArray[np.int32]:
        """Return each training point's cluster in the cut, as (n,) int32 indices into `centers`.

        This is the partition that k-means found, which differs from `assign` near cluster boundaries. Raises
        PlacecatError in the same cases as `centers`, and also if the tree comes from `from_arrays`.
        """
        cut = self._cut(n_clusters)
        if self.training_nodes_ is None:
            raise PlacecatError(
                "the codebook was loaded without its training points, so it has no labels: use assign"
            )
        code = np.full(len(self.node_centers_), -1, np.int32)
        code[cut] = np.arange(n_clusters, dtype=np.int32)
        # A node is always split after its parent, so one pass in this order reaches every node below the cut.
        for step, node in enumerate(self.split_nodes_):
            if code[node] >= 0:
                code[1 + self.branching * step : 1 + self.branching * (step + 1)] = code[node]
        return code[self.training_nodes_]

    def _cut(self, n_clusters: int) -> NDArray[np.intp]:
        """Return a cut's nodes in ascending order."""
        check_is_fitted(self)
        check_cluster_number(n_clusters, self.branching)
        if n_clusters > self.max_clusters_:
            if self.max_clusters_ == self.max_clusters:
                raise PlacecatError(
                    f"n_clusters={n_clusters} exceeds this tree's max_clusters={self.max_clusters}: "
                    "increase max_clusters and refit"
                )
            raise NotComputable(
                f"{n_clusters} clusters cannot be formed: the training data can be split into at most "
                f"{self.max_clusters_}, and none of these has {self.branching} distinct points"
            )
        n_splits = (n_clusters - 1) // (self.branching - 1)
        in_cut = np.ones(1 + self.branching * n_splits, bool)
        in_cut[self.split_nodes_[:n_splits]] = False
        return np.flatnonzero(in_cut)

    def to_arrays(self) -> dict[str, NDArray[Any]]:
        """Return the tree, without the nodes of the training points, as plain arrays for ``numpy.savez``."""
        check_is_fitted(self)
        settings = {name: np.array(value, np.int64) for name, value in self.get_params().items()}
        return settings | {
            "node_centers": self.node_centers_,
            "node_sizes": self.node_sizes_,
            "node_sse": self.node_sse_,
            "split_nodes": self.split_nodes_,
        }

    @classmethod
    def from_arrays(cls, arrays: Mapping[str, NDArray[Any]]) -> Self:
        """Rebuild a tree from the arrays that `to_arrays` or ``numpy.load`` returns."""
        names = ("branching", "max_clusters", "max_iter", "seed")
        tree = cls(**{name: int(arrays[name]) for name in names})
        tree.node_centers_ = np.asarray(arrays["node_centers"], np.float32)
        tree.node_sizes_ = np.asarray(arrays["node_sizes"], np.int64)
        tree.node_sse_ = np.asarray(arrays["node_sse"], np.float64)
        tree.split_nodes_ = np.asarray(arrays["split_nodes"], np.int32)
        tree.max_clusters_ = 1 + (tree.branching - 1) * len(tree.split_nodes_)
        tree.training_nodes_ = None
        tree.n_features_in_ = tree.node_centers_.shape[1]
        return tree
