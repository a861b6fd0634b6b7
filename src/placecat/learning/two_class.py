"""Interface between two-class classifiers and multi-class schemes."""

from collections.abc import Sequence
from typing import Any, Protocol, Self, cast

import numpy as np
from numpy.typing import ArrayLike, NDArray
from sklearn.base import clone

from placecat.errors import PlacecatError
from placecat.learning.kernels import check_samples
from placecat.learning.nu_svm import NuSVM

SIGMOIDS = ("auto", "platt", "own")
SIGMOID_WEIGHTS = ("none", "balanced")


class TwoClassBase(Protocol):
    """Base classifier whose preparation all classes and folds share."""

    own_sigmoid: tuple[float, float] | None

    def get_params(self, deep: bool = True) -> dict[str, Any]:
        """Return a mapping from each setting's name to its value."""

    def check_parameters(self) -> None:
        """Raise PlacecatError if a setting is invalid."""

    def prepare(
        self, X: NDArray[np.float32], gram: NDArray[Any] | None = None, n_jobs: int | None = None
    ) -> Any:
        """Compute everything that depends only on the samples."""

    def fit_rows(
        self,
        shared: Any,
        positive: NDArray[np.bool_],
        rows: NDArray[np.intp] | None = None,
        context: str = "",
    ) -> Any:
        """Fit on some of the prepared samples."""

    def decide_rows(self, shared: Any, rows: NDArray[np.intp]) -> NDArray[np.float64]:
        """Return decision values for some of the prepared samples."""

    def collect(self, machines: Sequence[Any], X: NDArray[np.float32]) -> Any:
        """Combine fitted machines into one object with a method `decisions`."""


class _GenericBase:
    """Adapter that turns any scikit-learn two-class classifier into a base that shares nothing."""

    def __init__(self, estimator: Any) -> None:
        self.estimator = estimator

    def get_params(self, deep: bool = False) -> dict[str, Any]:
        return {"estimator": self.estimator}

    @property
    def own_sigmoid(self) -> tuple[float, float] | None:
        return None if hasattr(self.estimator, "decision_function") else (-1.0, 0.0)

    def check_parameters(self) -> None:
        pass

    def prepare(self, X: NDArray[np.float32], gram: object = None, n_jobs: int | None = None) -> Any:
        return X

    def fit_rows(
        self,
        shared: Any,
        positive: NDArray[np.bool_],
        rows: NDArray[np.intp] | None = None,
        context: str = "",
    ) -> Self:
        chosen = np.arange(len(shared)) if rows is None else rows
        self.fitted_ = clone(self.estimator).fit(shared[chosen], positive[chosen])
        return self

    def decide(self, X: NDArray[np.float32]) -> NDArray[np.float64]:
        if hasattr(self.fitted_, "decision_function"):
            return np.asarray(self.fitted_.decision_function(X), dtype=np.float64)
        p = np.clip(self.fitted_.predict_proba(X)[:, 1], 1e-12, 1 - 1e-12)
        return np.log(p / (1 - p))

    def decide_rows(self, shared: Any, rows: NDArray[np.intp]) -> NDArray[np.float64]:
        return self.decide(shared[rows])

    @staticmethod
    def collect(machines: Sequence["_GenericBase"], X: NDArray[np.float32]) -> "_GenericScorer":
        return _GenericScorer(machines)


class _GenericScorer:
    def __init__(self, machines: Sequence[_GenericBase]) -> None:
        self.machines = machines

    def decisions(self, X: ArrayLike) -> NDArray[np.float64]:
        samples = check_samples(X)
        return np.stack([machine.decide(samples) for machine in self.machines], axis=1)


def as_base(base: Any) -> TwoClassBase:
    """Return `base` if it shares its preparation, or else a scikit-learn classifier in an adapter."""
    base = NuSVM() if base is None else base
    adapted: Any = base if hasattr(base, "fit_rows") else _GenericBase(base)
    adapted.check_parameters()
    return cast(TwoClassBase, adapted)


def uses_own(sigmoid: str, base: TwoClassBase) -> bool:
    """Return whether to use the base's sigmoid instead of Platt's."""
    if sigmoid not in SIGMOIDS:
        raise PlacecatError(f"unknown sigmoid {sigmoid!r}; choose one of {', '.join(SIGMOIDS)}")
    if sigmoid == "own" and base.own_sigmoid is None:
        raise PlacecatError("sigmoid 'own' needs a base with probabilities; a nu-SVM has none, use 'platt'")
    if sigmoid == "auto":
        return base.own_sigmoid is not None and getattr(base, "prefers_own_sigmoid", True)
    return sigmoid == "own"


def is_balanced(sigmoid_weights: str) -> bool:
    """Return whether `sigmoid_weights` is ``balanced``."""
    if sigmoid_weights not in SIGMOID_WEIGHTS:
        raise PlacecatError(f"unknown sigmoid_weights {sigmoid_weights!r}; choose 'none' or 'balanced'")
    return sigmoid_weights == "balanced"
