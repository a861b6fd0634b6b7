"""The metrics and plots that DVC compares between revisions."""

from collections.abc import Mapping
from typing import Any

import numpy as np
import pandas as pd

from placecat.errors import PlacecatError
from placecat.evaluation.trials import AXES
from placecat.results.measured import Measured, Results
from placecat.settings import refuse_unknown

CONFUSION, ACCURACY_BY_HOME = "confusion", "accuracy_by_home"
ACCURACY, LOG_LOSS = "accuracy", "log_loss"
# The key of a row or group that has no name, in a table where others have one.
_NAMELESS = "-"


def nested_metrics(tables: Mapping[str, pd.DataFrame]) -> dict[str, Any]:
    """Nest the ``measured`` numbers of filled tables for `dvc metrics`.

    Returns nested dicts with the levels name, group, row and column. A level is omitted from a table if all
    its labels are empty. For example, Table 26 is ``{"5-5-1, all cues": {"Gist": {"Home 1": 31.2}}}``, and
    Table 5 is ``{"SVM": {"Home 1": 31.2}}``. Cells and tables without numbers (NaN) are also omitted.
    """
    return {name: found for name, table in tables.items() if (found := _nest(table))}


def _nest(table: pd.DataFrame) -> dict[str, Any]:
    levels = [axis for axis in AXES if (table[axis] != "").any()]
    nested: dict[str, Any] = {}
    for *labels, measured in table[[*levels, "measured"]].itertuples(index=False, name=None):
        if not np.isfinite(measured):
            continue
        *above, last = [str(label) or _NAMELESS for label in labels] or [_NAMELESS]
        inner = nested
        for label in above:
            inner = inner.setdefault(label, {})
        inner[last] = round(float(measured), 2)
    return nested


def chosen_averages(results: Results, chosen: Mapping[str, Mapping[str, str]]) -> dict[str, Any]:
    """Average selected results over homes and seeds, as in the tables, for the columns of `dvc exp show`.

    `chosen` has the keys ``accuracy`` and ``log_loss``. Each maps a column's name, e.g. ``gist``, to its
    result, e.g. ``cues/gist/5-5-1``. Returns the accuracies by column (percent, two decimals) and, under
    ``log_loss``, the log-losses (nats, three decimals). Results that cannot be computed on this data set are
    omitted. Raises PlacecatError if a key or a result is unknown.
    """
    refuse_unknown(chosen, [ACCURACY, LOG_LOSS], "metrics")
    averages: dict[str, dict[str, float]] = {ACCURACY: {}, LOG_LOSS: {}}
    for kind, columns in chosen.items():
        for column, name in columns.items():
            if (one := _find(results, name, f"metrics.{kind}.{column}")) is None:
                continue
            found = {ACCURACY: round(float(one.by_home().mean()), 2)}
            found |= results.quality[name].averages() if kind == LOG_LOSS else {}
            if kind in found:
                averages[kind][column] = found[kind]
    return averages[ACCURACY] | {LOG_LOSS: averages[LOG_LOSS]}


def plot_data(results: Results, plots: Mapping[str, Mapping[str, str]]) -> dict[str, pd.DataFrame]:
    """Collect the data for `dvc plots`.

    `plots` has the keys ``confusion`` and ``accuracy_by_home``. Each maps a panel's name to the name of its
    result. Returns a dict that maps each file under reports/plots, e.g. ``confusion/smoothing.csv``, to its
    rows; a result that cannot be computed on this data set has no rows. Raises PlacecatError if a kind of
    plot or a result is unknown.
    """
    kinds = {CONFUSION: decisions, ACCURACY_BY_HOME: accuracies}
    refuse_unknown(plots, list(kinds), "plots")
    return {
        f"{kind}/{panel}.csv": kinds[kind](_find(results, name, f"plots.{kind}.{panel}"))
        for kind, panels in plots.items()
        for panel, name in panels.items()
    }


def _find(results: Results, name: str, where: str) -> Measured | None:
    """Look up a result; return None if it cannot be computed on this data set."""
    try:
        return results.find(name)
    except PlacecatError as error:
        raise PlacecatError(f"{where}: {error}") from None


def decisions(measured: Measured | None) -> pd.DataFrame:
    """Return the first seed's decisions, with the columns truth and decision and one row per tested frame.

    Rows are sorted by place. DVC's `confusion` template counts them.
    """
    if measured is None:
        return pd.DataFrame(columns=["truth", "decision"])
    counts = measured.confusion[0].sum(axis=0)
    truth, decision = np.repeat(np.indices(counts.shape).reshape(2, -1), counts.ravel(), axis=1)
    places = np.array(measured.classes)
    return pd.DataFrame({"truth": places[truth], "decision": places[decision]})


def accuracies(measured: Measured | None) -> pd.DataFrame:
    """Return a table with the columns home and accuracy, and one row per test home.

    Accuracies are in percent, averaged over places and seeds.
    """
    if measured is None:
        return pd.DataFrame(columns=["home", "accuracy"])
    mean = measured.by_home().mean(axis=0).round(2)
    return pd.DataFrame({"home": measured.homes, "accuracy": mean})
