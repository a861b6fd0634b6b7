"""A row a result, a column a test home, and the average over homes (e.g. Table 26)."""

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from placecat.results.measured import Results
from placecat.thesis.layouts import Cell, cell
from placecat.thesis.number import AVERAGE, Number, home_label, in_homes, joined


def cells(table: Mapping[str, Any], results: Results) -> list[Cell]:
    """Cells of every row in ``table["rows"]``, each with `group`, `row` and `result`.

    The note of a filtered result says what the information filter drops.
    """
    numbers = range(1, len(results.homes) + 1)
    homes = {home_label(number): home for number, home in enumerate(results.homes, start=1)} | {AVERAGE: ""}
    return [
        cell((row["group"], row["row"], column), _noted(number, results.drops(row["result"], homes[column])))
        for row in table["rows"]
        for column, number in in_homes(results, row["result"], numbers)
    ]


def _noted(number: Number, note: str) -> Number:
    return replace(number, note=joined([number.note, note])) if len(number.values) else number
