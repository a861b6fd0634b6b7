"""Compute the decision values of two-class classifiers for held-out samples, and calibrate them."""

import logging
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from joblib import Parallel, delayed
from numpy.typing import ArrayLike, NDArray
from sklearn.base import clone

from placecat import seeds
from placecat.errors import PlacecatError
from placecat.learning.boosting import Task
from placecat.learning.memory import bytes_of, remembered
from placecat.learning.platt import apply_sigmoid, fit_sigmoid
from placecat.learning.two_class import TwoClass

logger = logging.getLogger(__name__)

SAMPLES = "samples"
CONSECUTIVE = "consecutive"
CENTRED = "homes_centred"
AVERAGED = "homes_averaged"
CALIBRATIONS = (SAMPLES, CONSECUTIVE, CENTRED, AVERAGED)

Fold = tuple[NDArray[np.intp], NDArray[np.intp]]


@dataclass(frozen=True)
class Calibration:
    """How decision values are converted to probabilities.

    If each machine leaves out a different home, their values are not comparable. For example, a
    machine that leaves out a home with many positives sees few positives in training, so its values for that
    home are low. Such values are never pooled as they are, because a sigmoid fitted to them can fall where it
    should rise.

    Attributes
    ----------
    kind
        Which samples are held out, and how their values are used. ``samples`` splits each class into `folds`
        random parts, as in dlib, which the thesis uses (3.3.1.2). ``consecutive`` splits it into `folds` runs
        of consecutive samples, as in dlib without shuffling. Both fit one sigmoid to all values.
        ``homes_centred`` and ``homes_averaged`` hold out one home at a time. ``homes_centred`` shifts each
        home's values to a common mean and then fits one sigmoid to all of them. ``homes_averaged`` fits a
        sigmoid for each machine and averages the resulting probabilities.
    folds
        Number of parts, at least 2. Ignored if homes are held out.
    own
        Whether to use the base classifier's own sigmoid instead of Platt's.
    balanced
        Whether the classes have equal weight when Platt's sigmoid is fitted; see
        :func:`placecat.learning.platt.fit_sigmoid`.
    """

    kind: str = SAMPLES
    folds: int = 5
    own: bool = False
    balanced: bool = False


@dataclass(frozen=True)
class Problem:
    """A two-class problem on n samples."""

    #: Name to show in messages.
    name: str
    #: (n,), true for the positive samples.
    positive: NDArray[np.bool_]
    #: (n,), true for the samples used in training and calibration.
    member: NDArray[np.bool_]


@dataclass
class FittedProblem:
    """The fitted machines for one two-class problem, and their outputs for held-out samples."""

    #: Fitted base classifiers: one fitted on all members, or one per home left out. The probabilities of the
    #: latter are averaged.
    machines: list[Any]
    #: (machines, 2): A <= 0 and B in p = 1 / (1 + exp(A d + B)).
    sigmoids: NDArray[np.float64]
    #: (n,) held-out p(o|x).
    outputs: NDArray[np.float64]
    #: nu of each machine trained with one part left out, or NaN if the base classifier has no nu.
    nu: NDArray[np.float64]
    #: Number of sigmoids that are flat because the decision values were uninformative or reversed.
    flat: int


