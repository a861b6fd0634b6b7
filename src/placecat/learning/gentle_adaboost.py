"""Gentle AdaBoost with regression stumps on binned features."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Annotated, Any, Self

import numpy as np
from annotated_types import Interval
from numpy.typing import ArrayLike, NDArray
from sklearn.base import BaseEstimator, ClassifierMixin, clone
from sklearn.utils.validation import check_is_fitted

from placecat.learning.boosting import Boosting, Task
from placecat.learning.checks import check_samples, check_width
from placecat.learning.memory import bytes_of, remembered
from placecat.learning.stumps import BinnedFeatures, Stump, bin_features
from placecat.learning.two_class import TwoClass
from placecat.ranges import Count, PositiveShare


@dataclass(frozen=True)
class StumpEnsembles:
    """K boosted sums of stumps, F_k(x) = sum_t (high[k, t] if x[feature] > threshold else low[k, t]).

    All arrays have the shape (K, T).
    """

    feature: NDArray[np.int64]
    threshold: NDArray[np.float32]
    low: NDArray[np.float64]
    high: NDArray[np.float64]
    #: D, the number of features.
    width: int

    def decisions(self, X: NDArray[np.float32]) -> NDArray[np.float64]:
        """Evaluate all K sums for (n, D) samples, and return (n, K) float64 values."""
        result = np.empty((len(X), len(self.feature)))
        for k in range(len(self.feature)):
            above = np.take(X, self.feature[k], axis=1) > self.threshold[k]
            # Add the stumps one by one, as `decide_rows` does. A sum along the axis might use a different
            # order.
            result[:, k] = np.cumsum(np.where(above, self.high[k], self.low[k]), axis=1)[:, -1]
        return result


class GentleAdaBoost(TwoClass, ClassifierMixin, BaseEstimator):
    """Two-class Gentle AdaBoost with regression stumps (thesis 3.3.1.2 and 4.2, [20]).

    Each round finds the stump f with the lowest weighted squared error on the labels y = +-1, adds f to F and
    multiplies each sample's weight by exp(-y f(x)).

    Parameters
    ----------
    n_rounds
        Number of weak classifiers. Thesis Table 2 uses 20, 50 and 100.
    max_bins
        Maximum number of bins per feature. If a feature has no more distinct values than this, it can be
        split between any two adjacent values, as in exact boosting. The thesis does not specify this.
    weight_trim
        Each round leaves out the samples with the smallest weights, up to a share of 1 - weight_trim of the
        total weight. A value of 1 keeps all samples. The default is 0.95, as in OpenCV, which the thesis
        uses.

    Attributes
    ----------
    classes_, n_features_in_
        See `TwoClass`.
    feature_, threshold_, low_, high_
        (T,) arrays, where T <= n_rounds: the feature and threshold of each stump, and its values above the
        threshold (`high_`) and at or below it (`low_`).

    References
    ----------
    Friedman, Hastie and Tibshirani, Additive logistic regression, Annals of Statistics 28, 2000.

    Examples
    --------
    >>> model = GentleAdaBoost(n_rounds=2).fit([[0.0], [1.0], [2.0], [3.0]], [0, 0, 1, 1])
    >>> model.decision_function([[1.4], [1.6]]).tolist()
    [-2.0, 2.0]
    """

    #: Equation (8), e^F / (e^-F + e^F), as a sigmoid of F.
    own_sigmoid = (-2.0, 0.0)

    def __init__(
        self,
        n_rounds: Count = 50,
        max_bins: Annotated[int, Interval(ge=2, le=2**16)] = 256,
        weight_trim: PositiveShare = 0.95,
    ) -> None:
        self.n_rounds = n_rounds
        self.max_bins = max_bins
        self.weight_trim = weight_trim

    def prepare(self, X: NDArray[np.float32], n_jobs: int | None = None) -> BinnedFeatures:
        """Bin the features once for all classes and folds, without the labels. Ignores `n_jobs`."""
        return remembered("bins", (X, self.max_bins), lambda: bin_features(X, self.max_bins), latest=True)

    def fit_rows(
        self,
        shared: BinnedFeatures,
        positive: NDArray[np.bool_],
        rows: NDArray[np.intp] | None = None,
        context: str = "this class",
    ) -> Self:
        """Fit on some of the samples that were binned together; see `TwoClass.fit_rows`."""
        (stumps,) = Boosting(shared, [(positive, rows, context)], self.weight_trim).stumps(self.n_rounds)
        return self._set(stumps, shared)

    def fit_together(self, shared: BinnedFeatures, tasks: Sequence[Task]) -> list["GentleAdaBoost"]:
        """Fit one copy of this classifier per problem, with exactly the same results as `fit_rows`."""
        contents = (
            content for positive, rows, _ in tasks for content in (positive.tobytes(), bytes_of(rows))
        )
        boosting = remembered(
            "boosting",
            (shared, self.weight_trim, *contents),
            lambda: Boosting(shared, tasks, self.weight_trim),
            latest=True,
        )
        return [clone(self)._set(stumps, shared) for stumps in boosting.stumps(self.n_rounds)]

    def _set(self, stumps: Sequence[Stump], shared: BinnedFeatures) -> Self:
        self.feature_ = np.array([stump.feature for stump in stumps], dtype=np.int64)
        self.threshold_ = np.array(
            [shared.thresholds[one.feature][one.cut] if one.cut >= 0 else -np.inf for one in stumps],
            dtype=np.float32,
        )
        self.cut_ = np.array([stump.cut for stump in stumps], dtype=np.int64)
        self.low_ = np.array([stump.low for stump in stumps])
        self.high_ = np.array([stump.high for stump in stumps])
        self.n_features_in_ = len(shared.bins)
        return self

    def decide_rows(self, shared: BinnedFeatures, rows: NDArray[np.intp]) -> NDArray[np.float64]:
        """Return the (len(rows),) values of F for some of the samples that were binned together."""
        result = np.zeros(len(rows))
        for feature, cut, low, high in zip(self.feature_, self.cut_, self.low_, self.high_, strict=True):
            result += np.where(shared.bins[feature, rows] > cut, high, low)
        return result

    @staticmethod
    def collect(machines: Sequence["GentleAdaBoost"], X: object = None) -> StumpEnsembles:
        """Combine machines fitted on the same features. Shorter ones are padded with zeros. Ignores `X`."""
        length = max(len(machine.feature_) for machine in machines)

        def stack(name: str) -> NDArray[Any]:
            rows = [getattr(machine, name) for machine in machines]
            return np.stack([np.pad(row, (0, length - len(row))) for row in rows])

        return StumpEnsembles(
            stack("feature_"), stack("threshold_"), stack("low_"), stack("high_"), machines[0].n_features_in_
        )

    def decision_function(self, X: ArrayLike) -> NDArray[np.float64]:
        """Return the (n,) values F(x) for (n, D) samples, positive for ``classes_[1]``."""
        check_is_fitted(self, "feature_")
        samples = check_samples(X)
        check_width(samples, self)
        return self.collect([self]).decisions(samples)[:, 0]
