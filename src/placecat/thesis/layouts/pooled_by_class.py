"""A row a result, a column a place, frames of all test sequences counted together (Tables 30 and 31)."""

from collections.abc import Mapping
from typing import Any

import numpy as np

from placecat.results.measured import Results
from placecat.thesis.layouts import Cell, cell, place_column
from placecat.thesis.number import AVERAGE, Number, nothing


def cells(table: Mapping[str, Any], results: Results) -> list[Cell]:
    """Cells of every row in ``table["rows"]``, each with `group`, `row` and `result`.

    ``table["plain"]``, if it is there, names a column with the share of all frames, whatever their place.
    """
    filled = []
    for row in table["rows"]:
        for column, number in _by_class(results, row["result"], str(table.get("plain", ""))):
            filled.append(cell((row["group"], row["row"], column), number))
    return filled


def _by_class(results: Results, name: str, plain: str) -> list[tuple[str, Number]]:
    one = results.of(name).pooled()
    found = []
    for place, values in zip(one.classes, one.by_class()[:, 0].T, strict=True):
        number = (
            Number(values, one.is_random)
            if np.isfinite(values).all()
            else nothing(f"no test sequence shows the place {place}")
        )
        found.append((place_column(place), number))
    if plain:
        found.append((plain, Number(one.plain()[:, 0], one.is_random)))
    return [*found, (AVERAGE, Number(one.by_home()[:, 0], one.is_random))]
