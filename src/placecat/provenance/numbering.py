"""Cell numbers: ``table_26.9.3`` is in row 9, column 3; ``in_text.5`` is the fifth number in the text."""

from collections.abc import Iterable, Mapping, Sequence

import pandas as pd

from placecat.thesis import in_text
from placecat.thesis.number import AVERAGE

Key = tuple[str, str, str]


def ordered(names: Iterable[str]) -> Sequence[str]:
    """Remove duplicate names and move the average to the end; otherwise keep the order."""
    return sorted(dict.fromkeys(names), key=lambda name: name == AVERAGE)


def layout(table: pd.DataFrame) -> tuple[dict[str, Sequence[str]], Sequence[str]]:
    """Return the rows by group and the columns of a filled table, in the order shown on the page."""
    rows = {str(group): ordered(part["row"]) for group, part in table.groupby("group", sort=False)}
    return rows, ordered(table["column"])


def numbers(table: pd.DataFrame, name: str) -> Mapping[Key, str]:
    """Map the labels of each cell to its number; rows are counted across groups."""
    if name == in_text.NAME:
        keys = table[in_text.KEY].itertuples(index=False, name=None)
        return {key: f"{name}.{position}" for position, key in enumerate(keys, start=1)}
    groups, columns = layout(table)
    lines = [(group, row) for group, rows in groups.items() for row in rows]
    return {
        (*line, column): f"{name}.{r}.{c}"
        for r, line in enumerate(lines, start=1)
        for c, column in enumerate(columns, start=1)
    }
