"""A row a test home, a column a place, and the averages over places and homes (e.g. Table 6)."""

from collections.abc import Mapping
from typing import Any

import numpy as np

from placecat.results.measured import Results
from placecat.thesis.layouts import Cell, cell, place_column
from placecat.thesis.number import AVERAGE, Number, home_label, in_home, in_homes, mean, nothing


def cells(table: Mapping[str, Any], results: Results) -> list[Cell]:
    """Cells of the one result in ``table["result"]``.

    An average over homes is one over the homes that show the place; that of the averages is the mean over
    homes, as everywhere.
    """
    name = table["result"]
    numbers = range(1, len(results.homes) + 1)
    of_place = {
        place: [_in_place(results, name, number, place) for number in numbers] for place in results.classes
    }
    rows = dict(in_homes(results, name, numbers))
    filled = []
    for number in numbers:
        row = home_label(number)
        filled += [
            cell(("", row, place_column(place)), found[number - 1]) for place, found in of_place.items()
        ]
        filled.append(cell(("", row, AVERAGE), rows[row]))
    for place, found in of_place.items():
        filled.append(cell(("", AVERAGE, place_column(place)), mean(found)))
    # With one home it is its own average.
    filled.append(cell(("", AVERAGE, AVERAGE), rows.get(AVERAGE, rows[home_label(1)])))
    return filled


def _in_place(results: Results, name: str, number: int, place: str) -> Number:
    """Percentage of one home's frames of a place that were decided to be it."""
    whole = in_home(results, name, number)
    if not len(whole.values):
        return whole
    one, home = results.of(name), results.homes[number - 1]
    values = one.by_class()[:, one.homes.index(home), one.classes.index(place)]
    return (
        Number(values, one.is_random)
        if np.isfinite(values).all()
        else nothing(f"{home} has no frame of {place}")
    )
