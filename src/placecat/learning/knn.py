"""The modified K-nearest neighbours of thesis 3.3.1.1, based on the class frequencies of clusters."""

from typing import Annotated, Any, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.special import logsumexp
from sklearn.base import BaseEstimator, ClassifierMixin
from sklearn.utils.validation import check_is_fitted

from placecat.errors import PlacecatError
from placecat.learning.checks import check_labels, check_samples, check_width
from placecat.learning.hierarchical_kmeans import HierarchicalKMeans
from placecat.learning.nearest import nearest_centers
from placecat.ranges import Count, NonNegative, OneOf
from placecat.schema.signatures import check_parameters

CLASS_WEIGHTINGS = ("once", "per_region")
# Number of floats per block of differences between points and their neighbours.
_BLOCK = 1 << 20


class ModifiedKNN(ClassifierMixin, BaseEstimator):
    """Modified K-nearest neighbours, whose neighbours are cluster centres with class frequencies.

    For a set of n points x_k, equations (4) and (5) are

        p(l | x_1, ..., x_n) ~ 1 / f(l) * prod_k f(l, x_k),    f(l, x_k) = sum_j f(l, c_j) / |x_k - c_j|

    where j runs over the K centres nearest to x_k. For K = 1 this is equation (2). f(l, c) is the number of
    training points of class l in cluster c, and f(l) is the number of all training points of class l. A
    centre at distance 0 receives all the weight. The computation is done in log space.

    Parameters
    ----------
    n_clusters : int
        Number of clusters, of the form (branching - 1) k + 1 for the branching of the codebook.
    n_neighbors : int
        K, the number of nearest centres.
    smoothing : float
        Number added to every f(l, c), which adds n_clusters times as much to f(l). The thesis does not
        specify this number. If it is 0, a cluster rules out every class that it does not contain. If all
        classes are ruled out, the result is uniform.
    class_weighting : {"once", "per_region"}
        "once" divides by f(l) once, as in equations (2) and (4) and the thesis text. "per_region"
        divides by f(l)^n, which follows from equation (1) with p(c_k | l) = f(c_k, l) / f(l). The two agree
        for single points and for balanced classes. Otherwise, "once" favours frequent classes. This effect
        grows with the number of regions in the frame.
    codebook : HierarchicalKMeans or FlatKMeans, optional
        A fitted codebook. By default, a new tree is grown to `n_clusters` on the training points.
    seed : int
        Random seed of the new tree.

    Attributes
    ----------
    classes_ : ndarray of shape (n_classes,)
    centers_ : ndarray of shape (n_clusters, D), float64
    frequencies_ : ndarray of shape (n_clusters, n_classes), int64
        f(l, c).
    n_features_in_ : int
        D.

    Examples
    --------
    >>> X = np.arange(32, dtype=np.float32).repeat(2)[:, None]
    >>> y = np.where(X[:, 0] < 16, "bathroom", "kitchen")
    >>> model = ModifiedKNN(n_clusters=16).fit(X, y)
    >>> model.predict([[3.0], [30.0]]).tolist()
    ['bathroom', 'kitchen']
    >>> frames = np.array([[[3.0], [4.0]], [[30.0], [0.0]]])
    >>> model.predict_proba_sets(frames, [2, 1]).argmax(axis=1).tolist()
    [0, 1]
    """

    #: Attributes that stored systems omit, because prediction does not need them.
    TRAINING_ONLY = ("codebook", "_pair_distances")
    codebook: Any = None
    _pair_distances: NDArray[np.float64] | None = None

    def __init__(
        self,
        n_clusters: Count = 196,
        n_neighbors: Count = 1,
        smoothing: NonNegative = 1.0,
        class_weighting: Annotated[str, OneOf(CLASS_WEIGHTINGS)] = "per_region",
        codebook: Any = None,
        seed: int = 0,
    ) -> None:
        self.n_clusters = n_clusters
        self.n_neighbors = n_neighbors
        self.smoothing = smoothing
        self.class_weighting = class_weighting
        self.codebook = codebook
        self.seed = seed

    def fit(self, X: ArrayLike, y: ArrayLike) -> Self:
        """Count the classes of the training points in each cluster.

        `X` is an (n, D) array of finite descriptors, and `y` is an (n,) array of classes, which are strings
        or integers. Raises PlacecatError if a setting is invalid, and in the same cases as
        `HierarchicalKMeans.centers`.
        """
        check_parameters(self)
        if self.n_neighbors > self.n_clusters:
            raise PlacecatError(
                f"n_neighbors={self.n_neighbors} exceeds n_clusters={self.n_clusters}: use fewer neighbours"
            )
        points = check_samples(X)
        targets = check_labels(y, len(points))
        codebook = self.codebook
        if codebook is None:
            codebook = HierarchicalKMeans(max_clusters=self.n_clusters, seed=self.seed).fit(points)
        codewords = codebook.assign(points, self.n_clusters)
        self.classes_, labels = np.unique(targets, return_inverse=True)
        n_classes = len(self.classes_)
        cells = codewords.astype(np.int64) * n_classes + labels
        self.frequencies_ = np.bincount(cells, minlength=self.n_clusters * n_classes).reshape(-1, n_classes)
        self.centers_ = codebook.centers(self.n_clusters).astype(np.float64)
        self.n_features_in_ = points.shape[1]
        self._pair_distances = None
        return self

    def predict_proba(self, X: ArrayLike) -> NDArray[np.float64]:
        """Return (n, n_classes) probabilities p(class | x) for (n, D) descriptors; rows sum to 1."""
        check_is_fitted(self)
        points = self._read_points(X)
        return self._normalize(self._log_frequencies(points), np.ones(len(points), np.int64))

    def predict_proba_sets(self, X: NDArray[np.floating], counts: ArrayLike) -> NDArray[np.float64]:
        """Return p(class | x_1, ..., x_n) for each frame's set of descriptors.

        `X` is a (frames, max_regions, D) array of descriptors, and `counts` (frames,) is the number of
        regions in each frame. Rows beyond this number are ignored. Returns (frames, n_classes) float64,
        where each row sums to 1. A frame without regions has a uniform distribution, because the thesis
        assumes uniform priors.
        """
        check_is_fitted(self)
        numbers = np.asarray(counts)
        is_region = np.arange(X.shape[1]) < numbers[:, None]
        logs = np.zeros((*is_region.shape, len(self.classes_)))
        logs[is_region] = self._log_frequencies(self._read_points(X[is_region]))
        return self._normalize(logs.sum(axis=1), numbers)

    def predict(self, X: ArrayLike) -> NDArray[Any]:
        """Return the most probable class of each descriptor, (n,)."""
        best = self.predict_proba(X).argmax(axis=1)
        return self.classes_[best]

    def update(self, x: ArrayLike, label: object) -> Self:
        """Learn one more labelled point at run time.

        `x` is the (D,) point, and `label` is one of `classes_`. If the point is at least as close to its
        nearest centre as the two closest centres are to each other, it joins that centre's cluster, and the
        centre moves to the cluster's mean. Otherwise the two closest clusters merge and the point starts a
        new cluster. The number of clusters and the codebook are left unchanged. Only the distances to centres
        that moved are recomputed.

        Raises PlacecatError if the class is unknown or D differs from that of the training data.
        """
        check_is_fitted(self)
        point = self._read_points(np.asarray(x)[None])[0].astype(np.float64)
        matches = np.flatnonzero(self.classes_ == label)
        if len(matches) != 1:
            raise PlacecatError(
                f"class {label!r} is unknown: use one of {', '.join(map(str, self.classes_))}"
            )
        if self._pair_distances is None:
            self._pair_distances = np.empty((len(self.centers_), len(self.centers_)))
            for cluster in range(len(self.centers_)):
                self._measure(cluster)
        closest = np.unravel_index(self._pair_distances.argmin(), self._pair_distances.shape)
        distances = np.linalg.norm(self.centers_ - point, axis=1)
        nearest = int(distances.argmin())
        if distances[nearest] <= self._pair_distances[closest]:
            size = self.frequencies_[nearest].sum()
            self.centers_[nearest] += (point - self.centers_[nearest]) / (size + 1)
            self.frequencies_[nearest, matches[0]] += 1
            self._measure(nearest)
            return self
        kept, freed = (int(cluster) for cluster in closest)
        sizes = self.frequencies_[[kept, freed]].sum(axis=1)
        # Two empty clusters are weighted equally.
        weights = sizes if sizes.any() else np.ones(2)
        self.centers_[kept] = np.average(self.centers_[[kept, freed]], axis=0, weights=weights)
        self.frequencies_[kept] += self.frequencies_[freed]
        self.centers_[freed] = point
        self.frequencies_[freed] = 0
        self.frequencies_[freed, matches[0]] = 1
        self._measure(kept)
        self._measure(freed)
        return self

    def _measure(self, cluster: int) -> None:
        """Update the distances from one centre to all others. Its distance to itself is set to infinity."""
        assert self._pair_distances is not None
        distances = np.linalg.norm(self.centers_ - self.centers_[cluster], axis=1)
        distances[cluster] = np.inf
        self._pair_distances[cluster] = distances
        self._pair_distances[:, cluster] = distances

    def _read_points(self, X: ArrayLike) -> NDArray[np.float32]:
        points = check_samples(X, least=0)
        check_width(points, self)
        return points

    def _log_frequencies(self, points: NDArray[np.float32]) -> NDArray[np.float64]:
        """Return the (n, n_classes) log f(l, x_k) of equation (5), up to a term common to all classes."""
        frequencies = self.frequencies_ + self.smoothing
        neighbors = nearest_centers(points, self.centers_, self.n_neighbors)
        with np.errstate(divide="ignore"):
            if self.n_neighbors == 1:
                # With one neighbour, the weight is the same for all classes, so it can be left out.
                return np.log(frequencies)[neighbors[:, 0]]
            interpolated = np.empty((len(points), len(self.classes_)))
            rows = max(1, _BLOCK // (self.n_neighbors * self.n_features_in_))
            for start in range(0, len(points), rows):
                part = slice(start, start + rows)
                differences = points[part, None, :] - self.centers_[neighbors[part]]
                distances = np.sqrt(np.einsum("nkd,nkd->nk", differences, differences))
                at_center = distances == 0
                weights = np.where(at_center.any(axis=1, keepdims=True), at_center, 1 / distances)
                interpolated[part] = np.einsum("nk,nkl->nl", weights, frequencies[neighbors[part]])
            return np.log(interpolated)

    def _normalize(self, logs: NDArray[np.float64], n_regions: NDArray[np.int64]) -> NDArray[np.float64]:
        """Divide by f(l), once or per region, and then by the sum over classes."""
        log_class = np.log((self.frequencies_ + self.smoothing).sum(axis=0))
        powers = np.minimum(n_regions, 1) if self.class_weighting == "once" else n_regions
        logs = logs - powers[:, None] * log_class
        logs[np.isneginf(logs).all(axis=1)] = 0
        return np.exp(logs - logsumexp(logs, axis=1, keepdims=True))
