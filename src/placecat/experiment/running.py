"""Run one experiment with the same functions as the tables, and describe the origin of its result."""

import hashlib
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from placecat import paths
from placecat.compute import cluster, parallel
from placecat.compute.fingerprint import PACKAGES, fingerprint
from placecat.evaluation.accuracy import confusion_matrix, home_accuracy
from placecat.evaluation.quality import probability_quality
from placecat.experiment import output
from placecat.experiment.combination import Experiment
from placecat.experiment.output import MEASURES
from placecat.results.quality import FILE_DECIMALS
from placecat.runs import items
from placecat.training import store, trial
from placecat.training.cue import Cue
from placecat.training.plan import Plan

# The `fingerprint` items that are part of a result's origin.
_OF_CODE = ("placecat", "Python", *PACKAGES, "OpenCV")
# The measures and confusion matrix for one test home and seed, or the reason why there are none.
Outcome = dict[str, Any] | str


def compute(experiment: Experiment, *, workers: int = 1) -> dict[str, Any]:
    """Train and test for every test home, fold and seed. The number of `workers` does not affect the results.

    Returns a dictionary of JSON types with the keys ``settings``, ``classes``, ``accuracy`` (in percent),
    ``log_loss`` (in nats), ``calibration_error`` (in percent), ``reason`` and ``homes``. The three measures
    are means over test homes, or None. ``reason`` says why the first test home without measures has none; if
    all have measures, it is None. ``homes`` has an entry for each test home. An entry has the same measures,
    averaged over seeds and folds, or the ``reason`` why there are none. It also has ``folds``: the measures
    and the ``confusion`` (counts, with true places as rows) for each tested home and seed.
    """
    plans = experiment.plans()
    keys = [
        (home, plan, seed) for home, of_home in plans.items() for plan in of_home for seed in experiment.seeds
    ]
    cue = trial.of_settings(experiment.settings)
    tasks = [(plan, cue, seed, experiment.probabilities) for _, plan, seed in keys]
    if workers > 1 or cluster() is not None:
        outcomes = parallel.in_parallel(_measure, tasks, "experiment", n_jobs=workers)
    else:
        outcomes = [parallel.single_threaded(_measure, task) for task in tasks]
    by_home: dict[str, list[tuple[str, int | None, Outcome]]] = {home: [] for home in plans}
    for (home, plan, seed), found in zip(keys, outcomes, strict=True):
        by_home[home].append((plan.tested[0].sequence, seed, found))
    homes = {home: _of_home(own) for home, own in by_home.items()}
    return {
        "settings": experiment.described(),
        "classes": list(experiment.data.classes),
        **_means([own for own in homes.values() if own["reason"] is None]),
        "reason": next((own["reason"] for own in homes.values() if own["reason"]), None),
        "homes": homes,
    }


def _measure(plan: Plan, cue: Cue, seed: int | None, probabilities: Mapping[str, Any]) -> Outcome:
    """Train on one fold, and measure the distributions predicted for its tested home."""
    truth, [(proba, _)] = trial.predict(plan, [cue], seed)
    if isinstance(proba, str):
        return proba
    confusion = confusion_matrix(truth, proba.argmax(axis=1), len(plan.classes))
    quality = probability_quality(truth, proba, **probabilities)
    return {
        "accuracy": home_accuracy(confusion),
        "confusion": confusion.tolist(),
        **{measure: round(value, FILE_DECIMALS) for measure, value in quality._asdict().items()},
    }


def _of_home(outcomes: list[tuple[str, int | None, Outcome]]) -> dict[str, Any]:
    """Average as the tables do: a home has means only if none of its numbers is missing."""
    reasons = [found for _, _, found in outcomes if isinstance(found, str)]
    folds: dict[str, dict[str, Any]] = {}
    for test, seed, found in outcomes:
        if not isinstance(found, str):
            folds.setdefault(test, {})[paths.seed_name(seed)] = found
    measured = [own for of_fold in folds.values() for own in of_fold.values()]
    return {
        **_means([] if reasons else measured),
        "reason": reasons[0] if reasons else None,
        "folds": folds,
    }


def _means(measured: list[dict[str, Any]]) -> dict[str, float | None]:
    return {
        measure: float(np.mean([one[measure] for one in measured])) if measured else None
        for measure in MEASURES
    }


def made_from(experiment: Experiment) -> dict[str, Any]:
    """Describe the inputs behind a result in JSON types, for result.json.

    The keys are ``settings``, ``plans`` (a checksum of the training and test plans), ``data`` (a checksum of
    the labels and descriptors of each sequence) and ``code`` (the versions of placecat, Python and the
    libraries).
    """
    plans = [plan for of_home in experiment.plans().values() for plan in of_home]
    sequences = sorted({part.home for plan in plans for part in (*plan.cues, *plan.tested)})
    versions = fingerprint()
    return {
        "settings": experiment.described(),
        "plans": _short(repr(plans)),
        "data": {name: _data(name, experiment.settings["descriptor"]) for name in sequences},
        "code": {name: versions[name] for name in _OF_CODE},
    }


def made_from_of(result: dict[str, Any]) -> dict[str, Any]:
    """Extract the origin from a result; it is incomplete if the job failed early."""
    return {name: result[name] for name in ("settings", "plans", "data", "code") if name in result}


def is_finished(folder: Path, wanted: dict[str, Any]) -> bool:
    """Return whether a job folder contains a result (an accuracy or a reason) with the expected origin."""
    found = output.read(folder)
    return output.FAILED not in found and made_from_of(found) == wanted


def _data(sequence: str, descriptor: dict[str, Any]) -> str:
    read = [paths.sequences(sequence) / "labels.csv", *store.files_of(sequence, descriptor)]
    return _short("\n".join(items.checksum(path) for path in read))


def _short(text: str) -> str:
    return hashlib.sha256(text.encode()).hexdigest()[:16]
