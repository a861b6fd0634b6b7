"""The parallel probabilistic scheme, which combines one two-class classifier per class."""

from typing import Annotated, Any

import numpy as np
from numpy.typing import NDArray
from sklearn.base import BaseEstimator, ClassifierMixin

from placecat.learning.calibration import CALIBRATIONS
from placecat.learning.multi_class import MultiClass
from placecat.learning.products import sum_products
from placecat.learning.two_class import SIGMOID_WEIGHTS, SIGMOIDS
from placecat.ranges import NonNegative, OneOf, Two

COMBINATIONS = ("parallel", "certainty")
RELIABILITIES = ("hard", "soft")
PRIORS = ("training", "uniform")


class OneAgainstAll(MultiClass, ClassifierMixin, BaseEstimator):
    """Parallel probabilistic multi-class scheme (thesis 3.3.1.2, equations 6 to 9).

    One base classifier per class estimates p(o_k|x). Cross-validation yields the reliabilities p(o_k|l_i),
    and p(l_i) is the prior of class i. Then p(l_i|o_k) = p(o_k|l_i) p(l_i) / p(o_k), and p(l_i|x) is the
    normalised sum_k p(l_i|o_k) p(o_k|x).

    Parameters
    ----------
    base
        Two-class classifier: `NuSVM` (the default), `RVM`, `GentleAdaBoost`, or any scikit-learn classifier.
        scikit-learn classifiers cannot share preparatory work between fits.
    calibration
        Which samples are held out for the sigmoids and reliabilities: ``samples`` (the default),
        ``consecutive``, ``homes_centred`` or ``homes_averaged``. See
        :class:`~placecat.learning.calibration.Calibration`.
    sigmoid
        Source of p(o_k|x). ``platt`` fits a sigmoid to held-out decision values. ``own`` uses the base
        classifier's probability, which is equation (8) for boosting and the logistic likelihood for the RVM.
        ``auto`` uses equation (8) for boosting and ``platt`` for the nu-SVM and the RVM, as in dlib, which
        the thesis uses.
    sigmoid_weights
        ``balanced`` gives positives and negatives equal total weight when Platt's sigmoid is fitted. ``none``
        does not, as in Platt's paper.
    combination
        ``parallel`` uses equation (6). ``certainty`` normalises p(o_k|x), so the most certain classifier
        decides. This is the simpler method of 3.3.1.2.
    exclusive
        Whether to divide each sample's p(o_k|x) by their sum before equations (6) and (7) are applied.
        Equation (6) is the law of total probability only if exactly one o_k occurs.
    reliability
        How to compute p(o_k|l_i) from held-out samples of class i. ``soft`` is the mean of p(o_k|x). ``hard``
        is the share of samples with p(o_k|x) >= 0.5 or, with `exclusive`, the share for which p(o_k|x) is the
        largest. The thesis says only "statistics from cross-validating".
    reliability_smoothing
        Number added to each count. If it is 0 and classifier k never answers yes, p(l_i|o_k) is
        uniform. The thesis does not specify this.
    prior
        How to choose p(l_i). ``training`` uses the class frequencies in training, as in the thesis.
        ``uniform`` is what the thesis assumes for nearest neighbours (3.3.1.1). It suits the accuracy
        measure, which is a mean over places.
    uncertainty
        gamma in equation (9). A total of beta = gamma (1 / max_k p(o_k|x) - 1) is spread evenly over the
        classes before normalisation. A value of 0 turns this off.
    folds
        Number of parts for cross-validation. The thesis does not specify this.
    n_jobs
        Number of threads for the (class, fold) pairs. The result does not depend on it.

    Attributes
    ----------
    classes_
        (K,) labels, sorted.
    reliability_
        (K, K) float64, with p(o_k|l_i) in row i and column k.
    prior_
        (K,) p(l_i).
    posterior_
        (K, K), with p(l_i|o_k) in row i and column k. Columns sum to 1.
    sigmoid_
        (M, 2), A <= 0 and B in p = 1 / (1 + exp(A d + B)) for each machine.
    machine_class_
        (M,) class index k of each machine, in ascending order. p(o_k|x) is the mean over the machines of
        class k. Only ``homes_averaged`` has several machines per class.
    flat_
        (K,) number of flat sigmoids per class; see `FittedProblem`.
    cv_outputs_
        (n, K) held-out p(o_k|x) of the training samples.
    nu_
        (K,) smallest nu used for each class, or NaN if the base classifier has no nu.
    fold_nu_
        K arrays with the nu used for each held-out part.
    scorer_
        One object that evaluates all M decision functions.
    n_features_in_
        D.

    Examples
    --------
    >>> X = np.repeat([[0.0], [1.0], [2.0]], 10, axis=0) + np.tile(np.linspace(-0.2, 0.2, 10), 3)[:, None]
    >>> y = np.repeat(["bath", "hall", "kitchen"], 10)
    >>> from placecat.learning.nu_svm import NuSVM
    >>> model = OneAgainstAll(NuSVM(gamma=2.0, nu=0.2), folds=2).fit(X, y)
    >>> model.predict([[0.1], [1.9]]).tolist()
    ['bath', 'kitchen']
    """

    def __init__(
        self,
        base: Any = None,
        calibration: Annotated[str, OneOf(CALIBRATIONS)] = "samples",
        sigmoid: Annotated[str, OneOf(SIGMOIDS)] = "auto",
        sigmoid_weights: Annotated[str, OneOf(SIGMOID_WEIGHTS)] = "none",
        combination: Annotated[str, OneOf(COMBINATIONS)] = "parallel",
        exclusive: bool = True,
        reliability: Annotated[str, OneOf(RELIABILITIES)] = "soft",
        reliability_smoothing: NonNegative = 1.0,
        prior: Annotated[str, OneOf(PRIORS)] = "uniform",
        uncertainty: NonNegative = 0.0,
        folds: Two = 5,
        n_jobs: int | None = None,
    ) -> None:
        self.base = base
        self.calibration = calibration
        self.sigmoid = sigmoid
        self.sigmoid_weights = sigmoid_weights
        self.combination = combination
        self.exclusive = exclusive
        self.reliability = reliability
        self.reliability_smoothing = reliability_smoothing
        self.prior = prior
        self.uncertainty = uncertainty
        self.folds = folds
        self.n_jobs = n_jobs

    def _fit_combination(self, index: NDArray[np.intp]) -> None:
        n_classes = len(self.classes_)
        frequency = np.bincount(index, minlength=n_classes) / len(index)
        self.prior_ = frequency if self.prior == "training" else np.full(n_classes, 1.0 / n_classes)
        self.reliability_ = self._reliability(index, self.cv_outputs_)
        joint = self.reliability_ * self.prior_[:, None]
        p_output = joint.sum(axis=0)
        uniform = np.full_like(joint, 1.0 / n_classes)
        self.posterior_ = np.divide(joint, p_output, out=uniform, where=p_output > 0)

    def _reliability(self, index: NDArray[np.intp], outputs: NDArray[np.float64]) -> NDArray[np.float64]:
        outputs = self._exclude(outputs)
        if self.reliability == "hard":
            outputs = (
                np.eye(outputs.shape[1])[outputs.argmax(axis=1)]
                if self.exclusive
                else (outputs >= 0.5).astype(np.float64)
            )
        n_classes = len(self.classes_)
        yes = np.stack([outputs[index == i].sum(axis=0) for i in range(n_classes)])
        total = np.bincount(index, minlength=n_classes)[:, None]
        a = self.reliability_smoothing
        counts = total + (n_classes if self.exclusive else 2) * a
        return np.divide(yes + a, counts, out=np.zeros_like(yes), where=counts > 0)

    def _exclude(self, outputs: NDArray[np.float64]) -> NDArray[np.float64]:
        if not self.exclusive:
            return outputs
        total = outputs.sum(axis=1, keepdims=True)
        return np.divide(outputs, total, out=np.full_like(outputs, 1.0 / outputs.shape[1]), where=total > 0)

    def combine(self, outputs: NDArray[np.float64]) -> NDArray[np.float64]:
        """Combine (n, K) outputs p(o_k|x) into (n, K) distributions p(l_i|x) by equations (6), (7), (9)."""
        proba = outputs
        if self.combination == "parallel":
            proba = sum_products(self._exclude(outputs), self.posterior_)
        if self.uncertainty > 0:
            strongest = np.maximum(outputs.max(axis=1, keepdims=True), np.finfo(float).tiny)
            proba = proba + self.uncertainty * (1.0 / strongest - 1.0) / proba.shape[1]
        total = proba.sum(axis=1, keepdims=True)
        uniform = np.full_like(proba, 1.0 / proba.shape[1])
        return np.divide(proba, total, out=uniform, where=total > 0)
