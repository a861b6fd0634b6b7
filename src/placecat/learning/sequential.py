"""The sequential multi-class scheme of Mozos: a list of two-class decisions, the strongest first."""

from collections.abc import Sequence
from typing import Any, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.special import expit
from sklearn.base import BaseEstimator, ClassifierMixin

from placecat.errors import PlacecatError
from placecat.learning.one_against_all import (
    Problem,
    as_base,
    encode_classes,
    fit_problems,
    is_balanced,
    make_folds,
    pack_settings,
    scorer_width,
    unpack_settings,
    uses_own,
)
from placecat.learning.platt import apply_sigmoid
from placecat.learning.single_thread import single_blas_thread

ORDERS = ("balanced_accuracy", "error")
TRAINING = ("all", "remaining")
DECISIONS = ("sign", "probability", "product")
OUTPUTS = ("product", "decision")

ARRAYS = ("classes_", "order_", "strength_", "sigmoid_", "nu_", "cv_outputs_", "cv_proba_")


class Sequential(ClassifierMixin, BaseEstimator):
    """Decision list over two-class classifiers, the baseline of thesis 4.8.

    The node of the strongest class decides first; a sample it rejects goes on to the next; what all reject is
    of the last class in the list. The probability-like output of the class at place k is
    p(o_k|x) prod_{j before k} (1 - p(o_j|x)), and the last class gets the remainder.

    Parameters
    ----------
    base, calibration, sigmoid_weights, folds, n_jobs
        As in `OneAgainstAll`.
    order
        Strength of a class's classifier against all others, from its held-out decisions:
        ``balanced_accuracy``, the mean of its two per-class rates, or ``error``, the share of wrong decisions
        (lowest first), which favours rare classes. Equal ones keep the order of `classes_`. The thesis says
        "strongest" only.
    training
        What a node learns from: ``all`` samples, so that the list uses the very classifiers of the parallel
        scheme (thesis 4.8 compares what is done with their outputs), or the samples of ``remaining`` classes
        only, without those of earlier nodes. The thesis does not give this.
    decision
        What `predict` does: the first node that says yes, else the last class, where yes is the ``sign`` of
        the two-class decision value, or a ``probability`` p(o_k|x) of at least 0.5; or the largest of the
        probability-like output, ``product``. The thesis speaks of negative decisions only; on its toy problem
        the sign gives the threefold error on the last class that it reports, the probability half of that.
    output
        What `predict_proba` gives: the probability-like ``product``, whose largest entry need not be what
        `predict` decides, or 1 for what `predict` says (``decision``).

    Attributes
    ----------
    classes_
        (K,) labels, sorted. Columns of all outputs follow it.
    order_
        (K,) indices into `classes_`, strongest first. The last has no node.
    strength_
        (K,) the measure of `order` of each class, larger is stronger.
    sigmoid_
        (K, 2) as in `OneAgainstAll`.
    cv_outputs_, cv_proba_
        (n, K) held-out p(o_k|x) and the distributions from them.
    nu_
        (K,) nu in force of each node, NaN for a base without one.
    scorer_, n_features_in_
        As in `OneAgainstAll`.

    References
    ----------
    Mozos and Burgard, Supervised learning of topological maps using semantic information extracted from range
    data, IROS 2006 (thesis [46]).

    Examples
    --------
    >>> from placecat.learning.nu_svm import NuSVM
    >>> X = np.repeat([[0.0], [1.0], [2.0]], 10, axis=0) + np.tile(np.linspace(-0.2, 0.2, 10), 3)[:, None]
    >>> y = np.repeat(["bath", "hall", "kitchen"], 10)
    >>> Sequential(NuSVM(gamma=2.0, nu=0.2), folds=2).fit(X, y).predict([[0.1], [1.9]]).tolist()
    ['bath', 'kitchen']
    """

    #: Attributes that prediction does without: a stored system leaves them out.
    TRAINING_ONLY = ("cv_outputs_", "cv_proba_")

    def __init__(
        self,
        base: Any = None,
        calibration: str = "auto",
        sigmoid_weights: str = "none",
        order: str = "balanced_accuracy",
        training: str = "all",
        decision: str = "sign",
        output: str = "product",
        folds: int = 5,
        n_jobs: int | None = None,
    ) -> None:
        self.base = base
        self.calibration = calibration
        self.sigmoid_weights = sigmoid_weights
        self.order = order
        self.training = training
        self.decision = decision
        self.output = output
        self.folds = folds
        self.n_jobs = n_jobs

    def fit(
        self,
        X: ArrayLike,
        y: ArrayLike,
        groups: ArrayLike | None = None,
        gram: NDArray[Any] | None = None,
        class_names: Sequence[str] | None = None,
    ) -> Self:
        """Fit the nodes and their order. Parameters and errors as in `OneAgainstAll.fit`."""
        base = as_base(self.base)
        own = uses_own(self.calibration, base)
        balanced = is_balanced(self.sigmoid_weights)
        self._check_settings()
        samples, self.classes_, index, names = encode_classes(X, y, class_names)
        n, n_classes = len(samples), len(self.classes_)
        folds = make_folds(index, groups, self.folds)
        everyone = np.ones(n, dtype=bool)
        problems = [Problem(f"class {names[k]!r}", index == k, everyone) for k in range(n_classes)]
        with single_blas_thread():
            shared = base.prepare(samples, gram=gram, n_jobs=self.n_jobs)
            fitted = fit_problems(base, shared, problems, folds, own, balanced, self.n_jobs)
            self.strength_ = np.array(
                [
                    self._strength(f.outputs, self._threshold(f.sigmoid), p.positive)
                    for f, p in zip(fitted, problems, strict=True)
                ]
            )
            self.order_ = np.argsort(-self.strength_, kind="stable")
            if self.training == "remaining":
                later = [
                    Problem(
                        f"class {names[k]!r} at place {place + 1} of the list",
                        index == k,
                        ~np.isin(index, self.order_[:place]),
                    )
                    for place, k in enumerate(self.order_[:-1])
                    if place > 0
                ]
                if later:
                    again = fit_problems(base, shared, later, folds, own, balanced, self.n_jobs)
                    for k, fit in zip(self.order_[1:-1], again, strict=True):
                        fitted[k] = fit
        self.n_features_in_ = samples.shape[1]
        self.scorer_ = base.collect([f.machine for f in fitted], samples)
        self.sigmoid_ = np.array([f.sigmoid for f in fitted])
        self.nu_ = np.array([float(getattr(f.machine, "nu_", np.nan)) for f in fitted])
        self.cv_outputs_ = np.stack([f.outputs for f in fitted], axis=1)
        self.cv_proba_ = self.combine(self.cv_outputs_)
        return self

    def _check_settings(self) -> None:
        for name, value, known in (
            ("order", self.order, ORDERS),
            ("training", self.training, TRAINING),
            ("decision", self.decision, DECISIONS),
            ("output", self.output, OUTPUTS),
        ):
            if value not in known:
                raise PlacecatError(f"unknown {name} {value!r}; choose one of {', '.join(known)}")
        if self.folds < 2:
            raise PlacecatError(f"folds = {self.folds}; cross-validation needs 2 or more")

    def _threshold(self, sigmoid: tuple[float, float]) -> float:
        # p at decision value 0; falling sigmoids only come from classifiers worse than chance.
        return float(expit(-sigmoid[1])) if self.decision == "sign" else 0.5

    def _strength(self, outputs: NDArray[np.float64], threshold: float, positive: NDArray[np.bool_]) -> float:
        right = (outputs >= threshold) == positive
        if self.order == "error":
            return float(right.mean())
        return float((right[positive].mean() + right[~positive].mean()) / 2.0)

    def outputs(self, X: ArrayLike) -> NDArray[np.float64]:
        """Give p(o_k|x) of samples (n, D) as (n, K)."""
        return apply_sigmoid(self.scorer_.decisions(X), self.sigmoid_[:, 0], self.sigmoid_[:, 1])

    def combine(self, outputs: NDArray[np.float64]) -> NDArray[np.float64]:
        """Combine outputs p(o_k|x) (n, K) to what `output` says, (n, K); rows sum to 1."""
        if self.output == "decision":
            return np.eye(len(self.order_))[self.decide(outputs)]
        return self._product(outputs)

    def _product(self, outputs: NDArray[np.float64]) -> NDArray[np.float64]:
        listed = outputs[:, self.order_]
        reached = np.cumprod(1.0 - listed[:, :-1], axis=1)
        proba = np.empty_like(outputs)
        proba[:, self.order_[0]] = listed[:, 0]
        proba[:, self.order_[1:-1]] = listed[:, 1:-1] * reached[:, :-1]
        proba[:, self.order_[-1]] = reached[:, -1]
        return proba

    def predict_proba(self, X: ArrayLike) -> NDArray[np.float64]:
        """Give `output` (n, K) float64 over `classes_` for samples (n, D); rows sum to 1."""
        return self.combine(self.outputs(X))

    def decide(self, outputs: NDArray[np.float64]) -> NDArray[np.intp]:
        """Index into `classes_` (n,) that `decision` picks from outputs p(o_k|x) (n, K)."""
        if self.decision == "product":
            return self._product(outputs).argmax(axis=1)
        thresholds = np.array([self._threshold((a, b)) for a, b in self.sigmoid_])
        yes = (outputs >= thresholds)[:, self.order_]
        yes[:, -1] = True
        return self.order_[yes.argmax(axis=1)]

    def predict(self, X: ArrayLike) -> NDArray[Any]:
        """Class (n,) of samples (n, D), by `decision`."""
        return self.classes_[self.decide(self.outputs(X))]

    def to_arrays(self) -> dict[str, NDArray[Any]]:
        """Give plain arrays, enough for `from_arrays`; PlacecatError if the base is not placecat's own."""
        arrays = {f"scorer/{name}": array for name, array in self.scorer_.to_arrays().items()}
        arrays["settings"] = pack_settings(self, self.scorer_.kind)
        return arrays | {name: getattr(self, name) for name in ARRAYS}

    @classmethod
    def from_arrays(cls, arrays: dict[str, NDArray[Any]]) -> Self:
        """Rebuild a fitted scheme from `to_arrays`, or from the mapping that ``numpy.load`` returns."""
        parameters, scorer = unpack_settings(arrays)
        model = cls(**parameters)
        model.scorer_ = scorer
        for name in ARRAYS:
            setattr(model, name, arrays[name])
        model.n_features_in_ = scorer_width(scorer)
        return model
