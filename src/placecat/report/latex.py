"""A table as LaTeX for the package booktabs: each measured row, the published one below it in italics."""

from collections.abc import Mapping
from typing import Any

import pandas as pd
from jinja2 import Environment

from placecat.report.grid import homes_sentence, make_grid, seeds_sentence
from placecat.templates import environment
from placecat.thesis.tables import comparable, in_percent

_SPECIAL = {
    "\\": r"\textbackslash{}",
    "&": r"\&",
    "%": r"\%",
    "$": r"\$",
    "#": r"\#",
    "_": r"\_",
    "{": r"\{",
    "}": r"\}",
    "~": r"\textasciitilde{}",
    "^": r"\textasciicircum{}",
    # After the end of a row it would begin an optional argument.
    "[": "{[}",
    "<": r"\textless{}",
    ">": r"\textgreater{}",
    "|": r"\textbar{}",
    '"': r"\textquotedbl{}",
    "–": "--",
    "−": "$-$",
    "×": r"$\times$",
    "γ": r"$\gamma$",
    "ν": r"$\nu$",
}


def latex_text(text: str) -> str:
    r"""Escape a text for LaTeX, e.g. ``a_b & 5 %`` is ``a\_b \& 5 \%``."""
    return "".join(_SPECIAL.get(character, character) for character in text.replace("\n", " "))


def table_latex(settings: Mapping[str, Any], table: pd.DataFrame, dataset: Mapping[str, Any]) -> str:
    """Write one filled table as a LaTeX ``table`` environment.

    The document needs ``\\usepackage{booktabs}``. Under each row of measured numbers stand the published
    ones in italics, as standard errors stand under coefficients; footnotes give the reasons of empty cells.

    Parameters
    ----------
    settings
        The table's configuration (``name``; ``number``, None for what is no table of the thesis; ``title``,
        ``thesis_data``; ``caption``, if the numbers are no percentages).
    table
        From :func:`placecat.thesis.tables.fill_table`.
    dataset
        Its ``title``, ``homes`` and ``thesis_data``.
    """
    return (
        _environment()
        .get_template("table.tex.j2")
        .render(
            number=settings["number"],
            title=settings["title"],
            thesis_data=settings["thesis_data"],
            comparable=comparable(settings, dataset),
            data=dataset["title"],
            caption=settings.get("caption", ""),
            homes=homes_sentence(table, dataset["homes"]),
            label=str(settings["name"]).replace("_", "-"),
            grid=make_grid(table),
            seeds=seeds_sentence(table) if in_percent(settings) else "",
        )
    )


def _environment() -> Environment:
    """The shared templates, with delimiters that do not clash with LaTeX's braces; all text is escaped."""
    return environment("placecat.report").overlay(
        variable_start_string="<<",
        variable_end_string=">>",
        comment_start_string="<#",
        comment_end_string="#>",
        finalize=lambda value: latex_text(value) if isinstance(value, str) else value,
    )
