"""One two-class classifier a class, and the parallel probabilistic scheme that combines them."""

import json
import logging
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any, Protocol, Self, cast

import numpy as np
from joblib import Parallel, delayed
from numpy.typing import ArrayLike, NDArray
from sklearn.base import BaseEstimator, ClassifierMixin, clone

from placecat.errors import PlacecatError
from placecat.learning.gentle_adaboost import GentleAdaBoost, StumpEnsembles
from placecat.learning.kernels import KernelExpansion, check_samples
from placecat.learning.nu_svm import NuSVM
from placecat.learning.platt import apply_sigmoid, fit_sigmoid
from placecat.learning.products import sum_products
from placecat.learning.rvm import RVM
from placecat.learning.single_thread import single_blas_thread

logger = logging.getLogger(__name__)

CALIBRATIONS = ("auto", "platt", "own")
SIGMOID_WEIGHTS = ("none", "balanced")
COMBINATIONS = ("parallel", "certainty")
RELIABILITIES = ("hard", "soft")
PRIORS = ("training", "uniform")
BASES: dict[str, Any] = {"NuSVM": NuSVM, "RVM": RVM, "GentleAdaBoost": GentleAdaBoost}
SCORERS: dict[str, Any] = {"kernel": KernelExpansion, "stumps": StumpEnsembles}


class TwoClassBase(Protocol):
    """What a base classifier offers so that classes and folds share its preparation."""

    own_sigmoid: tuple[float, float] | None

    def check_parameters(self) -> None:
        """Raise PlacecatError for an impossible setting."""

    def prepare(
        self, X: NDArray[np.float32], gram: NDArray[Any] | None = None, n_jobs: int | None = None
    ) -> Any:
        """Compute what depends on the samples only."""

    def fit_rows(
        self,
        shared: Any,
        positive: NDArray[np.bool_],
        rows: NDArray[np.intp] | None = None,
        context: str = "",
    ) -> Any:
        """Fit on some of the samples."""

    def decide_rows(self, shared: Any, rows: NDArray[np.intp]) -> NDArray[np.float64]:
        """Decision values of some of the samples."""

    def collect(self, machines: Sequence[Any], X: NDArray[np.float32]) -> Any:
        """Join fitted machines to one function with `decisions` and `to_arrays`."""


Fold = tuple[NDArray[np.intp], NDArray[np.intp]]


def make_folds(y: NDArray[np.intp], groups: ArrayLike | None, folds: int) -> list[Fold]:
    """Split samples into training and held-out parts.

    Leave one group out where there are two groups or more: neighbouring frames of a home are near-duplicates,
    so a fold by frame would lie. Otherwise `folds` stratified folds of consecutive samples of each class,
    fewer if a class is smaller, but at least two.

    Parameters
    ----------
    y
        (n,) class index, each class at least twice.
    groups
        (n,) the home of each sample, or None.
    folds
        Number of folds where groups do not make them.

    Returns
    -------
    list of (train, test)
        Ascending indices.
    """
    if groups is not None:
        _, home = np.unique(np.asarray(groups), return_inverse=True)
        if home.shape != y.shape:
            raise PlacecatError(
                f"groups has shape {home.shape} for {len(y)} samples; give one group a sample"
            )
        if home.max() > 0:
            return [(np.flatnonzero(home != g), np.flatnonzero(home == g)) for g in range(home.max() + 1)]
        logger.warning(
            "all samples are of one group: cross-validation by consecutive frames instead of by group"
        )
    from sklearn.model_selection import StratifiedKFold

    counts = np.bincount(y)
    splits = int(max(2, min(folds, counts[counts > 0].min())))
    return list(StratifiedKFold(splits).split(np.zeros(len(y)), y))


@dataclass(frozen=True)
class Problem:
    """One two-class problem among the samples.

    Attributes
    ----------
    name
        What messages call it.
    positive
        (n,) bool.
    member
        (n,) bool, samples it is trained and calibrated on.
    """

    name: str
    positive: NDArray[np.bool_]
    member: NDArray[np.bool_]


@dataclass
class FittedProblem:
    """A base classifier fitted on all members, its sigmoid, and its held-out outputs.

    Attributes
    ----------
    machine
        The fitted base.
    sigmoid
        A, B of p = 1 / (1 + exp(A d + B)).
    outputs
        (n,) held-out p(o|x).
    fold_nu
        nu of each fold's classifier, NaN for a base without one.
    """

    machine: Any
    sigmoid: tuple[float, float]
    outputs: NDArray[np.float64]
    fold_nu: list[float] = field(default_factory=list)


