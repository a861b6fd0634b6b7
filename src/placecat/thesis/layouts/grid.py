"""Any axes, of which one may be the test homes: cells that are trials of their own (e.g. Table 12)."""

import itertools
from collections.abc import Mapping
from typing import Any

from placecat.evaluation.trials import AXES, HOMES, trial_name
from placecat.results.measured import Results
from placecat.thesis.layouts import Cell, cell
from placecat.thesis.number import in_homes, over_homes


def cells(table: Mapping[str, Any], results: Results) -> list[Cell]:
    """Cells of the trials that ``table["axes"]`` spans, in the homes of ``table["homes"]``.

    Labels are those of the axes. If an axis is the homes, its labels are "Home n" and, of two or more homes,
    "Average"; otherwise every cell is the mean over the homes.
    """
    axes = [table["axes"].get(axis, {"": {}}) for axis in AXES]
    everywhere = range(1, len(results.homes) + 1)
    numbers = everywhere if table["homes"] == "all" else [int(number) for number in table["homes"]]
    groups, rows, columns = (("",) if axis == HOMES else tuple(axis) for axis in axes)
    filled = []
    for group, row, column in itertools.product(groups, rows, columns):
        name = trial_name(table["name"], group, row, column)
        if HOMES not in axes:
            filled.append(cell((group, row, column), over_homes(results, name, numbers)))
            continue
        # The label of the axis of homes is empty so far.
        for home, number in in_homes(results, name, numbers):
            labels = [
                home if axis == HOMES else label
                for axis, label in zip(axes, (group, row, column), strict=True)
            ]
            filled.append(cell((labels[0], labels[1], labels[2]), number))
    return filled
