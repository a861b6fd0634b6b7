"""Stage `scores`: how often frames of a place were decided to be which, for everything computed."""

from typing import Any

import numpy as np
import pandas as pd

from placecat import files, listing, paths, settings
from placecat.evaluation import protocol
from placecat.evaluation.accuracy import confusion_matrix, stays
from placecat.reporting.results import MISSING_COLUMNS, SCORE_COLUMNS, Measured, score_rows
from placecat.reporting.sources import Source, sources
from placecat.stages import run


def main() -> None:
    """Write scores.csv and missing.csv of the main pipeline, the splits, the trials and the toy problem.

    And stays.csv: the scores of the splits by stay; and dropped.csv: what each information filter drops.
    """
    params = settings.load()
    rows: list[Any] = []
    by_stay: list[Any] = []
    untested: list[Any] = []
    for name, source in sources(params).items():
        rows += score_rows(name, measure(source))
        if source.site:
            by_stay += score_rows(name, measure(source, by_stay=True))
        else:
            others = [home for home in settings.get(params, "dataset.homes") if home not in source.homes]
            untested += [(name, home, protocol.NOT_TESTED) for home in others]
    scores = [pd.DataFrame(rows, columns=SCORE_COLUMNS), files.read_csv(paths.TOY)]
    missing = [pd.DataFrame(untested, columns=MISSING_COLUMNS)]
    for study in settings.get(params, "studies"):
        scores.append(files.read_csv(paths.TRIALS / study / "scores.csv"))
        missing.append(files.read_csv(paths.TRIALS / study / "missing.csv"))
    with files.replacing(paths.SCORES) as folder:
        folder.mkdir(parents=True)
        files.write_csv(folder / "scores.csv", pd.concat(scores, ignore_index=True))
        files.write_csv(folder / "missing.csv", pd.concat(missing, ignore_index=True))
        files.write_csv(folder / "stays.csv", pd.DataFrame(by_stay, columns=SCORE_COLUMNS))
        files.write_csv(folder / "dropped.csv", files.read_csv(paths.FILTERED / "dropped.csv"))


def measure(source: Source, *, by_stay: bool = False) -> Measured:
    """Count the decisions of one result in all its test homes, or in each stay of them."""
    seeds = source.seeds()
    labels = {home: listing.read_labels(source.listed(home)) for home in source.homes}
    frames = {home: stays(own) if by_stay else [np.arange(len(own))] for home, own in labels.items()}
    names = [f"{home}/{n}" if by_stay else home for home in frames for n in range(1, len(frames[home]) + 1)]
    confusion = []
    for seed in seeds:
        decided = {
            home: files.read_array(source.array(home, seed), memory_map=False).argmax(axis=1)
            for home in source.homes
        }
        confusion.append(
            [
                confusion_matrix(labels[home][part], decided[home][part], len(source.classes))
                for home in source.homes
                for part in frames[home]
            ]
        )
    return Measured(tuple(names), seeds, source.classes, np.array(confusion))


if __name__ == "__main__":
    run(main)