def fit_problems(
    base: TwoClassBase,
    shared: Any,
    problems: Sequence[Problem],
    folds: Sequence[Fold],
    own: bool,
    balanced: bool,
    n_jobs: int | None,
) -> list[FittedProblem]:
    """Fit, cross-validate and calibrate two-class problems that share samples; (problem, fold) in threads.

    A problem with a fold whose training part lacks positives or negatives (a class that only one home has
    cannot be judged by home) is cross-validated by stratified consecutive samples instead, with a warning.

    Parameters
    ----------
    base
        Not fitted itself.
    shared
        From ``base.prepare``.
    own
        Take the base's own sigmoid instead of Platt's.
    balanced
        Of Platt's sigmoid, see `fit_sigmoid`.
    """
    n = len(problems[0].positive)
    everything = np.arange(n)
    plans: list[list[Fold]] = [_folds_for(problem, folds) for problem in problems]
    tasks: list[tuple[int, int]] = [(k, -1) for k in range(len(problems))]
    tasks += [(k, f) for k in range(len(problems)) for f in range(len(plans[k]))]

    def run(k: int, f: int) -> tuple[Any, NDArray[np.float64] | None]:
        problem = problems[k]
        train = everything if f < 0 else plans[k][f][0]
        train = train[problem.member[train]]
        where = problem.name if f < 0 else f"{problem.name} in fold {f + 1} of {len(plans[k])}"
        machine = clone(base).fit_rows(shared, problem.positive, None if len(train) == n else train, where)
        return machine, None if f < 0 else machine.decide_rows(shared, plans[k][f][1])

    results = Parallel(n_jobs=n_jobs, backend="threading")(delayed(run)(k, f) for k, f in tasks)
    fitted = []
    for k, problem in enumerate(problems):
        decisions = np.empty(n)
        nus = []
        for (task, f), (machine, values) in zip(tasks, results, strict=True):
            if task == k and f >= 0:
                decisions[plans[k][f][1]] = values
                nus.append(float(getattr(machine, "nu_", np.nan)))
        sigmoid = base.own_sigmoid if own else None
        if sigmoid is None:
            sigmoid = fit_sigmoid(decisions[problem.member], problem.positive[problem.member], balanced)
        fitted.append(FittedProblem(results[k][0], sigmoid, apply_sigmoid(decisions, *sigmoid), nus))
    return fitted


def _folds_for(problem: Problem, folds: Sequence[Fold]) -> list[Fold]:
    positive, member = problem.positive, problem.member

    def trainable(rows: NDArray[np.intp]) -> bool:
        labels = positive[rows[member[rows]]]
        return bool(labels.any() and not labels.all())

    if all(trainable(train) for train, _ in folds):
        return list(folds)
    logger.warning(
        "%s: cannot be cross-validated by group, one group holds all its positive or negative samples; "
        "consecutive samples are held out instead",
        problem.name,
    )
    kind = np.where(member, np.where(positive, 2, 1), 0)
    return make_folds(np.unique(kind, return_inverse=True)[1], None, max(len(folds), 2))


class _GenericBase:
    """Adapter: any scikit-learn two-class classifier as a base, without sharing."""

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
    kind = "generic"

    def __init__(self, machines: Sequence[_GenericBase]) -> None:
        self.machines = machines

    def decisions(self, X: ArrayLike) -> NDArray[np.float64]:
        samples = check_samples(X)
        return np.stack([machine.decide(samples) for machine in self.machines], axis=1)

    def to_arrays(self) -> dict[str, NDArray[Any]]:
        raise PlacecatError(
            "only NuSVM, RVM and GentleAdaBoost can be written as arrays; to save a model, use one as base"
        )


def as_base(base: Any) -> TwoClassBase:
    """Give `base` itself if it shares its preparation, else adapt a scikit-learn classifier."""
    base = NuSVM() if base is None else base
    adapted: Any = base if hasattr(base, "fit_rows") else _GenericBase(base)
    adapted.check_parameters()
    return cast(TwoClassBase, adapted)


def uses_own(calibration: str, base: TwoClassBase) -> bool:
    """Tell whether the base's own sigmoid is to be used rather than Platt's."""
    if calibration not in CALIBRATIONS:
        raise PlacecatError(f"unknown calibration {calibration!r}; choose one of {', '.join(CALIBRATIONS)}")
    if calibration == "own" and base.own_sigmoid is None:
        raise PlacecatError(
            "calibration 'own' needs a base with probabilities; a nu-SVM has none, use 'platt'"
        )
    if calibration == "auto":
        return base.own_sigmoid is not None and getattr(base, "prefers_own_sigmoid", True)
    return calibration == "own"


