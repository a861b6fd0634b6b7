"""The report: one self-contained HTML page with every table."""

from collections.abc import Mapping, Sequence
from typing import Any

import pandas as pd

from placecat.reporting.markdown import grids
from placecat.reporting.render import environment
from placecat.reporting.tables import comparable


def page_html(
    tables: Sequence[tuple[Mapping[str, Any], pd.DataFrame]],
    dataset: Mapping[str, Any],
    frames: Mapping[str, Mapping[str, int]],
) -> str:
    """Render the page.

    Parameters
    ----------
    tables
        Each table's configuration and its filled form.
    dataset
        Its ``title``, ``homes``, ``classes`` and ``thesis_data``.
    frames
        For each home the number of frames of each place, and ``unlabelled``.
    """
    shown = [
        {
            "number": settings["number"],
            "title": settings["title"],
            "thesis_data": settings["thesis_data"],
            "comparable": comparable(settings, dataset),
            "measured": grids(table, "measured"),
            "published": grids(table[table["published"].notna()], "published"),
            "reasons": sorted(set(table.loc[table["measured"].isna(), "note"])),
        }
        for settings, table in sorted(tables, key=lambda pair: pair[0]["number"])
    ]
    return environment().get_template("page.html.j2").render(tables=shown, dataset=dataset, frames=frames)
