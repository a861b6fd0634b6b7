"""Mozos's sequential multi-class scheme, a list of two-class classifiers with the strongest first."""

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Annotated, Any

import numpy as np
from numpy.typing import NDArray
from scipy.special import expit
from sklearn.base import BaseEstimator, ClassifierMixin

from placecat.learning.calibration import CALIBRATIONS, FittedProblem, Problem
from placecat.learning.multi_class import MultiClass
from placecat.learning.two_class import SIGMOID_WEIGHTS, SIGMOIDS
from placecat.ranges import OneOf, Two

ORDERS = ("balanced_accuracy", "error")
TRAINING = ("all", "remaining")
DECISIONS = ("sign", "probability", "product")
OUTPUTS = ("product", "decision")


class Sequential(MultiClass, ClassifierMixin, BaseEstimator):
    """Decision list over two-class classifiers, the baseline in thesis 4.8.

    Each node of the list is the classifier for one class, and the strongest comes first. If a node rejects a
    sample, the next node decides. If all nodes reject the sample, it is assigned to the last class. The
    probability-like output for the class at position k is p(o_k|x) prod_{j before k} (1 - p(o_j|x)). The last
    class receives the remainder.

    Parameters
    ----------
    base, calibration, sigmoid, sigmoid_weights, folds, n_jobs
        See `OneAgainstAll`.
    order
        How to measure the strength of a class's one-against-all classifier from held-out decisions.
        ``balanced_accuracy`` is the mean of its two per-class accuracies. ``error`` is the share of wrong
        decisions (lowest first), which favours rare classes. Ties are ordered as in `classes_`. The
        thesis says only "strongest".
    training
        Training samples of each node. With ``all``, this scheme uses the same classifiers as `OneAgainstAll`,
        because thesis 4.8 compares ways of combining their outputs. ``remaining`` leaves out the classes of
        earlier nodes. The thesis does not specify this.
    decision
        How `predict` decides. ``sign`` and ``probability`` choose the first class whose node accepts the
        sample, or the last class if none does. With ``sign``, a node accepts a sample whose decision
        value is positive. With ``probability``, p(o_k|x) must be above 0.5. ``product`` chooses the class
        with the largest probability-like output. The thesis mentions negative decisions, which implies
        ``sign``.
    output
        What `predict_proba` returns. ``product`` is the probability-like output, whose largest entry may
        differ from the result of `predict`. ``decision`` is 1 for the class that `predict` returns and 0 for
        the others.

    Attributes
    ----------
    classes_
        (K,) labels, sorted. The columns of all outputs are in this order.
    order_
        (K,) indices into `classes_`, strongest first. The last class has no node.
    strength_
        (K,) strength of each class. Larger is stronger.
    sigmoid_, machine_class_, flat_, cv_outputs_, nu_, fold_nu_, scorer_, n_features_in_
        See `OneAgainstAll`.

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

    def __init__(
        self,
        base: Any = None,
        calibration: Annotated[str, OneOf(CALIBRATIONS)] = "samples",
        sigmoid: Annotated[str, OneOf(SIGMOIDS)] = "auto",
        sigmoid_weights: Annotated[str, OneOf(SIGMOID_WEIGHTS)] = "none",
        order: Annotated[str, OneOf(ORDERS)] = "balanced_accuracy",
        training: Annotated[str, OneOf(TRAINING)] = "all",
        decision: Annotated[str, OneOf(DECISIONS)] = "sign",
        output: Annotated[str, OneOf(OUTPUTS)] = "decision",
        folds: Two = 5,
        n_jobs: int | None = None,
    ) -> None:
        self.base = base
        self.calibration = calibration
        self.sigmoid = sigmoid
        self.sigmoid_weights = sigmoid_weights
        self.order = order
        self.training = training
        self.decision = decision
        self.output = output
        self.folds = folds
        self.n_jobs = n_jobs

    def _arrange(
        self,
        fitted: list[FittedProblem],
        problems: Sequence[Problem],
        index: NDArray[np.intp],
        fit_some: Callable[[Sequence[Problem]], list[FittedProblem]],
    ) -> list[FittedProblem]:
        """Order the nodes. If `training` is ``remaining``, fit later nodes on the remaining classes."""
        self.strength_ = np.array(
            [
                self._strength(f.outputs, self._threshold(f.sigmoids), p.positive)
                for f, p in zip(fitted, problems, strict=True)
            ]
        )
        self.order_ = np.argsort(-self.strength_, kind="stable")
        later = self.order_[1:-1] if self.training == "remaining" else self.order_[:0]
        if len(later):
            again = [
                replace(
                    problems[k],
                    name=f"{problems[k].name} at position {place + 1} of the list",
                    member=~np.isin(index, self.order_[:place]),
                )
                for place, k in enumerate(later, start=1)
            ]
            for k, fit in zip(later, fit_some(again), strict=True):
                fitted[k] = fit
        return fitted

    def _threshold(self, sigmoids: NDArray[np.float64]) -> float:
        # For ``sign``, the threshold is the probability at the decision value 0. A flat sigmoid returns
        # exactly this value for every sample, so its node never accepts one.
        return float(expit(-sigmoids[:, 1]).mean()) if self.decision == "sign" else 0.5

    def _strength(self, outputs: NDArray[np.float64], threshold: float, positive: NDArray[np.bool_]) -> float:
        right = (outputs > threshold) == positive
        if self.order == "error":
            return float(right.mean())
        return float((right[positive].mean() + right[~positive].mean()) / 2.0)

    def combine(self, outputs: NDArray[np.float64]) -> NDArray[np.float64]:
        """Combine (n, K) outputs p(o_k|x) into (n, K) distributions, as specified by `output`."""
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

    def decide(self, outputs: NDArray[np.float64]) -> NDArray[np.intp]:
        """Return (n,) indices into `classes_` for (n, K) outputs p(o_k|x), according to `decision`."""
        if self.decision == "product":
            return self._product(outputs).argmax(axis=1)
        of_class = [self.sigmoid_[self.machine_class_ == k] for k in range(len(self.order_))]
        yes = (outputs > np.array([self._threshold(own) for own in of_class]))[:, self.order_]
        yes[:, -1] = True
        return self.order_[yes.argmax(axis=1)]
