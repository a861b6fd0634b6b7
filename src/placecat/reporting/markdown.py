"""A table as Markdown, in the thesis's form: what was measured first, the published numbers below."""

from collections.abc import Mapping
from typing import Any

import pandas as pd

from placecat.reporting.render import environment
from placecat.reporting.tables import comparable


def grids(table: pd.DataFrame, value: str) -> list[dict[str, Any]]:
    """Turn the long form of a table into one grid a group.

    Parameters
    ----------
    table
        Columns group, row, column and `value`.
    value
        "published" or "measured".

    Returns
    -------
    list of dict
        ``group``, ``columns`` (names) and ``rows`` (name and cells as text, "" for none), in table order.
    """
    found = []
    for group, part in table.groupby("group", sort=False):
        columns = list(dict.fromkeys(part["column"]))
        cells = {
            (row, column): number
            for row, column, number in part[["row", "column", value]].itertuples(index=False)
        }
        rows = [
            {"name": row, "cells": [_text(cells.get((row, column))) for column in columns]}
            for row in dict.fromkeys(part["row"])
        ]
        found.append({"group": group, "columns": columns, "rows": rows})
    return found


def _text(value: float | None) -> str:
    return "" if value is None or pd.isna(value) else f"{value:.2f}"


def table_markdown(settings: Mapping[str, Any], table: pd.DataFrame, dataset: Mapping[str, Any]) -> str:
    """Write one filled table as Markdown.

    Parameters
    ----------
    settings
        The table's configuration (``number``, ``title``).
    table
        From :func:`placecat.reporting.tables.fill_table`.
    dataset
        Its ``title``, ``homes`` and ``thesis_data``.
    """
    return (
        environment()
        .get_template("table.md.j2")
        .render(
            number=settings["number"],
            title=settings["title"],
            thesis_data=settings["thesis_data"],
            comparable=comparable(settings, dataset),
            dataset=dataset,
            measured=grids(table, "measured"),
            published=grids(table[table["published"].notna()], "published"),
            reasons=sorted(set(table.loc[table["measured"].isna(), "note"])),
        )
    )
