"""The origins of each table cell, written by the `tables` stage and read by the explanations."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any

import pandas as pd

from placecat.evaluation.trials import AXES
from placecat.paths import NO_SEED
from placecat.results.measured import Results
from placecat.thesis.number import Number, Origin


@dataclass(frozen=True)
class Measurement:
    """The number in a cell for each seed, and its origins.

    Attributes
    ----------
    values
        The unrounded values, as in :class:`placecat.thesis.number.Number`; () if the cell has no number.
    seeds
        Name of the seed behind each value, such as "seed-0", or "no-seed".
    origins
        The origins of the number.
    """

    values: tuple[float, ...]
    seeds: tuple[str, ...]
    origins: tuple[Origin, ...]


def measurement(number: Number, results: Results) -> Measurement:
    """Add seed names to a number; they come from the results behind it."""
    values = tuple(map(float, number.values))
    fixed = (NO_SEED,) * len(values)
    if not number.is_random:
        return Measurement(values, fixed, number.origins)
    measured = (results.measured.get(origin.result) for origin in number.origins)
    seeds = (one.seeds for one in measured if one is not None and len(one.seeds) == len(values))
    return Measurement(values, next(seeds, fixed), number.origins)


def to_json(cells: pd.DataFrame, results: Results, key: Iterable[str] = AXES) -> list[dict[str, Any]]:
    """Convert the column `number` of a filled table to JSON types.

    The three columns in `key` identify each cell.
    """
    rows = []
    for *labels, number in cells[[*key, "number"]].itertuples(index=False, name=None):
        one = measurement(number, results)
        rows.append({"cell": labels, "values": one.values, "seeds": one.seeds, "origins": one.origins})
    return rows


def from_json(rows: Iterable[Mapping[str, Any]]) -> dict[tuple[str, str, str], Measurement]:
    """Map the labels of each cell to its measurement, from the rows of :func:`to_json`."""
    found = {}
    for row in rows:
        origins = tuple(Origin(result, tuple(homes), part) for result, homes, part in row["origins"])
        group, label, column = row["cell"]
        found[group, label, column] = Measurement(tuple(row["values"]), tuple(row["seeds"]), origins)
    return found
