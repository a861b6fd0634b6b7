"""One two-class classifier a class, and the parallel probabilistic scheme that combines them."""

import json
from collections.abc import Sequence
from typing import Any, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray
from sklearn.base import BaseEstimator, ClassifierMixin

from placecat.errors import PlacecatError
from placecat.learning.calibration import Calibration, FittedProblem, Problem, fit_problems, make_folds
from placecat.learning.gentle_adaboost import GentleAdaBoost, StumpEnsembles
from placecat.learning.kernels import KernelExpansion, check_samples
from placecat.learning.nu_svm import NuSVM
from placecat.learning.platt import apply_sigmoid
from placecat.learning.products import sum_products
from placecat.learning.rvm import RVM
from placecat.learning.single_thread import single_blas_thread
from placecat.learning.two_class import as_base, is_balanced, uses_own

COMBINATIONS = ("parallel", "certainty")
RELIABILITIES = ("hard", "soft")
PRIORS = ("training", "uniform")
BASES: dict[str, Any] = {"NuSVM": NuSVM, "RVM": RVM, "GentleAdaBoost": GentleAdaBoost}
SCORERS: dict[str, Any] = {"kernel": KernelExpansion, "stumps": StumpEnsembles}
MACHINES = ("classes_", "sigmoid_", "machine_class_", "flat_", "nu_", "cv_outputs_")
ARRAYS = (*MACHINES, "reliability_", "prior_")


def encode_classes(
    X: ArrayLike, y: ArrayLike, class_names: Sequence[str] | None
) -> tuple[NDArray[np.float32], NDArray[Any], NDArray[np.intp], list[str]]:
    """Check training data; gives float32 samples, classes, class index of each sample, names for messages."""
    samples = check_samples(X)
    labels = np.asarray(y)
    if labels.shape != (len(samples),):
        raise PlacecatError(f"y has shape {labels.shape} for {len(samples)} samples; give one label a sample")
    classes, index = np.unique(labels, return_inverse=True)
    names = [str(c) for c in classes] if class_names is None else [str(class_names[int(c)]) for c in classes]
    if len(classes) < 2:
        raise PlacecatError(
            f"all training samples are of class {names[0]!r}; a multi-class scheme needs 2 classes or more"
        )
    counts = np.bincount(index)
    if counts.min() < 2:
        name = names[int(counts.argmin())]
        raise PlacecatError(
            f"class {name!r} has 1 training sample; cross-validation needs 2 or more, or drop it"
        )
    return samples, classes, index, names


