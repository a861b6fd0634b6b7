"""Layouts of tables, one a module: which measured number belongs to which cell. Found by module name."""

from collections.abc import Mapping
from typing import Any, NamedTuple

from placecat import lookup
from placecat.results.measured import Results
from placecat.thesis.number import Number


class Cell(NamedTuple):
    """One cell of a table: its key in the published tables, and what was measured for it.

    `measured` is a percentage, the mean over the seeds, or NaN with `notes` that say why there is none.
    `spread` is the largest minus the smallest of the seeds, NaN where nothing is random; `seeds` is their
    number, then 0.
    """

    group: str
    row: str
    column: str
    measured: float
    spread: float
    seeds: int
    notes: tuple[str, ...]


def cell(key: tuple[str, str, str], number: Number) -> Cell:
    """Put a number into the cell of a group, row and column."""
    return Cell(*key, number.measured, number.spread, number.seeds, number.notes)


def place_column(place: str) -> str:
    """Name of a place in the published tables, e.g. ``living_room`` is "Living Room"."""
    return place.replace("_", " ").title()


def names() -> list[str]:
    """Names of the layouts."""
    return lookup.names(__name__, "cells")


def cells(table: Mapping[str, Any], results: Results) -> list[Cell]:
    """Fill the cells of one table by its ``layout``.

    Raises
    ------
    PlacecatError
        An unknown layout, or a result that the run does not have.
    """
    layout = lookup.module(__name__, table["layout"], f"{table['name']}: the layout", "cells")
    filled: list[Cell] = layout.cells(table, results)
    return filled
