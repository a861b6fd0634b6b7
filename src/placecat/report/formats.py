"""Write filled tables as Markdown and LaTeX, with the published numbers below the measured ones."""

from collections.abc import Callable, Mapping
from functools import cache
from typing import Any

import pandas as pd
from jinja2 import Environment

from placecat.report.grid import shown_table
from placecat.templates import environment

# Characters that would otherwise end a cell or start markup.
_MARKDOWN = str.maketrans({"\n": " ", **{character: f"\\{character}" for character in "\\|*`<[]$&"}})
_LATEX = str.maketrans(
    {
        "\n": " ",
        "\\": r"\textbackslash{}",
        **{character: f"\\{character}" for character in "&%$#_{}"},
        "~": r"\textasciitilde{}",
        "^": r"\textasciicircum{}",
        # A bracket that follows the end of a row would start an optional argument.
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
)


def markdown(text: str) -> str:
    """Escape text so that Markdown renders it literally."""
    return text.translate(_MARKDOWN)


def latex(text: str) -> str:
    """Escape text so that LaTeX prints it literally."""
    return text.translate(_LATEX)


def table_markdown(settings: Mapping[str, Any], table: pd.DataFrame, dataset: Mapping[str, Any]) -> str:
    """Format one filled table as Markdown.

    For the parameters, see :func:`placecat.report.grid.shown_table`.
    """
    return _in_markdown().get_template("table.md.j2").render(**shown_table(settings, table, dataset))


def table_latex(settings: Mapping[str, Any], table: pd.DataFrame, dataset: Mapping[str, Any]) -> str:
    """Format one filled table as a LaTeX ``table`` environment, which needs ``\\usepackage{booktabs}``.

    Published numbers appear in italics below each row of measured numbers, as standard errors do below
    coefficients. Footnotes explain why cells are empty. For the parameters, see
    :func:`placecat.report.grid.shown_table`.
    """
    return _in_latex().get_template("table.tex.j2").render(**shown_table(settings, table, dataset))


# Cached because a new environment would have to recompile its templates.
@cache
def _in_markdown() -> Environment:
    return environment("placecat.report").overlay(finalize=_only_text(markdown))


@cache
def _in_latex() -> Environment:
    """Return a template environment whose delimiters do not clash with LaTeX's braces."""
    return environment("placecat.report").overlay(
        variable_start_string="<<",
        variable_end_string=">>",
        comment_start_string="<#",
        comment_end_string="#>",
        finalize=_only_text(latex),
    )


def _only_text(escape: Callable[[str], str]) -> Callable[[Any], Any]:
    return lambda value: escape(value) if isinstance(value, str) else value