class OneAgainstAll(ClassifierMixin, BaseEstimator):
    """The parallel probabilistic multi-class scheme, thesis 3.3.1.2, equations (6) to (9).

    One base classifier a class gives p(o_k|x). With reliabilities p(o_k|l_i) from cross-validation and class
    frequencies p(l_i), p(l_i|o_k) = p(o_k|l_i) p(l_i) / p(o_k) and p(l_i|x) = sum_k p(l_i|o_k) p(o_k|x),
    normalised.

    Parameters
    ----------
    base
        Two-class classifier: `NuSVM` (the default), `RVM`, `GentleAdaBoost`, or any of scikit-learn's (the
        latter without shared preparation and `to_arrays`).
    calibration
        What is held out for the sigmoids and the reliabilities, see
        :class:`~placecat.learning.calibration.Calibration`: ``samples`` (the default), ``consecutive``,
        ``homes_centred`` or ``homes_averaged``.
    sigmoid
        Where p(o_k|x) comes from: ``platt`` fits a sigmoid to held-out decision values; ``own`` takes the
        base's probability: equation (8) for boosting, the logistic likelihood for the RVM. ``auto``: equation
        (8) for boosting, Platt for nu-SVM and RVM, as dlib does for the thesis.
    sigmoid_weights
        ``balanced`` weighs positives and negatives equally in Platt's sigmoid; ``none`` does not (Platt).
    combination
        ``parallel``, equation (6); or ``certainty``, the p(o_k|x) normalised, so that the classifier with the
        highest certainty decides, which 3.3.1.2 mentions as the simpler way.
    exclusive
        Divide the p(o_k|x) of a sample by their sum before (6) and (7): (6) is the law of total probability
        only if exactly one of the o_k happens. False takes them as they are.
    reliability
        What p(o_k|l_i) counts among held-out samples of class i: ``soft``, the mean of p(o_k|x); ``hard``,
        the share with p(o_k|x) >= 0.5, or, with `exclusive`, where it is the largest. The thesis says
        "statistics from cross-validating", not which.
    reliability_smoothing
        Added to each count; 0 lets a classifier that never said yes be ignored. The thesis does not give
        this.
    prior
        p(l_i): ``uniform``, as the thesis assumes for nearest neighbours (3.3.1.1) and the measure, a mean
        over places, suggests; or the ``training`` frequencies as it has them here.
    uncertainty
        gamma of equation (9). beta = gamma (1 / max_k p(o_k|x) - 1) is spread evenly over the classes before
        normalisation. 0 is off.
    folds
        Parts of the samples that are held out. The thesis does not give this.
    n_jobs
        Threads over (class, fold) pairs. The result does not depend on it.

    Attributes
    ----------
    classes_
        (K,) labels, sorted.
    reliability_
        (K, K) float64, row i, column k: p(o_k|l_i).
    prior_
        (K,) p(l_i).
    posterior_
        (K, K), row i, column k: p(l_i|o_k). Columns sum to 1.
    sigmoid_
        (M, 2) A <= 0 and B of p = 1 / (1 + exp(A d + B)) of each machine.
    machine_class_
        (M,) the k of each machine, ascending; p(o_k|x) is the mean over the class's machines. One a class,
        but for ``homes_averaged``.
    flat_
        (K,) sigmoids of each class that would have fallen, and are flat.
    cv_outputs_
        (n, K) held-out p(o_k|x) of the training samples.
    nu_
        (K,) nu in force of each class, NaN for a base without one.
    fold_nu_
        K arrays, nu of each held-out part.
    scorer_
        The M decision functions together.
    n_features_in_
        D.

    Examples
    --------
    >>> X = np.repeat([[0.0], [1.0], [2.0]], 10, axis=0) + np.tile(np.linspace(-0.2, 0.2, 10), 3)[:, None]
    >>> y = np.repeat(["bath", "hall", "kitchen"], 10)
    >>> model = OneAgainstAll(NuSVM(gamma=2.0, nu=0.2), folds=2).fit(X, y)
    >>> model.predict([[0.1], [1.9]]).tolist()
    ['bath', 'kitchen']
    """

    #: Attributes that prediction does without: a stored system leaves them out.
    TRAINING_ONLY = ("cv_outputs_",)

    def __init__(
        self,
        base: Any = None,
        calibration: str = "samples",
        sigmoid: str = "auto",
        sigmoid_weights: str = "none",
        combination: str = "parallel",
        exclusive: bool = True,
        reliability: str = "soft",
        reliability_smoothing: float = 1.0,
        prior: str = "uniform",
        uncertainty: float = 0.0,
        folds: int = 5,
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

    def fit(
        self,
        X: ArrayLike,
        y: ArrayLike,
        groups: ArrayLike | None = None,
        gram: NDArray[Any] | None = None,
        class_names: Sequence[str] | None = None,
    ) -> Self:
        """Fit the K classifiers and their statistics.

        Parameters
        ----------
        X
            (n, D) real.
        y
            (n,) labels, every class at least twice.
        groups
            (n,) the home of each sample, for a calibration by home.
        gram
            (n, n) Gram matrix of X at the base's gamma, to share it between fits.
        class_names
            Names by integer label, for messages only.

        Raises
        ------
        PlacecatError
            For fewer than 2 classes, a class of 1 sample, an impossible setting, or a nu that is infeasible
            under the policy ``refuse``.
        """
        base = as_base(self.base)
        calibration = calibration_of(self, base)
        self._check_settings()
        samples, self.classes_, index, names = encode_classes(X, y, class_names)
        n, n_classes = len(samples), len(self.classes_)
        folds = make_folds(index, groups, calibration.kind, calibration.folds)
        members = np.ones(n, dtype=bool)
        problems = [Problem(f"class {names[k]!r}", index == k, members) for k in range(n_classes)]
        with single_blas_thread():
            shared = base.prepare(samples, gram=gram, n_jobs=self.n_jobs)
            fitted = fit_problems(base, shared, problems, folds, calibration, self.n_jobs)
        self.n_features_in_ = samples.shape[1]
        keep_machines(self, base, fitted, samples)
        frequency = np.bincount(index, minlength=n_classes) / n
        self.prior_ = frequency if self.prior == "training" else np.full(n_classes, 1.0 / n_classes)
        self.reliability_ = self._reliability(index, self.cv_outputs_)
        self._set_posterior()
        return self

    def _check_settings(self) -> None:
        if self.reliability not in RELIABILITIES:
            raise PlacecatError(f"unknown reliability {self.reliability!r}; choose 'hard' or 'soft'")
        if self.combination not in COMBINATIONS:
            raise PlacecatError(f"unknown combination {self.combination!r}; choose 'parallel' or 'certainty'")
        if self.prior not in PRIORS:
            raise PlacecatError(f"unknown prior {self.prior!r}; choose 'training' or 'uniform'")
        if not self.uncertainty >= 0 or not self.reliability_smoothing >= 0:
            raise PlacecatError("uncertainty and reliability_smoothing must be 0 or more")

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

    def _set_posterior(self) -> None:
        joint = self.reliability_ * self.prior_[:, None]
        p_output = joint.sum(axis=0)
        uniform = np.full_like(joint, 1.0 / len(joint))
        self.posterior_ = np.divide(joint, p_output, out=uniform, where=p_output > 0)

    def outputs(self, X: ArrayLike) -> NDArray[np.float64]:
        """Give p(o_k|x) of samples (n, D) as (n, K)."""
        return outputs_of(self, X)

    def combine(self, outputs: NDArray[np.float64]) -> NDArray[np.float64]:
        """Combine outputs p(o_k|x) (n, K) to distributions p(l_i|x) (n, K), equations (6), (7), (9)."""
        proba = outputs
        if self.combination == "parallel":
            proba = sum_products(self._exclude(outputs), self.posterior_)
        if self.uncertainty > 0:
            strongest = np.maximum(outputs.max(axis=1, keepdims=True), np.finfo(float).tiny)
            proba = proba + self.uncertainty * (1.0 / strongest - 1.0) / proba.shape[1]
        total = proba.sum(axis=1, keepdims=True)
        uniform = np.full_like(proba, 1.0 / proba.shape[1])
        return np.divide(proba, total, out=uniform, where=total > 0)

    def predict_proba(self, X: ArrayLike) -> NDArray[np.float64]:
        """Distributions (n, K) float64 over `classes_` of samples (n, D); rows sum to 1."""
        return self.combine(self.outputs(X))

    def predict(self, X: ArrayLike) -> NDArray[Any]:
        """Most probable class (n,) of samples (n, D)."""
        return self.classes_[self.predict_proba(X).argmax(axis=1)]

    def to_arrays(self) -> dict[str, NDArray[Any]]:
        """Give plain arrays, enough for `from_arrays`.

        Raises
        ------
        PlacecatError
            If the base is none of placecat's own.
        """
        arrays = {f"scorer/{name}": array for name, array in self.scorer_.to_arrays().items()}
        arrays["settings"] = pack_settings(self, self.scorer_.kind)
        for name in ARRAYS:
            arrays[name] = getattr(self, name)
        for k, nus in enumerate(self.fold_nu_):
            arrays[f"fold_nu/{k}"] = nus
        return arrays

    @classmethod
    def from_arrays(cls, arrays: dict[str, NDArray[Any]]) -> Self:
        """Rebuild a fitted scheme from `to_arrays`, or from the mapping that ``numpy.load`` returns."""
        parameters, scorer = unpack_settings(arrays)
        model = cls(**parameters)
        model.scorer_ = scorer
        for name in ARRAYS:
            setattr(model, name, arrays[name])
        model.fold_nu_ = [arrays[f"fold_nu/{k}"] for k in range(len(model.classes_))]
        model.n_features_in_ = scorer_width(scorer)
        model._set_posterior()
        return model


def calibration_of(scheme: Any, base: Any) -> Calibration:
    """Read the settings of a multi-class scheme that are about calibration.

    Raises
    ------
    PlacecatError
        For an unknown one, or one that the base cannot have.
    """
    own = uses_own(scheme.sigmoid, base)
    return Calibration(scheme.calibration, scheme.folds, own, is_balanced(scheme.sigmoid_weights))


def keep_machines(
    scheme: Any, base: Any, fitted: Sequence[FittedProblem], samples: NDArray[np.float32]
) -> None:
    """Set what a multi-class scheme keeps of its K fitted problems: `MACHINES`, `fold_nu_` and `scorer_`."""
    scheme.scorer_ = base.collect([machine for one in fitted for machine in one.machines], samples)
    scheme.sigmoid_ = np.concatenate([one.sigmoids for one in fitted])
    scheme.machine_class_ = np.repeat(np.arange(len(fitted)), [len(one.machines) for one in fitted])
    scheme.flat_ = np.array([one.flat for one in fitted])
    scheme.nu_ = np.array([min(float(getattr(m, "nu_", np.nan)) for m in one.machines) for one in fitted])
    scheme.fold_nu_ = [one.nu for one in fitted]
    scheme.cv_outputs_ = np.stack([one.outputs for one in fitted], axis=1)


def outputs_of(scheme: Any, X: ArrayLike) -> NDArray[np.float64]:
    """Give p(o_k|x) (n, K) of samples (n, D): the mean over the machines of each class."""
    proba = apply_sigmoid(scheme.scorer_.decisions(X), scheme.sigmoid_[:, 0], scheme.sigmoid_[:, 1])
    if len(scheme.machine_class_) == len(scheme.classes_):
        return proba
    starts = np.searchsorted(scheme.machine_class_, np.arange(len(scheme.classes_)))
    return np.add.reduceat(proba, starts, axis=1) / np.bincount(scheme.machine_class_)


def pack_settings(model: BaseEstimator, scorer_kind: str) -> NDArray[np.str_]:
    """Write an estimator's parameters, its base's among them, as one JSON string."""
    parameters = model.get_params(deep=False)
    base = NuSVM() if parameters["base"] is None else parameters["base"]
    packed = {"class": type(base).__name__, "parameters": base.get_params()}
    return np.array(json.dumps(parameters | {"base": packed, "scorer": scorer_kind}, sort_keys=True))


def unpack_settings(arrays: Any) -> tuple[dict[str, Any], Any]:
    """Read `pack_settings` and the scorer's arrays; gives the parameters and the scorer."""
    parameters = json.loads(str(arrays["settings"]))
    scorer_class = SCORERS[parameters.pop("scorer")]
    base = parameters["base"]
    parameters["base"] = BASES[base["class"]](**base["parameters"])
    prefix = "scorer/"
    own = {name[len(prefix) :]: arrays[name] for name in arrays if name.startswith(prefix)}
    return parameters, scorer_class.from_arrays(own)


def scorer_width(scorer: Any) -> int:
    """Features of a sample that a scorer expects."""
    return int(scorer.width if scorer.kind == "stumps" else scorer.support_vectors.shape[1])
