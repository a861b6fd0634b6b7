"""Find the results, with their decision counts, behind each row of a table."""

import itertools
from collections.abc import Mapping
from typing import Any

from placecat.evaluation.trials import AXES, HOMES, trial_name
from placecat.results.confusion import in_home
from placecat.results.measured import Measured, Results
from placecat.thesis.number import AVERAGE, home_label


def decisions_of(table: Mapping[str, Any], results: Results) -> dict[tuple[str, str], dict[str, Measured]]:
    """Find the results behind each row of a table (:func:`placecat.thesis.tables.tables_of`).

    Returns a dict that maps each (group, row) to that row's results, by column. If a row has a single result,
    its column is "". If a row stands for a home, its results are restricted to that home. Results that cannot
    be computed on this data set are omitted.
    """
    if "trial" in table:
        return _of_trials(table, results)
    if "rows" in table:
        found = {(row["group"], row["row"]): results.measured.get(row["result"]) for row in table["rows"]}
        return {key: {"": one} for key, one in found.items() if one is not None}
    one = results.measured.get(table["result"])
    return {} if one is None else {("", row): {"": part} for row, part in _by_home(one, results).items()}


def _by_home(one: Measured, results: Results) -> dict[str, Measured]:
    """Split a result by home; if there are several homes, include the complete result as the average."""
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
