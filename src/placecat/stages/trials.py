"""Stage `trials`: train and test the cues in the tables of each study (thesis 4.2 and 4.4)."""

import json
import logging
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd

from placecat import files, paths, settings
from placecat.compute import parallel
from placecat.evaluation.trials import Trial, expand
from placecat.results.measured import MISSING_COLUMNS, SCORE_COLUMNS, Measured, score_rows
from placecat.runs import items
from placecat.stages import run
from placecat.thesis import definitions
from placecat.training import plan as plans
from placecat.training import protocol, store
from placecat.training.trial import Outcome, judge, of_settings

logger = logging.getLogger(__name__)

# The key, home and seed of a trial.
_Cell = tuple[str, str, int | None]

FACT_COLUMNS = ["trial", "home", "seed", "nu_lowest", "nu_highest", "flat_sigmoids"]


def main() -> None:
    """Train and test every trial of every study; write the decision counts."""
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
    outcomes = Outcomes(params)
    items.refresh(
        "trials",
        paths.TRIALS,
        wanted,
        lambda study, folder: make(studies[study], folder, outcomes, params),
        begin=lambda names: outcomes.plan([studies[name] for name in names]),
    )
    outcomes.end()
    facts = [paths.TRIALS / study / "facts.csv" for study in studies]
    flat = sum(int(files.read_table(path)["flat_sigmoids"].sum()) for path in facts)
    if flat:
        logger.warning(
            "%d sigmoids are flat: held-out decision values do not indicate the class, or are reversed "
            "(flat_sigmoids in %s)",
            flat,
            paths.TRIALS / "*" / "facts.csv",
        )


class Outcomes:
    """The outcomes of the trials in several studies.

    Trials with the same clusters, or with the same kind of classifier and the same descriptors, share
    computations and form one task, even across studies.
    """

    def __init__(self, params: Mapping[str, Any]) -> None:
        self._seeds = settings.get(params, "protocol.seeds")
        tested = settings.get(params, "protocol.test_homes")
        self._plans = {plan.test: plan for plan in plans.of_homes(params, "5-5-1", tested)}
        self._computed: dict[_Cell, Outcome] = {}
        self._waiting: Iterator[tuple[list[_Cell], list[Outcome]]] = iter(())

    def plan(self, studies: Sequence[Sequence[Trial]]) -> None:
        """Start the trials of all studies in one pool, study by study."""
        groups = list(self._group([trial for trials in studies for trial in trials]).values())
        tasks = [
            (self._plans[home], [of_settings(json.loads(key)) for key, _, _ in cells], seed)
            for cells in groups
            for _, home, seed in cells[:1]
        ]
        results = parallel.stream(judge, tasks, "trials")
        self._waiting = zip(groups, results, strict=True)

    def of(self, trial: Trial) -> dict[_Cell, Outcome]:
        """Return the outcomes of a trial, one per home and seed. Homes that are not tested are left out."""
        cells = [cell for cell in self._cells(trial) if cell[1] in self._plans]
        while not self._computed.keys() >= set(cells):
            group, results = next(self._waiting)
            self._computed |= zip(group, results, strict=True)
        return {cell: self._computed[cell] for cell in cells}

    def end(self) -> None:
        """Close the pool and its progress bar."""
        next(self._waiting, None)

    def _cells(self, trial: Trial) -> list[_Cell]:
        seeds = self._seeds if trial.settings.get("codebook") is not None else [None]
        return [(trial.key(), home, seed) for home in trial.homes for seed in seeds]

    def _group(self, trials: Sequence[Trial]) -> dict[tuple[str, str, int | None], list[_Cell]]:
        """Group the trials that share computations, in the order of the tables."""
        groups: dict[tuple[str, str, int | None], dict[_Cell, None]] = {}
        for trial in trials:
            shared = _shared(trial.settings)
            for cell in self._cells(trial):
                if cell[1] in self._plans:
                    groups.setdefault((shared, *cell[1:]), {})[cell] = None
        return {name: list(cells) for name, cells in groups.items()}


def _shared(trial: Mapping[str, Any]) -> str:
    """Return a key that is the same for all trials that share computations.

    The key consists of the descriptor and the codebook. Without a codebook, the classifier takes its place,
    except for its scheme and the settings of its base classifier.
    """
    codebook, classifier = trial.get("codebook"), trial["classifier"]
    if codebook is None:
        codebook = {name: value for name, value in classifier.items() if name != "scheme"}
        codebook["base"] = classifier.get("base", {}).get("name")
    return json.dumps([trial["descriptor"], codebook], sort_keys=True)


def make(trials: Sequence[Trial], folder: Path, outcomes: Outcomes, params: Mapping[str, Any]) -> None:
    """Write the outcomes of all trials in a study."""
    classes, seeds = list(settings.get(params, "dataset.classes")), settings.get(params, "protocol.seeds")
    computed = {cell: outcome for trial in trials for cell, outcome in outcomes.of(trial).items()}
    scores, missing = _collect(trials, computed, seeds, classes)
    files.write_csv(folder / "scores.csv", scores)
    files.write_csv(folder / "missing.csv", missing)
    files.write_csv(folder / "facts.csv", _facts(trials, computed))


def _collect(
    trials: Sequence[Trial],
    outcomes: Mapping[_Cell, Outcome],
    seeds: Sequence[int],
    classes: Sequence[str],
) -> tuple[pd.DataFrame, pd.DataFrame]:
    """Return a table of counts and a table of reasons; a home has counts only if every seed has a result."""
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


def _facts(trials: Sequence[Trial], outcomes: Mapping[_Cell, Outcome]) -> pd.DataFrame:
    """Return the range of nu and the number of flat sigmoids, for trials with two-class classifiers."""
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
