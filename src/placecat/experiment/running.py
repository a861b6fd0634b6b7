"""Computing one experiment, by the functions that the tables are computed by."""

from typing import Any

import numpy as np

from placecat import parallel
from placecat.compute import cluster
from placecat.errors import NotComputable
from placecat.evaluation import protocol
from placecat.evaluation.accuracy import confusion_matrix, home_accuracy
from placecat.experiment.combination import Experiment
from placecat.experiment.options import TRAINING_HOMES
from placecat.stages import splits, trials

Outcome = np.ndarray | str


def compute(experiment: Experiment, *, workers: int = 1) -> dict[str, Any]:
    """Train and test for every test home, fold and seed.

    Parameters
    ----------
    workers
        Processes. No result depends on it.

    Returns
    -------
    dict
        JSON types only: ``settings``; ``accuracy`` in percent, the mean over test homes, None without any;
        ``homes``, for each test home its ``accuracy``, the mean over seeds and folds, its ``reason`` if there
        is none, and ``folds``: for each tested home and seed ``accuracy`` and ``confusion``, counts with true
        places as rows.
    """
    folds = experiment.folds()
    keys = [
        (home, fold, seed) for home, of_home in folds.items() for fold in of_home for seed in experiment.seeds
    ]
    tasks = [(experiment, fold, seed) for _, fold, seed in keys]
    if workers > 1 or cluster() is not None:
        outcomes = parallel.in_parallel(_outcome, tasks, "experiment", n_jobs=workers)
    else:
        outcomes = [parallel.single_threaded(_outcome, task) for task in tasks]
    homes = {}
    for home in experiment.homes:
        own = [
            (fold.test, seed, found)
            for (of, fold, seed), found in zip(keys, outcomes, strict=True)
            if of == home
        ]
        homes[home] = _of_home(own)
    accuracies = [own["accuracy"] for own in homes.values() if own["accuracy"] is not None]
    return {
        "settings": _described(experiment),
        "classes": list(experiment.data.classes),
        "accuracy": float(np.mean(accuracies)) if accuracies else None,
        "reason": next((own["reason"] for own in homes.values() if own["reason"]), None),
        "homes": homes,
    }


def _of_home(outcomes: list[tuple[str, int | None, Outcome]]) -> dict[str, Any]:
    """As a table's cell: a home counts where every seed gave a number."""
    reasons = [found for _, _, found in outcomes if isinstance(found, str)]
    folds: dict[str, dict[str, Any]] = {}
    for test, seed, found in outcomes:
        if not isinstance(found, str):
            own = {"accuracy": home_accuracy(found), "confusion": found.tolist()}
            folds.setdefault(test, {})[protocol.seed_folder(seed)] = own
    accuracies = [own["accuracy"] for of_fold in folds.values() for own in of_fold.values()]
    return {
        "accuracy": None if reasons else float(np.mean(accuracies)),
        "reason": reasons[0] if reasons else None,
        "folds": folds,
    }


def _described(experiment: Experiment) -> dict[str, Any]:
    data = experiment.data
    return {
        "data": data.name,
        "judge": experiment.judge,
        "test_home": list(experiment.homes),
        "frames": experiment.frames,
        "seeds": list(experiment.seeds),
        **experiment.settings,
    }


def _outcome(experiment: Experiment, fold: protocol.Fold, seed: int | None) -> Outcome:
    """Counts of the decisions on the fold's test home, or why there are none."""
    data = experiment.data
    if not data.is_split:
        return trials.run_together(
            [experiment.settings], fold, seed, data.name, experiment.frames, data.classes
        )[0][0]
    train = []
    for home in fold.cue_homes:
        labels = data.labels(home, training=True)
        train.append((data.path(home), labels, protocol.select_frames(labels, **experiment.frames)))
    own = experiment.settings
    codebook = own.get("codebook")
    try:
        proba = splits.apply_cue(
            data.name,
            [fold.test],
            own["descriptor"],
            own["classifier"],
            codebook,
            seed,
            train,
            [],
            data.classes,
        )[f"test_{fold.test}"]
    except NotComputable as error:
        return str(error)
    truth = data.labels(fold.test, training=experiment.judge == TRAINING_HOMES)
    return confusion_matrix(truth, proba.argmax(axis=1), len(data.classes))
