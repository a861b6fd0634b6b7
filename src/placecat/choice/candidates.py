"""Candidate settings, and how to choose among them."""

import itertools
from collections.abc import Mapping, Sequence
from typing import Any

import pandas as pd

KEYS, NUMBERS = ["kind", "name", "candidate"], ["accuracy", "log_loss"]
TEXT = ["data", *KEYS, "test_home"]
COLUMNS = [*TEXT, *NUMBERS, *(f"test_{name}" for name in NUMBERS)]


def combinations(grids: Sequence[Mapping[str, Sequence[Any]]]) -> list[dict[str, Any]]:
    """List every combination of the values in each grid; the last setting changes fastest.

    >>> combinations([{"scaling": ["standard"], "gamma_scale": [1.0, 2.0]}])
    [{'scaling': 'standard', 'gamma_scale': 1.0}, {'scaling': 'standard', 'gamma_scale': 2.0}]
    """
    return [
        dict(zip(grid, values, strict=True)) for grid in grids for values in itertools.product(*grid.values())
    ]


def label(overrides: Mapping[str, Any]) -> str:
    """Name a candidate after the last part of each setting, such as ``scaling=standard, gamma_scale=1.0``."""
    return ", ".join(f"{name.rpartition('.')[2]}={value}" for name, value in overrides.items())


def choose(table: pd.DataFrame, margin: float) -> pd.DataFrame:
    """Choose a candidate for each cue and system from a table with columns `COLUMNS`.

    ``accuracy`` (percent) and ``log_loss`` are means over training homes that the model has not seen;
    ``test_accuracy`` and ``test_log_loss`` are ignored. Candidates whose mean accuracy is within `margin`
    points of the best count as equally accurate. Among these, the first one with the lowest log-loss is
    chosen. All data sets have the same weight, and so do all test homes in a data set. Returns one row per
    candidate, with the columns kind, name, candidate, accuracy, log_loss and chosen.
    """
    means = table.groupby([*KEYS, "data"], sort=False)[NUMBERS].mean()
    means = means.groupby(level=KEYS, sort=False).mean().reset_index()
    means["chosen"] = False
    for _, part in means.groupby(["kind", "name"], sort=False):
        good = part[part["accuracy"] >= part["accuracy"].max() - margin]
        means.loc[good["log_loss"].idxmin(), "chosen"] = True
    return means
