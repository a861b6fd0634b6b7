"""Write a page that compares two runs: the tables, verdicts, figures and settings that differ."""

import re
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import pandas as pd
from jinja2 import ChoiceLoader, PackageLoader

from placecat import files
from placecat.compare import kept_in_git
from placecat.compare.differences import turned
from placecat.compare.kept_in_git import Figures, Kept
from placecat.errors import PlacecatError
from placecat.report.page import page_templates, shown_picture
from placecat.thesis.tables import label, tables_of

# Settings that do not affect results.
_NOT_SHOWN = ("compute", "reproducibility")


def write(target: Path, old: str, new: str, lines: Sequence[str]) -> list[str]:
    """Write the page to an HTML file; return lines that give its path and say why figures are missing.

    `old` and `new` are the sides (see :func:`placecat.compare.kept_in_git.read`). `lines` come from
    :func:`placecat.compare.kept_in_git.compare`.
    """
    files.check_file(target)
    drawn = [kept_in_git.read_figures(side) for side in (old, new)]
    kept = [kept_in_git.read(side) for side in (old, new)]
    names = [_name(side) for side in (old, new)]
    files.write_text(target, page_html(names, kept, drawn, lines))
    return [
        f"Side by side: {target}",
        *(f"Figures are not compared: {one.missing}." for one in drawn if one.missing),
    ]


def _name(side: str) -> dict[str, str]:
    about = "" if kept_in_git.is_folder(side) else kept_in_git.about(side)
    return {"name": kept_in_git.name_of(side), "about": about}


def page_html(
    names: Sequence[dict[str, str]], kept: Sequence[Kept], drawn: Sequence[Figures], lines: Sequence[str]
) -> str:
    """Render the page.

    `names`, `kept` and `drawn` each have two entries: first the old side, then the new one. An entry of
    `names` contains the side's ``name`` and ``about``, a line about its commit, or "" if it has none. `kept`
    contains the results of both sides, and `drawn` their figures. `lines` are shown in the summary at the top
    of the page.
    """
    loaders = [PackageLoader("placecat.compare"), PackageLoader("placecat.report")]
    templates = page_templates().overlay(loader=ChoiceLoader(loaders))
    old, new = kept
    titles = _titles(new)
    of_tables = {
        name: _table(old.tables.get(name), new.tables.get(name))
        for name in dict.fromkeys([*new.tables, *old.tables])
    }
    of_figures = _figures(*drawn)
    return str(
        templates.get_template("compare.html.j2").render(
            sides=[
                side | {"data": _data(one), "figures": figures}
                for side, one, figures in zip(names, kept, drawn, strict=True)
            ],
            lines=lines,
            settings=kept_in_git.changed_settings(new.settings, old.settings, _NOT_SHOWN),
            verdicts=turned(new.findings, old.findings),
            tables=[
                {"anchor": name.replace("_", "-"), "title": titles.get(name, name.replace("_", " ")), **table}
                for name, table in of_tables.items()
                if table["changed"]
            ],
            equal_tables=[
                titles.get(name, name) for name, table in of_tables.items() if not table["changed"]
            ],
            figures=[one for one in of_figures if not one["is_same"]],
            equal_figures=[one["label"] for one in of_figures if one["is_same"]],
        )
    )


def _titles(one: Kept) -> dict[str, str]:
    """Map each table's name to its label and title."""
    try:
        defined = {} if one.settings is None else tables_of(one.settings)
    except (PlacecatError, KeyError):
        # An older revision may name a setting differently.
        defined = {}
    titles = {
        name: table["title"] if table["number"] is None else f"{label(table)}: {table['title']}"
        for name, table in defined.items()
    }
    return titles | {"in_text": "Numbers in the thesis’s text"}


def _data(one: Kept) -> str:
    return str((one.settings or {}).get("dataset", {}).get("title", ""))


def _table(old: pd.DataFrame | None, new: pd.DataFrame | None) -> dict[str, Any]:
    """Return the columns, the rows by group with each cell's two numbers, and the number of changed cells."""
    before, now = _cells(old), _cells(new)
    keys = dict.fromkeys([*now, *before])
    columns = list(dict.fromkeys(column for *_, column in keys))
    groups: dict[str, dict[str, list[dict[str, Any]]]] = {}
    changed = 0
    for group, row in dict.fromkeys(key[:2] for key in keys):
        labels = [(group, row, column) for column in columns]
        cells = [_cell(before.get(key, ""), now.get(key, "")) for key in labels]
        groups.setdefault(group, {})[row] = cells
        changed += sum(cell["changed"] for cell in cells)
    return {"columns": columns, "groups": groups, "changed": changed}


def _cells(table: pd.DataFrame | None) -> dict[tuple[str, str, str], str]:
    """Map each cell's three labels to its number, as a string.

    The labels are group, row and column or, for a number in the text, name, quantity and home.
    """
    if table is None:
        return {}
    key = ["name", "quantity", "home"] if "quantity" in table.columns else ["group", "row", "column"]
    labels = table.reindex(columns=key, fill_value="").itertuples(index=False, name=None)
    return dict(zip(labels, table["measured"], strict=True))


def _cell(old: str, new: str) -> dict[str, Any]:
    numbers = [float(text) if text else None for text in (old, new)]
    before, now = numbers
    difference = None if before is None or now is None else round(now - before, 2)
    shown = ["" if number is None else f"{number:.2f}" for number in numbers]
    if difference == 0 and before != now:
        # Numbers other than percentages may differ by too little to show with two decimals.
        shown = [old, new]
    return {"old": shown[0], "new": shown[1], "changed": before != now, "difference": difference}


def _figures(old: Figures, new: Figures) -> list[dict[str, Any]]:
    """List all figures; for those that differ, include the old and new `pictures` (None if missing)."""
    found = []
    for name in sorted(old.pictures | new.pictures):
        pair = [one.pictures.get(name) for one in (old, new)]
        is_same = pair[0] == pair[1]
        number = re.fullmatch(r"figure_0*(\d+)", name)
        pictures = [] if is_same else [picture and shown_picture(picture) for picture in pair]
        found.append(
            {
                "anchor": f"figure-{number[1]}" if number else f"addition-{name}".replace("_", "-"),
                "label": f"Figure {number[1]}" if number else name.replace("_", " ").capitalize(),
                "title": (old.captions | new.captions)[name],
                "is_same": is_same,
                "pictures": pictures,
            }
        )
    return found
