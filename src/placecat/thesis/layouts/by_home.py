"""A row a result, a column a test home, and the average over homes (e.g. Table 26)."""

from collections.abc import Mapping
from typing import Any

from placecat.results.measured import Results
from placecat.thesis.layouts import Cell, cell
from placecat.thesis.number import AVERAGE, home_label, in_homes


def cells(table: Mapping[str, Any], results: Results) -> list[Cell]:
    """Cells of every row in ``table["rows"]``, each with `group`, `row` and `result`.

    The note of a filtered result says what the information filter drops.
    """
    numbers = range(1, len(results.homes) + 1)
    homes = {home_label(number): home for number, home in enumerate(results.homes, start=1)} | {AVERAGE: ""}
    return [
        cell((row["group"], row["row"], column), number.noted(results.drops(row["result"], homes[column])))
        for row in table["rows"]
        for column, number in in_homes(results, row["result"], numbers)
    ]
