"""Flat k-means, compared with hierarchical clustering in thesis 4.2."""

from collections.abc import Mapping, Sequence
from typing import Annotated, Any, Self

import numpy as np
from annotated_types import Interval, MinLen
from numpy.typing import ArrayLike, NDArray
from sklearn.base import BaseEstimator
from sklearn.utils.validation import check_is_fitted
from threadpoolctl import threadpool_limits

from placecat.errors import NotComputable, PlacecatError
from placecat.learning.checks import check_samples, check_width
from placecat.learning.nearest import nearest_centers
from placecat.ranges import Count
from placecat.schema.signatures import check_parameters


class FlatKMeans(BaseEstimator):
    """scikit-learn's k-means with k-means++ seeds, run once for each number of clusters.

    Classifiers use it through the same interface as
    :class:`~placecat.learning.hierarchical_kmeans.HierarchicalKMeans`.

    Parameters
    ----------
    numbers : sequence of int
        Numbers of clusters for which k-means is run.
    max_iter : int
        Maximum number of Lloyd iterations. The thesis does not specify this. The default of 11 matches
        that of hierarchical clustering, so that the two differ only in the hierarchy.
    seed : int
        Random seed, at least 0. The random draws for each number of clusters are independent.

    Attributes
    ----------
    centers_ : dict of int to ndarray of shape (number, D), float32
        There is no entry for a number of clusters that exceeds the number of training points.
    n_points_ : int
        Number of training points.
    n_features_in_ : int

    Examples
    --------
    >>> X = np.array([[0.0], [0.1], [5.0], [5.1]], dtype=np.float32)
    >>> codes = FlatKMeans(numbers=(2,)).fit(X).assign(X, 2)
    >>> bool(codes[0] == codes[1] != codes[2] == codes[3])
    True
    """

    def __init__(
        self,
        numbers: Annotated[Sequence[Count], MinLen(1)] = (46,),
        max_iter: Count = 11,
        seed: Annotated[int, Interval(ge=0)] = 0,
    ) -> None:
        self.numbers = numbers
        self.max_iter = max_iter
        self.seed = seed

    @staticmethod
    def settings_for(numbers: Sequence[int]) -> dict[str, Any]:
        """Return the settings of an estimator that provides these numbers of clusters."""
        return {"numbers": tuple(sorted(set(numbers)))}

    def fit(self, X: ArrayLike, y: object = None) -> Self:
        """Cluster finite (n, D) descriptors in float32, once for each number of clusters.

        Raises PlacecatError if a setting is invalid.
        """
        from sklearn.cluster import KMeans

        check_parameters(self)
        points = check_samples(X)
        self.n_features_in_ = points.shape[1]
        self.n_points_ = len(points)
        self.centers_: dict[int, NDArray[np.float32]] = {}
        # Use one thread, because the number of threads can change the last bits of a sum.
        with threadpool_limits(limits=1):
            for number in self.numbers:
                if number > len(points):
                    continue
                state = np.random.RandomState(np.random.MT19937(np.random.SeedSequence([self.seed, number])))
                found = KMeans(
                    number, init="k-means++", n_init=1, max_iter=self.max_iter, random_state=state
                ).fit(points)
                self.centers_[number] = np.asarray(found.cluster_centers_, np.float32)
        return self

    def centers(self, n_clusters: int) -> NDArray[np.float32]:
        """Return the centres of one clustering, (n_clusters, D) float32.

        Raises
        ------
        NotComputable
            If there are fewer training points than clusters.
        PlacecatError
            If `n_clusters` is not one of `numbers`.
        """
        check_is_fitted(self)
        if n_clusters in self.centers_:
            return self.centers_[n_clusters]
        if n_clusters in self.numbers:
            raise NotComputable(
                f"{n_clusters} clusters need at least that many points, but there are only {self.n_points_}"
            )
        raise PlacecatError(
            f"n_clusters={n_clusters} was not computed: use one of {', '.join(map(str, self.numbers))}"
        )

    def assign(self, X: ArrayLike, n_clusters: int) -> NDArray[np.int32]:
        """Return the index of the nearest centre, in [0, n_clusters), for each of (n, D) points."""
        points = check_samples(X, least=0)
        check_width(points, self)
        return nearest_centers(points, self.centers(n_clusters))[:, 0]

    def to_arrays(self) -> dict[str, NDArray[Any]]:
        """Return the clusterings as plain arrays, for ``numpy.savez``."""
        check_is_fitted(self)
        arrays = {
            "numbers": np.array(self.numbers, np.int64),
            "max_iter": np.array(self.max_iter, np.int64),
            "seed": np.array(self.seed, np.int64),
            "n_points": np.array(self.n_points_, np.int64),
            "n_features": np.array(self.n_features_in_, np.int64),
        }
        return arrays | {f"centers_{number}": centers for number, centers in self.centers_.items()}

    @classmethod
    def from_arrays(cls, arrays: Mapping[str, NDArray[Any]]) -> Self:
        """Rebuild the clusterings from the arrays that `to_arrays` or ``numpy.load`` returns."""
        numbers = tuple(arrays["numbers"].tolist())
        model = cls(numbers, int(arrays["max_iter"]), int(arrays["seed"]))
        model.n_points_, model.n_features_in_ = int(arrays["n_points"]), int(arrays["n_features"])
        model.centers_ = {
            number: arrays[f"centers_{number}"] for number in numbers if f"centers_{number}" in arrays
        }
        return model