def is_balanced(sigmoid_weights: str) -> bool:
    """Read the setting `sigmoid_weights`."""
    if sigmoid_weights not in SIGMOID_WEIGHTS:
        raise PlacecatError(f"unknown sigmoid_weights {sigmoid_weights!r}; choose 'none' or 'balanced'")
    return sigmoid_weights == "balanced"


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
        p(l_i): ``uniform``, or the ``training`` frequencies as the thesis has it. The measure is a mean over
        places, so that none is to be preferred; and with folds by home, which show how weak the classifiers
        are, the training frequencies make (6) name the most frequent place always.
    uncertainty
        gamma of equation (9). beta = gamma (1 / max_k p(o_k|x) - 1) is spread evenly over the classes before
        normalisation. 0 is off.
    folds
        Folds where `fit` gets no groups. The thesis does not give this.
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
        (K, 2) A and B of p(o_k|x) = 1 / (1 + exp(A d + B)).
    cv_outputs_
        (n, K) held-out p(o_k|x) of the training samples.
    cv_proba_
        (n, K) distribution of each training sample, from its held-out outputs and from reliabilities of the
        other folds.
    nu_
        (K,) nu in force of each class, NaN for a base without one.
    fold_nu_
        K arrays, nu of each fold.
    scorer_
        The K decision functions together.
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
    TRAINING_ONLY = ("cv_outputs_", "cv_proba_")

    def __init__(
        self,
        base: Any = None,
        calibration: str = "auto",
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
            (n,) the home of each sample: cross-validation leaves one out. None: `make_folds`.
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
        own = uses_own(self.calibration, base)
        balanced = is_balanced(self.sigmoid_weights)
        self._check_settings()
        samples, self.classes_, index, names = encode_classes(X, y, class_names)
        n, n_classes = len(samples), len(self.classes_)
        folds = make_folds(index, groups, self.folds)
        members = np.ones(n, dtype=bool)
        problems = [Problem(f"class {names[k]!r}", index == k, members) for k in range(n_classes)]
        with single_blas_thread():
            shared = base.prepare(samples, gram=gram, n_jobs=self.n_jobs)
            fitted = fit_problems(base, shared, problems, folds, own, balanced, self.n_jobs)
        self.n_features_in_ = samples.shape[1]
        self.scorer_ = base.collect([f.machine for f in fitted], samples)
        self.sigmoid_ = np.array([f.sigmoid for f in fitted])
        self.nu_ = np.array([float(getattr(f.machine, "nu_", np.nan)) for f in fitted])
        self.fold_nu_ = [np.array(f.fold_nu) for f in fitted]
        self.cv_outputs_ = np.stack([f.outputs for f in fitted], axis=1)
        frequency = np.bincount(index, minlength=n_classes) / n
        self.prior_ = frequency if self.prior == "training" else np.full(n_classes, 1.0 / n_classes)
        self.cv_proba_ = np.empty_like(self.cv_outputs_)
        for kept, held_out in folds:
            # Reliabilities of the other folds, so that a home's distributions owe nothing to its own labels.
            self._set_statistics(index[kept], self.cv_outputs_[kept])
            self.cv_proba_[held_out] = self.combine(self.cv_outputs_[held_out])
        self._set_statistics(index, self.cv_outputs_)
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
        if self.folds < 2:
            raise PlacecatError(f"folds = {self.folds}; cross-validation needs 2 or more")

    def _set_statistics(self, index: NDArray[np.intp], outputs: NDArray[np.float64]) -> None:
        self.reliability_ = self._reliability(index, outputs)
        self._set_posterior()

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
        return apply_sigmoid(self.scorer_.decisions(X), self.sigmoid_[:, 0], self.sigmoid_[:, 1])

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
        for name in ("classes_", "reliability_", "prior_", "sigmoid_", "nu_", "cv_outputs_", "cv_proba_"):
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
        for name in ("classes_", "reliability_", "prior_", "sigmoid_", "nu_", "cv_outputs_", "cv_proba_"):
            setattr(model, name, arrays[name])
        model.fold_nu_ = [arrays[f"fold_nu/{k}"] for k in range(len(model.classes_))]
        model.n_features_in_ = scorer_width(scorer)
        model._set_posterior()
        return model


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
