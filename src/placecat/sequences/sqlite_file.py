"""Read untrusted SQLite files in read-only mode, and check their tables and the types of their values."""

import sqlite3
from collections.abc import Iterator, Mapping
from contextlib import closing, contextmanager
from pathlib import Path
from types import UnionType
from typing import Any

from placecat.errors import PlacecatError
from placecat.sequences.labels import shown

Columns = Mapping[str, type | UnionType]
"""Maps each column name to the type of its values: int or str, possibly with None."""
MOST_BYTES = 1 << 20
"""Largest row accepted, far larger than any path or name. Our choice."""


class SqliteFile:
    """An open database; see :func:`opened`."""

    def __init__(self, path: Path, connection: sqlite3.Connection, tables: Mapping[str, Columns]) -> None:
        self._path, self._connection, self._tables = path, connection, tables

    def rows(self, table: str, **equal: int) -> Iterator[tuple[Any, ...]]:
        """Yield the expected columns of the rows that match `equal`. Raise an error if a type is wrong."""
        columns = self._tables[table]
        condition = " AND ".join(f"{name} = ?" for name in equal) or "TRUE"
        query = f"SELECT {', '.join(columns)} FROM {table} WHERE {condition}"
        for row in self._connection.execute(query, tuple(equal.values())):
            for (column, kind), value in zip(columns.items(), row, strict=True):
                if not isinstance(value, kind):
                    raise PlacecatError(
                        f"{self._path}: the table {table} has {shown(str(value))} in column {column}, which "
                        "is invalid; restore the file."
                    )
            yield row


@contextmanager
def opened(path: Path, tables: Mapping[str, Columns]) -> Iterator[SqliteFile]:
    """Open a database to read the columns in `tables`, without writing any files.

    Raises PlacecatError if the file is missing, damaged or not a database, if a program is writing to it, or
    if it lacks a table or a column.
    """
    if not path.is_file():
        raise PlacecatError(f"{path}: the database is missing; restore it, or correct dataset.root.")
    for ending in ("-journal", "-wal"):
        if Path(f"{path}{ending}").exists():
            raise PlacecatError(
                f"{path}: a program is writing to it, or was stopped while writing ({path.name}{ending}); "
                "close the program, or restore the file."
            )
    try:
        # Without `immutable`, SQLite may write files next to a database that it only reads.
        address = f"{path.absolute().as_uri()}?mode=ro&immutable=1"
        with closing(sqlite3.connect(address, uri=True)) as connection:
            connection.setlimit(sqlite3.SQLITE_LIMIT_LENGTH, MOST_BYTES)
            connection.execute("PRAGMA trusted_schema = OFF")
            _check(path, connection, tables)
            yield SqliteFile(path, connection, tables)
    except sqlite3.Error as error:
        raise PlacecatError(f"{path}: cannot be read as an SQLite database ({error}); restore it.") from None


def _check(path: Path, connection: sqlite3.Connection, tables: Mapping[str, Columns]) -> None:
    # Ignore views, because a malicious view may run forever.
    there = {name for (name,) in connection.execute("SELECT name FROM sqlite_master WHERE type = 'table'")}
    for table, columns in tables.items():
        if table not in there:
            raise PlacecatError(f"{path}: the table {table} is missing; restore the file.")
        known = {row[1] for row in connection.execute(f"PRAGMA table_info({table})")}
        for column in columns:
            if column not in known:
                raise PlacecatError(f"{path}: the table {table} has no column {column}; restore the file.")
