"""A row a test home, a column a place, and the averages over places and homes (e.g. Table 6)."""

from collections.abc import Mapping
from typing import Any

import numpy as np

from placecat.reporting.layouts import Cell, home_column
from placecat.reporting.results import Results


def place_column(place: str) -> str:
    """Name of a place in the published tables, e.g. ``living_room`` is "Living Room"."""
    return place.replace("_", " ").title()


def cells(table: Mapping[str, Any], results: Results) -> list[Cell]:
    """Cells of the one result in ``table["result"]``."""
    percent = results.by_class(table["result"])
    of_home = results.by_home(table["result"])
    filled = []
    for number, home in enumerate(results.homes):
        for place, value in zip(results.classes, percent[number], strict=True):
            note = "" if np.isfinite(value) else f"{home} has no frame of {place}"
            filled.append(Cell("", home_column(number), place_column(place), float(value), note))
        filled.append(Cell("", home_column(number), "Average", float(of_home[number]), ""))
    for number, place in enumerate(results.classes):
        present = percent[np.isfinite(percent[:, number]), number]
        value = float(present.mean()) if len(present) else float("nan")
        note = "" if len(present) else f"no home has a frame of {place}"
        filled.append(Cell("", "Average", place_column(place), value, note))
    filled.append(Cell("", "Average", "Average", float(np.mean(of_home)), ""))
    return filled
