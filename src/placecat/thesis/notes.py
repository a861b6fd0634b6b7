"""What is to be said of a number in a table, by what it is about."""

from collections.abc import Iterable
from enum import StrEnum
from typing import NamedTuple

import pandas as pd

COLUMNS = ["table", "group", "row", "column", "kind", "text"]
_KEY = ["group", "row", "column"]


class Kind(StrEnum):
    """What a note is about."""

    # The data set that the number was measured on; it holds for a whole table.
    DATA = "data"
    # The published number is from other data; it holds for a whole table.
    NOT_COMPARABLE = "not_comparable"
    # The published cell is an n/a.
    NOT_AVAILABLE = "not_available"
    # The published number of this cell, e.g. one that contradicts the thesis's other numbers.
    PUBLISHED = "published"
    # The measured number of this cell, or why there is none.
    MEASURED = "measured"


class Note(NamedTuple):
    """One note."""

    kind: Kind
    text: str

    @property
    def is_of_the_table(self) -> bool:
        """Whether it holds for a whole table, whose caption says it."""
        return self.kind in (Kind.DATA, Kind.NOT_COMPARABLE)

    @property
    def is_about_the_published(self) -> bool:
        """Whether it is about what the thesis has."""
        return self.kind in (Kind.NOT_COMPARABLE, Kind.NOT_AVAILABLE, Kind.PUBLISHED)


Notes = tuple[Note, ...]


def joined(notes: Iterable[Note]) -> str:
    """Notes as one text for people, each text once."""
    return "; ".join(dict.fromkeys(note.text for note in notes))


def without_empty(notes: Iterable[Note]) -> Notes:
    """Notes that say something, each once."""
    return tuple(dict.fromkeys(note for note in notes if note.text))


def to_rows(name: str, cells: pd.DataFrame, key: Iterable[str] = _KEY) -> pd.DataFrame:
    """Column `notes` of a table as rows (`COLUMNS`), since a cell of a CSV cannot hold them.

    The three columns `key` say which cell a row is.
    """
    rows = [
        (name, *labels, note.kind.value, note.text)
        for *labels, notes in cells[[*key, "notes"]].itertuples(index=False, name=None)
        for note in notes
    ]
    return pd.DataFrame(rows, columns=COLUMNS)


def with_notes(name: str, cells: pd.DataFrame, rows: pd.DataFrame, key: Iterable[str] = _KEY) -> pd.DataFrame:
    """A table with its column `notes` again, from what :func:`to_rows` gave; `rows` may be of many tables."""
    by_cell: dict[tuple[str, ...], Notes] = {}
    for _, *labels, kind, text in rows[rows["table"] == name][COLUMNS].itertuples(index=False, name=None):
        by_cell[tuple(labels)] = (*by_cell.get(tuple(labels), ()), Note(Kind(kind), text))
    column = [by_cell.get(one, ()) for one in cells[list(key)].itertuples(index=False, name=None)]
    return cells.assign(notes=pd.Series(column, index=cells.index, dtype=object))
