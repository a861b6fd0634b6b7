"""Layouts of tables, one a module: which measured number belongs to which cell. Found by module name."""

import importlib
import pkgutil
from collections.abc import Mapping
from typing import Any, NamedTuple

from placecat.errors import PlacecatError
from placecat.reporting.results import Results


class Cell(NamedTuple):
    """One cell of a table: its key in the published tables, and what was measured for it.

    `measured` is a percentage, or NaN with a `note` that says why there is none.
    """

    group: str
    row: str
    column: str
    measured: float
    note: str


def names() -> list[str]:
    """Names of the layouts."""
    return sorted(module.name for module in pkgutil.iter_modules(__path__))


def cells(table: Mapping[str, Any], results: Results) -> list[Cell]:
    """Fill the cells of one table by its ``layout``."""
    name = str(table["layout"])
    if name not in names():
        raise PlacecatError(
            f"tables.table_{table['number']:02d}.layout {name!r} does not exist: "
            f"use one of {', '.join(names())}"
        )
    return importlib.import_module(f"{__name__}.{name}").cells(table, results)


def home_column(number: int) -> str:
    """Name of the n-th home (from 0) in the published tables."""
    return f"Home {number + 1}"
