"""Stage `scores`: count decisions by true place, and measure the quality of probabilities."""

from collections.abc import Mapping
from typing import Any

import numpy as np
import pandas as pd

from placecat import files, paths, settings
from placecat.evaluation.accuracy import confusion_matrix
from placecat.evaluation.quality import home_quality
from placecat.evaluation.stays import find_stays
from placecat.results.measured import MISSING_COLUMNS, SCORE_COLUMNS, Measured, Quality, score_rows
from placecat.results.quality import QUALITY_COLUMNS, gather, quality_rows
from placecat.results.sources import Source, sources
from placecat.sequences import listing
from placecat.stages import run
from placecat.thesis import definitions
from placecat.training import protocol


def main() -> None:
    """Write scores.csv and missing.csv for the main pipeline, the splits, the trials and the toy problem.

    Three more files are written: stays.csv with the scores of the splits per stay, dropped.csv with the
    number of frames that each information filter drops, and probabilities.csv with the quality of the
    probabilities in the main pipeline and the splits.
    """
    params = settings.load()
    rows, by_stay, untested, qualities = ([] for _ in range(4))
    for name, source in sources(params).items():
        measured, quality = measure(source, settings.get(params, "probabilities"))
        rows += score_rows(name, measured)
        qualities += quality_rows(name, quality)
        if source.site:
            by_stay += score_rows(name, measure_stays(source))
        else:
            others = [home for home in settings.get(params, "dataset.homes") if home not in source.homes]
            untested += [(name, home, protocol.NOT_TESTED) for home in others]
    scores = [pd.DataFrame(rows, columns=SCORE_COLUMNS), files.read_cells(paths.TOY)]
    missing = [pd.DataFrame(untested, columns=MISSING_COLUMNS)]
    for study in definitions.studies(params):
        scores.append(files.read_cells(paths.TRIALS / study / "scores.csv"))
        missing.append(files.read_cells(paths.TRIALS / study / "missing.csv"))
    with files.replacing(paths.SCORES) as folder:
        folder.mkdir(parents=True)
        files.write_csv(folder / "scores.csv", pd.concat(scores, ignore_index=True))
        files.write_csv(folder / "missing.csv", pd.concat(missing, ignore_index=True))
        files.write_csv(folder / "stays.csv", pd.DataFrame(by_stay, columns=SCORE_COLUMNS))
        files.write_csv(folder / "dropped.csv", files.read_cells(paths.FILTERED / "dropped.csv"))
        files.write_csv(folder / "probabilities.csv", pd.DataFrame(qualities, columns=QUALITY_COLUMNS))


def measure(source: Source, options: Mapping[str, Any]) -> tuple[Measured, Quality]:
    """Count the decisions of one result in its test homes, and measure the quality of its distributions."""
    labels = {home: listing.read_labels(source.listed(home)) for home in source.homes}
    parts = {home: listing.sequence_slices(source.listed(home)) for home in source.homes}
    confusion, quality = [], []
    for seed in source.seeds():
        counts, numbers = [], []
        for home in source.homes:
            proba, own = source.array(home, seed), labels[home]
            counts.append(confusion_matrix(own, proba.argmax(axis=1), len(source.classes)))
            numbers.append(home_quality(own, proba, parts[home], **options))
        confusion.append(counts)
        quality.append(numbers)
    counted = Measured(source.homes, source.seeds(), source.classes, np.array(confusion))
    return counted, gather(source.homes, source.seeds(), quality)


def measure_stays(source: Source) -> Measured:
    """Count the decisions of one result for each stay in its test homes."""
    names, by_seed, stays = [], [], {}
    for home in source.homes:
        name = source.listed(home)
        labels = listing.read_labels(name)
        found = find_stays(labels, listing.sequence_slices(name))
        stays[home] = labels, [slice(stay.start, stay.stop) for stay in found]
        names += [f"{home}/{number + 1}" for number in range(len(found))]
    for seed in source.seeds():
        confusion = []
        for home, (labels, parts) in stays.items():
            decided = source.array(home, seed).argmax(axis=1)
            confusion += [confusion_matrix(labels[own], decided[own], len(source.classes)) for own in parts]
        by_seed.append(confusion)
    return Measured(tuple(names), source.seeds(), source.classes, np.array(by_seed))


if __name__ == "__main__":
    run(main)
