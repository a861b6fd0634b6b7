"""Data for a table's bar chart: one bar per result, with its homes or places as points."""

from dataclasses import dataclass

import numpy as np
import pandas as pd

from placecat.thesis.number import AVERAGE

_HOME = r"Home \d+"


@dataclass(frozen=True)
class Bar:
    """One bar: the name of its group ("" for none), its name, and numbers in percent.

    `published` is NaN if missing; `points` are the table's numbers that `measured` averages.
    """

    section: str
    label: str
    measured: float
    published: float
    points: tuple[float, ...]


def bars_of(cells: pd.DataFrame) -> list[Bar]:
    """Turn a filled table's averages over homes, or else over places, or else all its cells, into bars.

    Bars are in the table's order; cells that were not measured have no bar.
    """
    axis = _averaged(cells)
    if axis is None:
        named = cells.assign(
            section=[
                ", ".join(filter(None, names)) for names in zip(cells["group"], cells["row"], strict=True)
            ],
            label=cells["column"],
        )
    else:
        named = cells.assign(section=cells["group"], label=cells["column" if axis == "row" else "row"])
    bars = []
    for (section, label), part in named.groupby(["section", "label"], sort=False):
        whole = part if axis is None else part[part[axis] == AVERAGE]
        # A single home has no average.
        whole = part if whole.empty else whole
        if len(whole) != 1 or not np.isfinite(whole["measured"].iloc[0]):
            continue
        points = part.drop(whole.index)["measured"].dropna()
        measured, published = (float(whole[column].iloc[0]) for column in ("measured", "published"))
        bars.append(Bar(str(section), str(label), measured, published, tuple(points)))
    return bars


def point_name(cells: pd.DataFrame) -> str:
    """Whether a point of `bars_of` is a "home" or a "place"."""
    axis = _averaged(cells)
    return "home" if axis is not None and cells[axis].str.fullmatch(_HOME).any() else "place"


def _averaged(cells: pd.DataFrame) -> str | None:
    """Return the label column that a table averages over, or None."""
    for axis in ("row", "column"):
        if cells[axis].str.fullmatch(_HOME).any():
            return axis
    return "column" if (cells["column"] == AVERAGE).any() else None
