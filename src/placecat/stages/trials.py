"""Stage `trials`: the cues of each study's tables, each in its test homes (thesis 4.2 and 4.4)."""

import json
import logging
from collections.abc import Collection, Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd

from placecat import files, items, parallel, paths, settings, store
from placecat.evaluation.trials import Trial, expand
from placecat.results.measured import MISSING_COLUMNS, SCORE_COLUMNS, Measured, score_rows
from placecat.stages import run
from placecat.thesis import definitions
from placecat.training import plan as plans
from placecat.training import protocol
from placecat.training.trial import Outcome, judge, of_settings

logger = logging.getLogger(__name__)

FACT_COLUMNS = ["trial", "home", "seed", "nu_lowest", "nu_highest", "flat_sigmoids"]


def main() -> None:
    """Train and test every trial of every study; write the counts of decisions."""
    params = settings.load()
    homes = list(settings.get(params, "dataset.homes"))
    shared = [settings.get(params, f"dataset.{name}") for name in ("name", "homes", "classes")]
    shared += [settings.get(params, f"protocol.{name}") for name in ("cue_frames", "seeds", "test_homes")]
    labels = [paths.sequences(home) / "labels.csv" for home in homes]
    studies = {
        study: [trial for name, table in tables.items() for trial in expand(name, table, homes)]
        for study, tables in definitions.studies(params).items()
    }
    wanted = {}
    for study, trials in studies.items():
        described = (
            path
            for trial in trials
            for home in homes
            for path in store.files_of(home, trial.settings["descriptor"])
        )
        own = [[trial.name, trial.settings, trial.homes] for trial in trials]
        wanted[study] = items.Inputs([own, *shared], (*labels, *dict.fromkeys(described)))
    items.refresh(
        "trials", paths.TRIALS, wanted, lambda study, folder: make(study, studies[study], folder, params)
    )
    facts = [paths.TRIALS / study / "facts.csv" for study in studies]
    flat = sum(int(files.read_csv(path)["flat_sigmoids"].sum()) for path in facts)
    if flat:
        logger.warning(
            "%d sigmoids are flat: held-out decision values are uninformative about their class or reversed "
            "(flat_sigmoids in %s)",
            flat,
            paths.TRIALS / "*" / "facts.csv",
        )


def make(study: str, trials: Sequence[Trial], folder: Path, params: Mapping[str, Any]) -> None:
    """Train and test every trial of a study."""
    classes = list(settings.get(params, "dataset.classes"))
    seeds, tested = settings.get(params, "protocol.seeds"), settings.get(params, "protocol.test_homes")
    planned = {plan.test: plan for plan in plans.of_homes(params, "5-5-1", tested)}
    wanted = _group(trials, seeds, planned)
    tasks = [
        (planned[home], [of_settings(json.loads(key)) for key in keys], seed)
        for (_, home, seed), keys in wanted.items()
    ]
    outcomes: dict[tuple[str, str, int | None], Outcome] = {}
    done = parallel.in_parallel(judge, tasks, f"trials {study}")
    for ((_, home, seed), keys), results in zip(wanted.items(), done, strict=True):
        outcomes |= {(key, home, seed): result for key, result in zip(keys, results, strict=True)}
    scores, missing = _collect(trials, outcomes, seeds, classes)
    files.write_csv(folder / "scores.csv", scores)
    files.write_csv(folder / "missing.csv", missing)
    files.write_csv(folder / "facts.csv", _facts(trials, outcomes))


def _group(
    trials: Sequence[Trial], seeds: Sequence[int], tested: Collection[str]
) -> dict[tuple[str, str, int | None], list[str]]:
    """Group trials on the same clusters, in the order of the tables; others stay alone."""
    wanted: dict[tuple[str, str, int | None], list[str]] = {}
    for trial in trials:
        shared = trial.settings.get("codebook")
        clusters = json.dumps([trial.settings["descriptor"], shared], sort_keys=True)
        for home in (home for home in trial.homes if home in tested):
            for seed in seeds if shared is not None else [None]:
                group = wanted.setdefault((clusters if shared is not None else trial.key(), home, seed), [])
                if trial.key() not in group:
                    group.append(trial.key())
    return wanted


def _collect(
    trials: Sequence[Trial],
    outcomes: Mapping[tuple[str, str, int | None], Outcome],
    seeds: Sequence[int],
    classes: Sequence[str],
) -> tuple[pd.DataFrame, pd.DataFrame]:
    """Rows of counts, and of reasons, of every trial; a home counts if every seed gave a number."""
    scores, missing = [], []
    for trial in trials:
        own_seeds = list(seeds) if trial.settings.get("codebook") is not None else [None]
        measured = []
        for home in trial.homes:
            nothing: Outcome = (protocol.NOT_TESTED, {})
            of_seeds = [outcomes.get((trial.key(), home, seed), nothing)[0] for seed in own_seeds]
            reasons = [outcome for outcome in of_seeds if isinstance(outcome, str)]
            if reasons:
                missing.append((trial.name, home, reasons[0]))
            else:
                measured.append((home, of_seeds))
        if measured:
            confusion = np.array([counts for _, counts in measured]).swapaxes(0, 1)
            names = tuple(paths.seed_name(seed) for seed in own_seeds)
            homes = tuple(home for home, _ in measured)
            scores += score_rows(trial.name, Measured(homes, names, tuple(classes), confusion))
    return pd.DataFrame(scores, columns=SCORE_COLUMNS), pd.DataFrame(missing, columns=MISSING_COLUMNS)


def _facts(trials: Sequence[Trial], outcomes: Mapping[tuple[str, str, int | None], Outcome]) -> pd.DataFrame:
    """The nu in force and the flat sigmoids of every trial with two-class classifiers."""
    rows = []
    for trial in trials:
        for (key, home, seed), (_, facts) in outcomes.items():
            if key == trial.key() and home in trial.homes and "flat_sigmoids" in facts:
                nu = facts.get("nu", [np.nan])
                flat = sum(facts["flat_sigmoids"])
                rows.append((trial.name, home, paths.seed_name(seed), min(nu), max(nu), flat))
    return pd.DataFrame(rows, columns=FACT_COLUMNS)


if __name__ == "__main__":
    run(main)
