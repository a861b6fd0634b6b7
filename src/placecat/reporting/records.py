"""Numbers read off tables of records: speeds that git keeps, facts that stages left beside their results."""

from collections.abc import Mapping
from typing import Any

import numpy as np
import pandas as pd

from placecat import settings
from placecat.errors import PlacecatError
from placecat.reporting.comparison import Line
from placecat.reporting.number import Number, nothing

PICKS = {"lowest": np.min, "highest": np.max}
_VALUE = ["quantity", "column", "where", "pick", "digits"]


def read_off(entry: Mapping[str, Any], records: Mapping[str, pd.DataFrame], where: str) -> list[Line]:
    """Read the numbers of one entry off a table.

    Parameters
    ----------
    entry
        ``record``, the name of the table, and ``values``, each with ``quantity`` (what to call it),
        ``column`` and ``where``, the values that columns of its row have; with several rows ``pick``,
        "lowest" or "highest"; ``digits`` after the point, 2 by default.
    records
        Tables by name; one without rows was not recorded.
    where
        What messages call the entry.

    Raises
    ------
    PlacecatError
        An unknown setting, table or column, or several rows without ``pick``.
    """
    settings.refuse_unknown(entry, ["record", "values"], where)
    if entry["record"] not in records:
        raise PlacecatError(
            f"{where}: there is no record {entry['record']!r} (there are: {', '.join(records)})"
        )
    table = records[entry["record"]]
    return [Line(one["quantity"], "", _value(one, table, where)) for one in entry["values"]]


def _value(one: Mapping[str, Any], table: pd.DataFrame, where: str) -> Number:
    settings.refuse_unknown(one, _VALUE, f"{where}.values")
    pick, digits = one.get("pick"), int(one.get("digits", 2))
    if pick is not None and pick not in PICKS:
        raise PlacecatError(f"{where}.values.pick {pick!r} does not exist: use one of {', '.join(PICKS)}")
    if table.empty:
        return nothing("not recorded")
    found = table
    for column, value in {**one.get("where", {}), one["column"]: None}.items():
        if column not in table:
            raise PlacecatError(
                f"{where}: the record has no column {column!r} (it has: {', '.join(map(str, table))})"
            )
        found = found if value is None else found[found[column] == value]
    values = found[one["column"]].dropna().to_numpy(float)
    if not len(values):
        return nothing("not recorded")
    if pick is None and len(values) > 1:
        raise PlacecatError(f"{where}: the record has {len(values)} rows for {one['quantity']!r}: add pick")
    return Number(np.array([values[0] if pick is None else PICKS[pick](values)]), False, digits=digits)
