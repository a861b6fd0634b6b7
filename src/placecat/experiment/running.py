"""Compute one experiment with the functions behind the tables."""

from typing import Any

import numpy as np

from placecat import parallel, paths
from placecat.compute import cluster
from placecat.evaluation.accuracy import home_accuracy
from placecat.experiment.combination import Experiment
from placecat.training import trial

Outcome = np.ndarray | str


def compute(experiment: Experiment, *, workers: int = 1) -> dict[str, Any]:
    """Train and test for every test home, fold and seed; no result depends on the number of `workers`.

    Returns JSON types only: ``settings``; ``accuracy`` in percent, the mean over test homes, or None; and
    ``homes``. Each test home has its ``accuracy``, the mean over seeds and folds, or the ``reason`` why it
    has none, and ``folds``: ``accuracy`` and ``confusion`` (counts, true places as rows) of each tested home
    and seed.
    """
    plans = experiment.plans()
    keys = [
        (home, plan, seed) for home, of_home in plans.items() for plan in of_home for seed in experiment.seeds
    ]
    cue = trial.of_settings(experiment.settings)
    tasks = [(plan, [cue], seed) for _, plan, seed in keys]
    if workers > 1 or cluster() is not None:
        outcomes = parallel.in_parallel(trial.judge, tasks, "experiment", n_jobs=workers)
    else:
        outcomes = [parallel.single_threaded(trial.judge, task) for task in tasks]
    by_home: dict[str, list[tuple[str, int | None, Outcome]]] = {home: [] for home in plans}
    for (home, plan, seed), [(found, _)] in zip(keys, outcomes, strict=True):
        by_home[home].append((plan.tested[0].sequence, seed, found))
    homes = {home: _of_home(own) for home, own in by_home.items()}
    accuracies = [own["accuracy"] for own in homes.values() if own["accuracy"] is not None]
    return {
        "settings": experiment.described(),
        "classes": list(experiment.data.classes),
        "accuracy": float(np.mean(accuracies)) if accuracies else None,
        "reason": next((own["reason"] for own in homes.values() if own["reason"]), None),
        "homes": homes,
    }


def _of_home(outcomes: list[tuple[str, int | None, Outcome]]) -> dict[str, Any]:
    """Average as in a table's cell: a home counts if every seed has a number."""
    reasons = [found for _, _, found in outcomes if isinstance(found, str)]
    folds: dict[str, dict[str, Any]] = {}
    for test, seed, found in outcomes:
        if not isinstance(found, str):
            own = {"accuracy": home_accuracy(found), "confusion": found.tolist()}
            folds.setdefault(test, {})[paths.seed_name(seed)] = own
    accuracies = [own["accuracy"] for of_fold in folds.values() for own in of_fold.values()]
    return {
        "accuracy": None if reasons else float(np.mean(accuracies)),
        "reason": reasons[0] if reasons else None,
        "folds": folds,
    }
