"""A row a result, a column a test home, and the average over homes (e.g. Table 26)."""

from collections.abc import Mapping
from typing import Any

from placecat.reporting.layouts import Cell, cell
from placecat.reporting.number import in_homes
from placecat.reporting.results import Results


def cells(table: Mapping[str, Any], results: Results) -> list[Cell]:
    """Cells of every row in ``table["rows"]``, each with `group`, `row` and `result`."""
    numbers = range(1, len(results.homes) + 1)
    return [
        cell((row["group"], row["row"], column), number)
        for row in table["rows"]
        for column, number in in_homes(results, row["result"], numbers)
    ]
