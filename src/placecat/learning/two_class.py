"""Two-class classifiers whose fits share preparatory work, and an adapter for scikit-learn's classifiers."""

from abc import abstractmethod
from collections.abc import Callable, Sequence
from typing import Any, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray
from sklearn.base import clone
from sklearn.utils.metaestimators import available_if

from placecat.learning.checks import check_samples, encode_two_classes
from placecat.learning.platt import apply_sigmoid
from placecat.schema.signatures import check_parameters

SIGMOIDS = ("auto", "platt", "own")
SIGMOID_WEIGHTS = ("none", "balanced")


class TwoClass:
    """Base class of the two-class classifiers.

    Attributes
    ----------
    classes_
        The two labels in sorted order. The second is the positive class. `fit` sets this.
    n_features_in_
        D.
    """

    #: A and B of the classifier's own probability 1 / (1 + exp(A d + B)) for the decision value d, or None.
    own_sigmoid: tuple[float, float] | None = None
    #: Whether a multi-class scheme with sigmoid ``auto`` uses `own_sigmoid`, if there is one.
    prefers_own_sigmoid = True
    classes_: NDArray[Any]
    n_features_in_: int
    get_params: Callable[..., dict[str, Any]]

    def __sklearn_tags__(self) -> Any:
        """Tell scikit-learn that only two classes are supported."""
        tags = super().__sklearn_tags__()  # type: ignore[misc]
        tags.classifier_tags.multi_class = False
        return tags

    def fit(self, X: ArrayLike, y: ArrayLike) -> Self:
        """Fit on real (n, D) samples and (n,) labels of exactly two classes.

        Raises PlacecatError if there are not exactly two classes, or if a setting is invalid.
        """
        check_parameters(self)
        samples = check_samples(X)
        self.classes_, positive = encode_two_classes(y, len(samples))
        self.n_features_in_ = samples.shape[1]
        return self.fit_rows(self.prepare(samples), positive, context=f"class {self.classes_[1]!s}")

    @abstractmethod
    def prepare(self, X: NDArray[np.float32], n_jobs: int | None = None) -> Any:
        """Prepare (n, D) samples once for all classes and folds, in `n_jobs` threads."""

    @abstractmethod
    def fit_rows(
        self,
        shared: Any,
        positive: NDArray[np.bool_],
        rows: NDArray[np.intp] | None = None,
        context: str = "this class",
    ) -> Self:
        """Fit on some of the prepared samples.

        Raises PlacecatError if the training samples belong to only one class.

        Parameters
        ----------
        shared
            The result of `prepare` for n samples.
        positive
            (n,) bool, true for positive samples.
        rows
            Ascending indices of the training samples. By default, all samples are used.
        context
            Name of the problem to show in messages.
        """

    @abstractmethod
    def decide_rows(self, shared: Any, rows: NDArray[np.intp]) -> NDArray[np.float64]:
        """Return (len(rows),) decision values for some of the prepared samples."""

    @staticmethod
    @abstractmethod
    def collect(machines: Sequence[Any], X: NDArray[np.float32]) -> Any:
        """Combine machines fitted on the same (n, D) samples into an object with a `decisions` method."""

    @abstractmethod
    def decision_function(self, X: ArrayLike) -> NDArray[np.float64]:
        """Return (n,) decision values for (n, D) samples, positive for ``classes_[1]``. Call `fit` first."""

    @available_if(lambda self: self.own_sigmoid is not None)
    def predict_proba(self, X: ArrayLike) -> NDArray[np.float64]:
        """Return (n, 2) class probabilities for (n, D) samples, using `own_sigmoid`. Call `fit` first."""
        assert self.own_sigmoid is not None
        positive = apply_sigmoid(self.decision_function(X), *self.own_sigmoid)
        return np.stack([1.0 - positive, positive], axis=1)

    def predict(self, X: ArrayLike) -> NDArray[Any]:
        """Return the predicted labels, (n,), for (n, D) samples. Call `fit` first."""
        positive = self.decision_function(X) > 0
        return self.classes_[positive.astype(int)]


class _GenericBase(TwoClass):
    """Adapter for any scikit-learn two-class classifier, whose fits share no preparatory work."""

    def __init__(self, estimator: Any) -> None:
        self.estimator = estimator

    def get_params(self, deep: bool = False) -> dict[str, Any]:
        return {"estimator": self.estimator}

    @property
    def own_sigmoid(self) -> tuple[float, float] | None:  # type: ignore[override]
        return None if hasattr(self.estimator, "decision_function") else (-1.0, 0.0)

    def prepare(self, X: NDArray[np.float32], n_jobs: int | None = None) -> NDArray[np.float32]:
        return X

    def fit_rows(
        self,
        shared: NDArray[np.float32],
        positive: NDArray[np.bool_],
        rows: NDArray[np.intp] | None = None,
        context: str = "",
    ) -> Self:
        chosen = np.arange(len(shared)) if rows is None else rows
        self.fitted_ = clone(self.estimator).fit(shared[chosen], positive[chosen])
        return self

    def decision_function(self, X: ArrayLike) -> NDArray[np.float64]:
        if hasattr(self.fitted_, "decision_function"):
            return np.asarray(self.fitted_.decision_function(X), dtype=np.float64)
        p = np.clip(self.fitted_.predict_proba(X)[:, 1], 1e-12, 1 - 1e-12)
        return np.log(p / (1 - p))

    def decide_rows(self, shared: NDArray[np.float32], rows: NDArray[np.intp]) -> NDArray[np.float64]:
        return self.decision_function(shared[rows])

    @staticmethod
    def collect(machines: Sequence["_GenericBase"], X: NDArray[np.float32]) -> "_GenericScorer":
        return _GenericScorer(machines)


class _GenericScorer:
    def __init__(self, machines: Sequence[_GenericBase]) -> None:
        self.machines = machines

    def decisions(self, X: NDArray[np.float32]) -> NDArray[np.float64]:
        return np.stack([machine.decision_function(X) for machine in self.machines], axis=1)


def as_two_class(base: Any) -> TwoClass:
    """Check the settings of `base` and return it, or return an adapter if it has no `fit_rows`."""
    if not hasattr(base, "fit_rows"):
        return _GenericBase(base)
    check_parameters(base)
    shared: TwoClass = base
    return shared