def make_folds(y: NDArray[np.intp], groups: ArrayLike | None, kind: str, folds: int) -> list[Fold]:
    """Split samples into training and held-out parts.

    Parameters
    ----------
    y
        (n,) class indices, where each class occurs at least twice.
    groups
        (n,) home of each sample, or None. Raises PlacecatError if `kind` needs homes and there is not exactly
        one per sample.
    kind
        The `kind` of a :class:`Calibration`. If it holds out homes but there is only one home, consecutive
        samples are held out instead.
    folds
        Number of stratified parts. It is reduced to the size of the smallest class if necessary.

    Returns
    -------
    list of (train, test)
        Ascending indices.
    """
    if kind in (CENTRED, AVERAGED):
        if groups is None:
            raise PlacecatError(
                f"calibration {kind!r} needs the home of each sample (groups); "
                f"use {SAMPLES!r} or {CONSECUTIVE!r}"
            )
        _, home = np.unique(np.asarray(groups), return_inverse=True)
        if home.shape != y.shape:
            raise PlacecatError(
                f"groups has shape {home.shape} for {len(y)} samples; pass one group per sample"
            )
        if home.max() > 0:
            return [(np.flatnonzero(home != g), np.flatnonzero(home == g)) for g in range(home.max() + 1)]
        logger.warning("all samples come from one home, so consecutive samples are held out instead of homes")
    from sklearn.model_selection import StratifiedKFold

    counts = np.bincount(y)
    parts = int(max(2, min(folds, counts[counts > 0].min())))
    if kind == SAMPLES:
        split = StratifiedKFold(parts, shuffle=True, random_state=seeds.derive("calibration", "parts"))
    else:
        split = StratifiedKFold(parts)
    return list(split.split(np.zeros(len(y)), y))


def fit_problems(
    base: TwoClass,
    shared: Any,
    problems: Sequence[Problem],
    folds: Sequence[Fold],
    calibration: Calibration,
    n_jobs: int | None,
) -> list[FittedProblem]:
    """Fit, cross-validate and calibrate two-class problems on the same samples.

    Each (problem, fold) pair is a separate task, so that threads can share the work.

    The training part of a fold may lack positives or negatives, for example if the class occurs in only one
    home. In that case, a warning is logged, and stratified parts of consecutive samples are held out instead.
    `shared` comes from ``base.prepare``, and `folds` comes from :func:`make_folds`. `base` itself is not
    fitted.
    """
    n = len(problems[0].positive)
    everything = np.arange(n)
    plans = [_plan(problem, folds, calibration) for problem in problems]

    def task(problem: Problem, train: NDArray[np.intp], where: str = "") -> Task:
        train = train[problem.member[train]]
        return problem.positive, None if len(train) == n else train, problem.name + where

    tasks = [task(problem, everything) for problem in problems]
    for problem, (own_folds, _) in zip(problems, plans, strict=True):
        for number, (train, _) in enumerate(own_folds, start=1):
            tasks.append(task(problem, train, f" in fold {number} of {len(own_folds)}"))
    machines_of_all = iter(_fit_all(base, shared, tasks, n_jobs))
    whole = [next(machines_of_all) for _ in problems]
    fitted = []
    for problem, machine, (own_folds, own_calibration) in zip(problems, whole, plans, strict=True):
        machines = [next(machines_of_all) for _ in own_folds]
        tests = [test for _, test in own_folds]
        values = [one.decide_rows(shared, test) for one, test in zip(machines, tests, strict=True)]
        nu = np.array([float(getattr(one, "nu_", np.nan)) for one in machines])
        sigmoids, outputs, flat, averaged = _calibrate(base, problem, tests, values, own_calibration)
        kept = [machines[f] for f in averaged] if averaged else [machine]
        fitted.append(FittedProblem(kept, sigmoids, outputs, nu, flat))
    flat_names = [problem.name for problem, one in zip(problems, fitted, strict=True) if one.flat]
    if flat_names:
        # A stage may log thousands of these messages, so the caller logs one warning with the total.
        logger.info(
            "the held-out decision values of %s are uninformative or reversed, so the sigmoid is flat",
            ", ".join(flat_names),
        )
    return fitted


def _fit_all(base: TwoClass, shared: Any, tasks: Sequence[Task], n_jobs: int | None) -> list[Any]:
    """Fit a machine for each task. Inside `remembering`, identical tasks on the same samples share a fit."""
    settings = base.get_params()
    if not all(isinstance(value, str | int | float | None) for value in settings.values()):
        return _fit_missing(base, shared, tasks, n_jobs)
    # Keep only the machines for the most recently prepared samples, because prepared samples may be large.
    machines: dict[Any, Any] = remembered("machines", (shared,), dict, latest=True)
    of_base = type(base).__name__, tuple(sorted(settings.items()))
    keys = [(of_base, positive.tobytes(), bytes_of(rows)) for positive, rows, _ in tasks]
    missing = {key: task for key, task in zip(keys, tasks, strict=True) if key not in machines}
    machines |= zip(missing, _fit_missing(base, shared, list(missing.values()), n_jobs), strict=True)
    return [machines[key] for key in keys]


