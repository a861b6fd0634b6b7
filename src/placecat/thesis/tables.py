"""The thesis's tables, with measured and published numbers."""

from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd

from placecat import files, paths, settings
from placecat.evaluation.trials import AXES
from placecat.results.measured import Results
from placecat.thesis import definitions, layouts
from placecat.thesis.notes import COLUMNS as COLUMNS_OF_NOTES
from placecat.thesis.notes import Kind, Note, joined, with_notes, without_empty
from placecat.thesis.number import Number, nothing

ADDITION = "Addition"
COLUMNS = ["table", "group", "row", "column", "published", "measured", "spread", "seeds", "note"]

# A published cell's table, group, row and column.
PublishedKey = tuple[int, str, str, str]


def tables_of(params: Mapping[str, Any], root: Path = Path()) -> dict[str, dict[str, Any]]:
    """Return all of a run's tables by name, e.g. ``table_12``: first those of the thesis, then the additions.

    Each table is its definition (see :mod:`placecat.thesis.definitions`) plus its ``name``. Trials without a
    layout are not shown as tables (see :mod:`placecat.thesis.in_text`). `params` contains all settings, and
    `root` is the project folder.
    """
    found = definitions.tables(params, root)
    for study in definitions.studies(params, root).values():
        found |= {name: table for name, table in study.items() if table["layout"] is not None}
    order = sorted(found, key=lambda name: (found[name]["number"] is None, found[name]["number"], name))
    return {name: {**found[name], "name": name} for name in order}


def folder_of(table: Mapping[str, Any]) -> Path:
    """Return a table's folder.

    Tables with `needs` are kept in a separate folder, so that other runs leave them unchanged.
    """
    return paths.OPTIONAL_TABLES if "needs" in table else paths.TABLES


def dataset_of(table: Mapping[str, Any], params: Mapping[str, Any]) -> dict[str, Any]:
    """Return a table's data set: the main one, its split's (with the test sequences as homes), or another."""
    if "data" in table:
        return settings.get(params, "dataset") | {"title": table["data"], "thesis_data": None}
    if "split" not in table:
        return dict(settings.get(params, "dataset"))
    split = settings.get(params, f"splits.{table['split']}")
    return {**split["dataset"], "homes": split["test"]}


def label(table: Mapping[str, Any]) -> str:
    """Return a table's label, e.g. "Table 12", or "Addition" if it is not in the thesis."""
    return ADDITION if table["number"] is None else f"Table {table['number']}"


def contradictions_of(notes: pd.DataFrame) -> dict[PublishedKey, str]:
    """Map cells to `notes` about contradictions in the thesis (from data/thesis/contradictions.csv)."""
    rows = notes[["table", *AXES, "note"]].itertuples(index=False, name=None)
    return {(int(number), group, row, column): note for number, group, row, column, note in rows}


def in_percent(table: Mapping[str, Any]) -> bool:
    """Whether a table's numbers are percentages; otherwise its ``caption`` explains them."""
    return "caption" not in table


def read(params: Mapping[str, Any]) -> Iterator[tuple[dict[str, Any], pd.DataFrame, dict[str, Any]]]:
    """Yield each table's definition, its cells and notes (from the `tables` stage), and its data set."""
    noted = files.read_table(paths.NOTES, COLUMNS_OF_NOTES)
    for name, table in tables_of(params).items():
        cells = files.read_table(folder_of(table) / f"{name}.csv", [*AXES, "note"])
        yield table, with_notes(name, cells, noted), dataset_of(table, params)


def fill(table: Mapping[str, Any], results: Results, params: Mapping[str, Any]) -> pd.DataFrame:
    """Fill one of the tables from :func:`tables_of`, using :func:`fill_table` and the files in data/thesis.

    Raises PlacecatError if one of these files is damaged.
    """
    contradictions = contradictions_of(files.read_table(paths.CONTRADICTIONS, [*AXES, "note"]))
    published = files.read_table(paths.PUBLISHED, AXES)
    return fill_table(table, results, published, dataset_of(table, params), contradictions)


