"""As `by_home`, and what some results have more than the best of others, in points."""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from placecat.results.measured import Results
from placecat.thesis.layouts import Cell, by_home, cell
from placecat.thesis.number import in_homes, over_homes


def cells(table: Mapping[str, Any], results: Results) -> list[Cell]:
    """Cells of every row in ``table["rows"]`` (see `by_home`) and in ``table["gains"]``.

    Groups are in the order of the rows; in a group gains come last. A gain has `group`, `row`, `result` and
    `over`, a list of results. It is the difference to that one of them whose average over homes is the
    largest, the same in every home; its note says which.
    """
    names = {row["result"]: row["row"] for row in table["rows"]}
    numbers = range(1, len(results.homes) + 1)
    filled = by_home.cells(table, results)
    for gain in table["gains"]:
        best = _best(results, gain["over"], numbers)
        note = f"minus {names.get(best, best)}"
        if len(gain["over"]) > 1:
            note += ", the best on average"
        pairs = zip(in_homes(results, gain["result"], numbers), in_homes(results, best, numbers), strict=True)
        for (column, of_result), (_, of_best) in pairs:
            found = of_result.minus(of_best).noted(note)
            filled.append(cell((gain["group"], gain["row"], column), found))
    groups = list(dict.fromkeys(one.group for one in filled))
    return sorted(filled, key=lambda one: groups.index(one.group))


def _best(results: Results, names: Sequence[str], numbers: Sequence[int]) -> str:
    """The result with the largest average; the first one of equals, and if none was measured."""
    averages = [over_homes(results, name, numbers).measured for name in names]
    return names[int(np.nanargmax(averages))] if np.isfinite(averages).any() else names[0]
