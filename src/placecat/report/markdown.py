"""A table as Markdown, in the thesis's form: what was measured first, the published numbers below."""

from collections.abc import Mapping
from typing import Any

import pandas as pd

from placecat.report.grid import homes_sentence, make_grid, seeds_sentence
from placecat.templates import environment
from placecat.thesis.tables import comparable, in_percent

# Characters that would end a cell or begin markup.
_SPECIAL = str.maketrans({character: f"\\{character}" for character in "\\|*`<"})


def markdown_text(text: str) -> str:
    """Escape a text for a cell of a Markdown table."""
    return text.translate(_SPECIAL).replace("\n", " ")


def table_markdown(settings: Mapping[str, Any], table: pd.DataFrame, dataset: Mapping[str, Any]) -> str:
    """Write one filled table as Markdown.

    Parameters
    ----------
    settings
        The table's configuration (``number``, None for what is no table of the thesis; ``title``,
        ``thesis_data``; ``caption``, if the numbers are no percentages).
    table
        From :func:`placecat.thesis.tables.fill_table`.
    dataset
        Its ``title``, ``homes`` and ``thesis_data``.
    """
    template = environment("placecat.report").overlay(finalize=_escaped).get_template("table.md.j2")
    return template.render(
        number=settings["number"],
        title=settings["title"],
        thesis_data=settings["thesis_data"],
        comparable=comparable(settings, dataset),
        data=dataset["title"],
        caption=settings.get("caption", ""),
        homes=homes_sentence(table, dataset["homes"]),
        grid=make_grid(table),
        seeds=seeds_sentence(table) if in_percent(settings) else "",
    )


def _escaped(value: Any) -> Any:
    return markdown_text(value) if isinstance(value, str) else value