def fill_table(
    table: Mapping[str, Any],
    results: Results,
    published: pd.DataFrame,
    dataset: Mapping[str, Any],
    contradictions: Mapping[PublishedKey, str],
) -> pd.DataFrame:
    """Fill one table.

    Returns a DataFrame with the columns table (its number, or "Addition"), group, row, column, published,
    measured, spread, seeds and note. Two more columns are ``notes``, the parts of the note by kind, and
    ``number``, the :class:`~placecat.thesis.number.Number` behind the measured columns. The published cells
    come first, in their original order, followed by this run's additional cells. ``measured`` is in percent
    (see :func:`in_percent`); if it is NaN, a note says why. Raises PlacecatError if the run lacks a result.

    `table` is one of the tables from :func:`tables_of`. `published` contains all published cells, with the
    columns table, group, row, column and value, which is empty for "n/a". `dataset` is the table's data set
    (see :func:`dataset_of`), with ``homes``, ``classes``, ``title`` and ``thesis_data``. Each measured cell
    has a note with the title. If ``thesis_data`` differs from the table's, each cell with both a published
    and a measured number has a note that they are not comparable. `contradictions` comes from
    :func:`contradictions_of`.
    """
    number = table["number"]
    known = published[published["table"] == number]
    order = [tuple(key) for key in known[[*AXES]].itertuples(index=False)]
    value = dict(zip(order, known["value"], strict=True))
    cells = layouts.LAYOUTS[table["layout"]](table, results)
    rows = []
    for key in [*order, *(key for key in cells if key not in value)]:
        cell = cells.get(key) or nothing(_why_missing(key, dataset))
        missing = "the published cell is n/a" if key in value and np.isnan(value[key]) else ""
        notes = [
            Note(Kind.NOT_AVAILABLE, missing),
            Note(Kind.PUBLISHED, contradictions.get((number, *key), "")),
        ]
        columns = number_columns(cell, value.get(key, np.nan), notes, table, dataset)
        rows.append((number or ADDITION, *key, *columns))
    return pd.DataFrame(rows, columns=[*COLUMNS, "notes", "number"])


def number_columns(
    number: Number,
    published: float,
    about_published: Iterable[Note],
    entry: Mapping[str, Any],
    dataset: Mapping[str, Any],
) -> tuple[Any, ...]:
    """Return a number's columns, from ``published`` onwards.

    `entry` defines the number, which was measured on `dataset`.
    """
    notes = [Note(Kind.MEASURED, text) for text in number.notes]
    if np.isfinite(number.measured):
        notes.insert(0, Note(Kind.DATA, f"measured on {entry.get('data') or dataset['title']}"))
        thesis_data = entry.get("thesis_data")
        if np.isfinite(published) and thesis_data is not None and not comparable(entry, dataset):
            text = f"the published number is from the {thesis_data} and is not comparable"
            notes.append(Note(Kind.NOT_COMPARABLE, text))
    of_number = without_empty([*notes, *about_published])
    measured = (number.measured, number.spread, number.seeds)
    return (published, *measured, joined(of_number), of_number, number)


def comparable(table: Mapping[str, Any], dataset: Mapping[str, Any]) -> bool:
    """Whether a table's published numbers were measured on this run's data."""
    return table["thesis_data"] is not None and bool(table["thesis_data"] == dataset["thesis_data"])


def _why_missing(key: tuple[str, str, str], dataset: Mapping[str, Any]) -> str:
    """Return why the layout omits a published cell, for example because the data set has fewer homes."""
    _, row, column = key
    homes = len(dataset["homes"])
    if any(name.startswith("Home ") and int(name.removeprefix("Home ")) > homes for name in (row, column)):
        return f"the data set has only {homes} homes"
    if column in map(layouts.place_column, dataset["classes"]):
        return "no tested frame shows this place"
    return "the data set has no such place"