def _fit_missing(base: TwoClass, shared: Any, tasks: Sequence[Task], n_jobs: int | None) -> list[Any]:
    if hasattr(base, "fit_together"):
        return base.fit_together(shared, tasks) if tasks else []
    fits = (delayed(clone(base).fit_rows)(shared, *task) for task in tasks)
    return list(Parallel(n_jobs=n_jobs, backend="threading")(fits))


def centre(values: Sequence[NDArray[np.float64]]) -> list[NDArray[np.float64]]:
    """Make decision values comparable across machines that each leave out a different home.

    `values` and the result have one array per home. All arrays are shifted to the same mean: the average of
    the original means, which is also the mean expected for an unseen home.

    Examples
    --------
    >>> [one.tolist() for one in centre([np.array([0.0, 2.0]), np.array([10.0, 12.0])])]
    [[5.0, 7.0], [5.0, 7.0]]
    """
    means = [float(one.mean()) for one in values]
    return [one - mean + float(np.mean(means)) for one, mean in zip(values, means, strict=True)]


def _calibrate(
    base: TwoClass,
    problem: Problem,
    tests: Sequence[NDArray[np.intp]],
    values: Sequence[NDArray[np.float64]],
    calibration: Calibration,
) -> tuple[NDArray[np.float64], NDArray[np.float64], int, list[int]]:
    """Return sigmoids, held-out outputs, the number of flat sigmoids, and the folds to average over."""
    outputs = np.empty(len(problem.positive))
    positive, member = problem.positive, problem.member
    if calibration.kind == AVERAGED:
        sigmoids, flat = [], 0
        for test, decided in zip(tests, values, strict=True):
            own, is_flat = _sigmoid(base, decided, positive[test], member[test], calibration)
            sigmoids.append(own)
            flat += is_flat
            outputs[test] = apply_sigmoid(decided, *own)
        return np.array(sigmoids), outputs, flat, list(range(len(tests)))
    comparable = centre(values) if calibration.kind == CENTRED else values
    rows, decided = np.concatenate(tests), np.concatenate(comparable)
    sigmoid, flat = _sigmoid(base, decided, positive[rows], member[rows], calibration)
    outputs[rows] = apply_sigmoid(decided, *sigmoid)
    return np.array([sigmoid]), outputs, int(flat), []


def _sigmoid(
    base: TwoClass,
    decided: NDArray[np.float64],
    positive: NDArray[np.bool_],
    member: NDArray[np.bool_],
    calibration: Calibration,
) -> tuple[tuple[float, float], bool]:
    if calibration.own and base.own_sigmoid is not None:
        return base.own_sigmoid, False
    positive = positive[member]
    sigmoid = fit_sigmoid(decided[member], positive, calibration.balanced)
    # A home with only one of the two classes cannot determine a slope, so it does not count as flat.
    return sigmoid, bool(sigmoid[0] == 0.0 and positive.any() and not positive.all())


def _plan(
    problem: Problem, folds: Sequence[Fold], calibration: Calibration
) -> tuple[list[Fold], Calibration]:
    positive, member = problem.positive, problem.member

    def trainable(rows: NDArray[np.intp]) -> bool:
        labels = positive[rows[member[rows]]]
        return bool(labels.any() and not labels.all())

    if all(trainable(train) for train, _ in folds):
        return list(folds), calibration
    logger.warning(
        "%s: homes cannot be held out, because one home has all the positive or all the negative samples; "
        "consecutive samples are held out instead",
        problem.name,
    )
    kind = np.where(member, np.where(positive, 2, 1), 0)
    index = np.unique(kind, return_inverse=True)[1]
    own = Calibration(CONSECUTIVE, calibration.folds, calibration.own, calibration.balanced)
    return make_folds(index, None, CONSECUTIVE, max(len(folds), 2)), own
