"""Stage `scores`: how often frames of a place were decided to be which, for everything computed."""

from typing import Any

import numpy as np
import pandas as pd

from placecat import files, listing, paths, settings
from placecat.evaluation import protocol
from placecat.evaluation.accuracy import confusion_matrix
from placecat.reporting.results import MISSING_COLUMNS, SCORE_COLUMNS, Measured, score_rows
from placecat.reporting.sources import Source, sources
from placecat.stages import run


def main() -> None:
    """Write scores.csv and missing.csv of the main pipeline, the splits, the trials and the toy problem."""
    params = settings.load()
    rows: list[Any] = []
    untested: list[Any] = []
    for name, source in sources(params).items():
        rows += score_rows(name, measure(source))
        if not source.site:
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


def measure(source: Source) -> Measured:
    """Count the decisions of one result in all its test homes."""
    seeds = source.seeds()
    labels = {home: listing.read_labels(source.listed(home)) for home in source.homes}
    confusion = [
        [
            confusion_matrix(
                labels[home],
                files.read_array(source.array(home, seed), memory_map=False).argmax(axis=1),
                len(source.classes),
            )
            for home in source.homes
        ]
        for seed in seeds
    ]
    return Measured(source.homes, seeds, source.classes, np.array(confusion))


if __name__ == "__main__":
    run(main)
