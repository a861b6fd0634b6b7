"""Notes on the numbers of a table, by subject."""

from collections.abc import Iterable
from enum import StrEnum
from typing import NamedTuple

import pandas as pd

COLUMNS = ["table", "group", "row", "column", "kind", "text"]
_KEY = ["group", "row", "column"]


class Kind(StrEnum):
    """Subject of a note."""

    # The data set of the measured number; applies to the whole table.
    DATA = "data"
    # The published number is from other data; applies to the whole table.
    NOT_COMPARABLE = "not_comparable"
    # The published cell is "n/a".
    NOT_AVAILABLE = "not_available"
    # The published number of this cell, e.g. one that contradicts the thesis's other numbers.
    PUBLISHED = "published"
    # The measured number of this cell, or the reason why it is missing.
    MEASURED = "measured"


class Note(NamedTuple):
    """One note."""

    kind: Kind
    text: str

    @property
    def is_of_the_table(self) -> bool:
        """Whether it applies to the whole table and is in the caption."""
        return self.kind in (Kind.DATA, Kind.NOT_COMPARABLE)

    @property
    def is_about_the_published(self) -> bool:
        """Whether it is about the thesis's number."""
        return self.kind in (Kind.NOT_COMPARABLE, Kind.NOT_AVAILABLE, Kind.PUBLISHED)


Notes = tuple[Note, ...]


def joined(notes: Iterable[Note]) -> str:
    """Notes as one text, without duplicates."""
    return "; ".join(dict.fromkeys(note.text for note in notes))


def without_empty(notes: Iterable[Note]) -> Notes:
    """Notes without empty ones and duplicates."""
    return tuple(dict.fromkeys(note for note in notes if note.text))


def to_rows(name: str, cells: pd.DataFrame, key: Iterable[str] = _KEY) -> pd.DataFrame:
    """Column `notes` of a table as rows (`COLUMNS`), since a CSV cell cannot hold them.

    The three columns `key` identify the cell of a row.
    """
    rows = [
        (name, *labels, note.kind.value, note.text)
        for *labels, notes in cells[[*key, "notes"]].itertuples(index=False, name=None)
        for note in notes
    ]
    return pd.DataFrame(rows, columns=COLUMNS)


def with_notes(name: str, cells: pd.DataFrame, rows: pd.DataFrame, key: Iterable[str] = _KEY) -> pd.DataFrame:
    """A table with its column `notes` restored from the rows of :func:`to_rows` for one or many tables."""
    by_cell: dict[tuple[str, ...], Notes] = {}
    for _, *labels, kind, text in rows[rows["table"] == name][COLUMNS].itertuples(index=False, name=None):
        by_cell[tuple(labels)] = (*by_cell.get(tuple(labels), ()), Note(Kind(kind), text))
    column = [by_cell.get(one, ()) for one in cells[list(key)].itertuples(index=False, name=None)]
    return cells.assign(notes=pd.Series(column, index=cells.index, dtype=object))
