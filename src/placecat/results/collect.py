"""Read the results of the `scores` stage from disk."""

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import pandas as pd

from placecat import files, paths, settings
from placecat.learning.toy_circles import NAMES
from placecat.results.measured import Results, from_scores
from placecat.results.quality import TEXT_COLUMNS, from_rows


def read_results(params: Mapping[str, Any]) -> Results:
    """Read all results of a run; raise PlacecatError if the `scores` stage has not run.

    `params` contains all settings, including the names of the homes and places.
    """
    others = [split["dataset"]["classes"] for split in settings.get(params, "splits").values()]
    results = from_scores(
        _read("scores"),
        _read("missing"),
        settings.get(params, "dataset.homes"),
        settings.get(params, "dataset.classes"),
        [*others, NAMES],
        _read("stays"),
        files.read_table(paths.SCORES / "dropped.csv", ["filter", "home"]),
    )
    quality = files.read_table(paths.SCORES / "probabilities.csv", TEXT_COLUMNS)
    return replace(results, quality=from_rows(quality))


def _read(name: str) -> pd.DataFrame:
    table = files.read_cells(paths.SCORES / f"{name}.csv")
    return table.astype({"frames": int}) if "frames" in table else table
