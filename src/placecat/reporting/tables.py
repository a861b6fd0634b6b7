"""The thesis's tables: what was measured beside what was published."""

from collections.abc import Mapping
from typing import Any

import numpy as np
import pandas as pd

from placecat.reporting import layouts
from placecat.reporting.results import Results

COLUMNS = ["table", "group", "row", "column", "published", "measured", "note"]
_KEY = ["group", "row", "column"]

# Averages that contradict their own rows in the thesis; the published number stays.
CONTRADICTIONS = {
    (6, "", "Home 2", "Average"): "the published average contradicts its own row",
    (31, "", "Centrist + y-Pos", "Average"): "the published average contradicts its own row",
    (31, "", "HMM", "Average"): "the published average contradicts its own row",
}


def fill_table(
    table: Mapping[str, Any], results: Results, published: pd.DataFrame, dataset: Mapping[str, Any]
) -> pd.DataFrame:
    """Fill one table.

    Parameters
    ----------
    table
        Its configuration: ``number``, ``thesis_data``, ``layout`` and what the layout needs.
    published
        All published cells, columns table, group, row, column, value; an empty value is an n/a.
    dataset
        ``title``, which every measured cell's note names, and ``thesis_data``; if that is not the table's
        ``thesis_data``, every note says that the numbers do not compare.

    Returns
    -------
    DataFrame
        Columns table, group, row, column, published, measured, note: first the published cells in their
        order, then cells that only this run has. ``measured`` (percent, 2 decimals) is NaN only with a note
        that says why.
    """
    number = int(table["number"])
    known = published[published["table"] == number]
    order = [tuple(key) for key in known[_KEY].itertuples(index=False)]
    value = dict(zip(order, known["value"], strict=True))
    cells = {(cell.group, cell.row, cell.column): cell for cell in layouts.cells(table, results)}
    rows = []
    for key in [*order, *(key for key in cells if key not in value)]:
        cell = cells.get(key)
        notes = []
        if cell is None:
            notes.append(_why_missing(key, results))
        else:
            notes.append(cell.note or f"measured on {dataset['title']}")
            if key in value and not cell.note and not comparable(table, dataset):
                notes.append(f"the published number is from the {table['thesis_data']} and does not compare")
        contradiction = CONTRADICTIONS.get((number, *key))
        if contradiction:
            notes.append(contradiction)
        measured = np.nan if cell is None else round(cell.measured, 2)
        rows.append((number, *key, value.get(key, np.nan), measured, "; ".join(notes)))
    return pd.DataFrame(rows, columns=COLUMNS)


def comparable(table: Mapping[str, Any], dataset: Mapping[str, Any]) -> bool:
    """Whether the published numbers of a table were measured on the data of this run."""
    return bool(table["thesis_data"] == dataset["thesis_data"])


def _why_missing(key: tuple[str, str, str], results: Results) -> str:
    _, row, column = key
    for name in (row, column):
        if name.startswith("Home "):
            return f"the data set has only {len(results.homes)} homes"
    return (
        "this data set has no such class"
        if column.replace(" ", "_").lower() not in results.classes
        else ("the run has no such row")
    )
