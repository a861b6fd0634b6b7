"""Notes on a table's numbers, by subject."""

from collections.abc import Iterable
from enum import StrEnum
from typing import NamedTuple

import pandas as pd

from placecat.evaluation.trials import AXES

COLUMNS = ["table", "group", "row", "column", "kind", "text"]


class Kind(StrEnum):
    """A note's subject."""

    # The data set behind the measured numbers; applies to the whole table.
    DATA = "data"
    # The published numbers come from other data; applies to the whole table.
    NOT_COMPARABLE = "not_comparable"
    # The published cell is "n/a".
    NOT_AVAILABLE = "not_available"
    # This cell's published number, for example if it contradicts other numbers in the thesis.
    PUBLISHED = "published"
    # This cell's measured number, or the reason why it is missing.
    MEASURED = "measured"


class Note(NamedTuple):
    """A note on a number, with its subject."""

    kind: Kind
    text: str

    @property
    def is_of_the_table(self) -> bool:
        """Whether the note applies to the whole table and belongs in the caption."""
        return self.kind in (Kind.DATA, Kind.NOT_COMPARABLE)

    @property
    def is_about_the_published(self) -> bool:
        """Whether the note is about the thesis's number."""
        return self.kind in (Kind.NOT_COMPARABLE, Kind.NOT_AVAILABLE, Kind.PUBLISHED)


Notes = tuple[Note, ...]


def joined(notes: Iterable[Note]) -> str:
    """Join notes into one string, without duplicates."""
    return "; ".join(dict.fromkeys(note.text for note in notes))


def without_empty(notes: Iterable[Note]) -> Notes:
    """Remove empty notes and duplicates."""
    return tuple(dict.fromkeys(note for note in notes if note.text))


def to_rows(name: str, cells: pd.DataFrame, key: Iterable[str] = AXES) -> pd.DataFrame:
    """Convert a table's `notes` column to rows with the columns `COLUMNS`, which can be stored as CSV.

    The three columns in `key` identify each row's cell.
    """
    rows = [
        (name, *labels, note.kind.value, note.text)
        for *labels, notes in cells[[*key, "notes"]].itertuples(index=False, name=None)
        for note in notes
    ]
    return pd.DataFrame(rows, columns=COLUMNS)


def with_notes(name: str, cells: pd.DataFrame, rows: pd.DataFrame, key: Iterable[str] = AXES) -> pd.DataFrame:
    """Restore a table's `notes` column from the rows of :func:`to_rows`, which may cover several tables."""
    by_cell: dict[tuple[str, ...], Notes] = {}
    for _, *labels, kind, text in rows[rows["table"] == name][COLUMNS].itertuples(index=False, name=None):
        by_cell[tuple(labels)] = (*by_cell.get(tuple(labels), ()), Note(Kind(kind), text))
    column = [by_cell.get(one, ()) for one in cells[list(key)].itertuples(index=False, name=None)]
    return cells.assign(notes=pd.Series(column, index=cells.index, dtype=object))
