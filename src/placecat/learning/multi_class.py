"""Base class of the multi-class schemes, which combine one two-class classifier p(o_k|x) per class."""

from abc import abstractmethod
from collections.abc import Callable, Sequence
from typing import Any, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray
from sklearn.utils.validation import check_is_fitted

from placecat.errors import PlacecatError
from placecat.learning.calibration import Calibration, FittedProblem, Problem, fit_problems, make_folds
from placecat.learning.checks import check_labels, check_samples, check_width
from placecat.learning.nu_svm import NuSVM
from placecat.learning.platt import apply_sigmoid
from placecat.learning.single_thread import single_blas_thread
from placecat.learning.two_class import TwoClass, as_two_class
from placecat.schema.signatures import check_parameters


class MultiClass:
    """The K classifiers of a scheme, fitted and calibrated together.

    All schemes have the parameters and attributes annotated below, which `OneAgainstAll` describes.
    """

    base: Any
    calibration: str
    sigmoid: str
    sigmoid_weights: str
    folds: int
    n_jobs: int | None
    classes_: NDArray[Any]
    sigmoid_: NDArray[np.float64]
    machine_class_: NDArray[np.intp]
    cv_outputs_: NDArray[np.float64]

    #: Attributes that stored systems omit, because prediction does not need them.
    TRAINING_ONLY = ("cv_outputs_",)

    def fit(
        self,
        X: ArrayLike,
        y: ArrayLike,
        groups: ArrayLike | None = None,
        class_names: Sequence[str] | None = None,
    ) -> Self:
        """Fit the K classifiers and their combination.

        Parameters
        ----------
        X
            (n, D) real numbers.
        y
            (n,) labels, where every class occurs at least twice.
        groups
            (n,) home of each sample. Required if the calibration holds out homes.
        class_names
            Name of each integer label, for messages only.

        Raises
        ------
        PlacecatError
            If there are fewer than 2 classes, if a class has only 1 sample, if a setting is invalid, if nu
            leaves no margin, or if nu is infeasible and its policy is ``refuse``.
        """
        check_parameters(self)
        base = as_two_class(NuSVM() if self.base is None else self.base)
        balanced = self.sigmoid_weights == "balanced"
        calibration = Calibration(self.calibration, self.folds, self._uses_own_sigmoid(base), balanced)
        samples, self.classes_, index, names = encode_classes(X, y, class_names)
        folds = make_folds(index, groups, calibration.kind, calibration.folds)
        everyone = np.ones(len(samples), dtype=bool)
        problems = [Problem(f"class {name!r}", index == k, everyone) for k, name in enumerate(names)]
        with single_blas_thread():
            shared = base.prepare(samples, self.n_jobs)

            def fit_some(some: Sequence[Problem]) -> list[FittedProblem]:
                return fit_problems(base, shared, some, folds, calibration, self.n_jobs)

            fitted = self._arrange(fit_some(problems), problems, index, fit_some)
        self.n_features_in_ = samples.shape[1]
        self.scorer_ = base.collect([machine for one in fitted for machine in one.machines], samples)
        self.sigmoid_ = np.concatenate([one.sigmoids for one in fitted])
        self.machine_class_ = np.repeat(np.arange(len(fitted)), [len(one.machines) for one in fitted])
        self.flat_ = np.array([one.flat for one in fitted])
        self.nu_ = np.array([min(float(getattr(m, "nu_", np.nan)) for m in one.machines) for one in fitted])
        self.fold_nu_ = [one.nu for one in fitted]
        self.cv_outputs_ = np.stack([one.outputs for one in fitted], axis=1)
        self._fit_combination(index)
        return self

    def outputs(self, X: ArrayLike) -> NDArray[np.float64]:
        """Return the (n, K) outputs p(o_k|x) for (n, D) samples, averaged over the machines of each class."""
        check_is_fitted(self, "scorer_")
        samples = check_samples(X)
        check_width(samples, self)
        proba = apply_sigmoid(self.scorer_.decisions(samples), self.sigmoid_[:, 0], self.sigmoid_[:, 1])
        if len(self.machine_class_) == len(self.classes_):
            return proba
        starts = np.searchsorted(self.machine_class_, np.arange(len(self.classes_)))
        return np.add.reduceat(proba, starts, axis=1) / np.bincount(self.machine_class_)

    def predict_proba(self, X: ArrayLike) -> NDArray[np.float64]:
        """Return (n, K) float64 distributions over `classes_` for (n, D) samples; rows sum to 1."""
        return self.combine(self.outputs(X))

    def predict(self, X: ArrayLike) -> NDArray[Any]:
        """Return the (n,) classes that `decide` chooses for (n, D) samples."""
        decided = self.decide(self.outputs(X))
        return self.classes_[decided]

    @abstractmethod
    def combine(self, outputs: NDArray[np.float64]) -> NDArray[np.float64]:
        """Combine (n, K) outputs p(o_k|x) into (n, K) distributions."""

    def decide(self, outputs: NDArray[np.float64]) -> NDArray[np.intp]:
        """Choose a class for each row of (n, K) outputs p(o_k|x), and return (n,) indices into `classes_`."""
        return self.combine(outputs).argmax(axis=1)

    def _uses_own_sigmoid(self, base: TwoClass) -> bool:
        if self.sigmoid == "own" and base.own_sigmoid is None:
            raise PlacecatError(
                "sigmoid 'own' needs a base classifier with its own sigmoid, which a nu-SVM lacks: "
                "use 'platt'"
            )
        if self.sigmoid == "auto":
            return base.own_sigmoid is not None and base.prefers_own_sigmoid
        return self.sigmoid == "own"

    def _arrange(
        self,
        fitted: list[FittedProblem],
        problems: Sequence[Problem],
        index: NDArray[np.intp],
        fit_some: Callable[[Sequence[Problem]], list[FittedProblem]],
    ) -> list[FittedProblem]:
        """Return the final fits. A subclass may refit some problems."""
        return fitted

    def _fit_combination(self, index: NDArray[np.intp]) -> None:
        """Fit the combination. `index` contains the class index of each sample."""


def encode_classes(
    X: ArrayLike, y: ArrayLike, class_names: Sequence[str] | None
) -> tuple[NDArray[np.float32], NDArray[Any], NDArray[np.intp], list[str]]:
    """Check training data, and return float32 samples, classes, class indices, and display names."""
    samples = check_samples(X)
    classes, index = np.unique(check_labels(y, len(samples)), return_inverse=True)
    names = [str(c) for c in classes] if class_names is None else [str(class_names[int(c)]) for c in classes]
    if len(classes) < 2:
        raise PlacecatError(
            f"all training samples belong to one class, {names[0]!r}: a multi-class scheme needs at least 2"
        )
    counts = np.bincount(index)
    if counts.min() < 2:
        name = names[int(counts.argmin())]
        raise PlacecatError(
            f"class {name!r} has 1 training sample, but cross-validation needs 2: add one or drop the class"
        )
    return samples, classes, index, names
