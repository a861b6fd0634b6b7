"""Which decisions lie behind each row of a table."""

import itertools
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
import pandas as pd

from placecat.evaluation.trials import AXES, HOMES, trial_name
from placecat.reporting.number import AVERAGE, home_label
from placecat.reporting.results import Measured, Results

ALL_HOMES = "all"


def decisions_of(table: Mapping[str, Any], results: Results) -> dict[tuple[str, str], dict[str, Measured]]:
    """Find the results that each row of a table is computed from.

    Parameters
    ----------
    table
        Its configuration and its ``name`` (:func:`placecat.reporting.tables.tables_of`).

    Returns
    -------
    dict
        Group and row to the results by column; a row that is one result in several homes has it under "".
        Where a row is a home, the result is that of the home alone. What these data cannot give is left out.
    """
    if "trial" in table:
        return _of_trials(table, results)
    if "rows" in table:
        found = {(row["group"], row["row"]): results.measured.get(row["result"]) for row in table["rows"]}
        return {key: {"": one} for key, one in found.items() if one is not None}
    one = results.measured.get(table["result"])
    return {} if one is None else {("", row): {"": part} for row, part in _by_home(one, results).items()}


def in_home(one: Measured, home: str) -> Measured:
    """The part of a result that one home is.

    Parameters
    ----------
    home
        One of ``one.homes``.
    """
    number = one.homes.index(home)
    return Measured((home,), one.seeds, one.classes, one.confusion[:, number : number + 1])


def confusion_rows(one: Measured) -> pd.DataFrame:
    """Counts as a table: home, seed, truth, then a column for each place that was decided."""
    labels = list(itertools.product(one.homes, one.seeds, one.classes))
    counts = one.confusion.swapaxes(0, 1).reshape(-1, len(one.classes))
    return _labelled(["home", "seed", "truth"], labels, counts, one.classes)


def pooled_rows(one: Measured) -> pd.DataFrame:
    """Counts over all homes and seeds: truth, then a column for each place that was decided."""
    return _labelled(["truth"], [(truth,) for truth in one.classes], pooled_counts(one), one.classes)


def pooled_counts(one: Measured) -> np.ndarray:
    """(classes, classes) counts over all homes and seeds; row a true place, column a decided one."""
    return one.confusion.sum(axis=(0, 1))


def shares(counts: np.ndarray) -> np.ndarray:
    """(classes, classes) percent of the frames of each true place; NaN where there is no frame of it."""
    frames = counts.sum(axis=1, keepdims=True)
    return np.divide(100.0 * counts, frames, out=np.full(counts.shape, np.nan), where=frames > 0)


def _labelled(
    names: Sequence[str], labels: Sequence[tuple[str, ...]], counts: np.ndarray, classes: Sequence[str]
) -> pd.DataFrame:
    columns = dict(zip(names, zip(*labels, strict=True), strict=True))
    return pd.DataFrame(columns | dict(zip(classes, counts.T, strict=True)))


def _by_home(one: Measured, results: Results) -> dict[str, Measured]:
    """The homes of the main data set by their names in tables, and, of several, all together."""
    found = {
        home_label(number): in_home(one, home)
        for number, home in enumerate(results.homes, start=1)
        if home in one.homes
    }
    return found | ({AVERAGE: one} if len(one.homes) > 1 else {})


def _of_trials(table: Mapping[str, Any], results: Results) -> dict[tuple[str, str], dict[str, Measured]]:
    axes = [table["axes"].get(axis, {"": {}}) for axis in AXES]
    labels = [[""] if axis == HOMES else list(axis) for axis in axes]
    found: dict[tuple[str, str], dict[str, Measured]] = {}
    for group, row, column in itertools.product(*labels):
        one = results.measured.get(trial_name(table["name"], group, row, column))
        if one is None:
            continue
        if HOMES not in axes[:2]:
            found.setdefault((group, row), {})[column] = one
            continue
        for home, part in _by_home(one, results).items():
            key = (home, row) if axes[0] == HOMES else (group, home)
            found.setdefault(key, {})[column] = part
    return found
