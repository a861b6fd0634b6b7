"""Numbers of cells: ``table_26.9.3`` is the third column of the ninth row, ``in_text.5`` the fifth number."""

from collections.abc import Iterable, Mapping, Sequence

import pandas as pd

from placecat.thesis.number import AVERAGE

Key = tuple[str, str, str]


def ordered(names: Iterable[str]) -> Sequence[str]:
    """Names without duplicates, the average last; cells that only this run has follow the published ones."""
    found = list(dict.fromkeys(names))
    return [name for name in found if name != AVERAGE] + [name for name in found if name == AVERAGE]


def layout(table: pd.DataFrame) -> tuple[dict[str, Sequence[str]], Sequence[str]]:
    """Rows of each group of a filled table, and its columns, in the order in which the page shows them."""
    rows = {str(group): ordered(part["row"]) for group, part in table.groupby("group", sort=False)}
    return rows, ordered(table["column"])


def numbers(table: pd.DataFrame, name: str) -> Mapping[Key, str]:
    """Number of each cell by its group, row and column; rows are counted through all groups."""
    groups, columns = layout(table)
    lines = [(group, row) for group, rows in groups.items() for row in rows]
    return {
        (*line, column): f"{name}.{r}.{c}"
        for r, line in enumerate(lines, start=1)
        for c, column in enumerate(columns, start=1)
    }
