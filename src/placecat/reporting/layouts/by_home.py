"""A row a result, a column a test home, and the average over homes (e.g. Table 26)."""

from collections.abc import Mapping
from typing import Any

import numpy as np

from placecat.reporting.layouts import Cell, home_column
from placecat.reporting.results import Results


def cells(table: Mapping[str, Any], results: Results) -> list[Cell]:
    """Cells of every row in ``table["rows"]``, each with `group`, `row` and `result`."""
    filled = []
    for row in table["rows"]:
        accuracies = results.by_home(row["result"])
        for number, value in enumerate(accuracies):
            filled.append(Cell(row["group"], row["row"], home_column(number), float(value), ""))
        filled.append(Cell(row["group"], row["row"], "Average", float(np.mean(accuracies)), ""))
    return filled
