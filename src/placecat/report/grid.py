"""Arrange filled tables as grids for display, with formatted numbers and with notes as footnotes."""

import itertools
from collections.abc import Hashable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import pandas as pd

from placecat.evaluation.trials import AXES
from placecat.provenance.numbering import layout
from placecat.thesis.notes import Kind, Notes
from placecat.thesis.number import home_label
from placecat.thesis.tables import comparable, in_percent

# Differences, in points, at which the shade becomes darker. Our choice: differences below the first step may
# be due to the seed.
STEPS = (2.0, 5.0, 10.0, 20.0)
NUMBERS = ("measured", "published", "spread", "seeds")


@dataclass(frozen=True)
class Cell:
    """One cell of a table.

    `measured` and `published` are percentages with two decimals, or "" if missing; `published` is "n/a" where
    the thesis says so. `difference` is measured minus published in points, or None if either is missing.
    `spread` is the difference between the largest and smallest values over the seeds, in points, and `seeds`
    is the number of seeds. If nothing is random, `spread` is None and `seeds` is 0. `mark` and
    `published_mark` are the letters of the two numbers' footnotes.
    """

    measured: str = ""
    published: str = ""
    difference: float | None = None
    spread: float | None = None
    seeds: int = 0
    mark: str = ""
    published_mark: str = ""


@dataclass(frozen=True)
class Row:
    """A row's name and one cell per column."""

    name: str
    cells: tuple[Cell, ...]

    @property
    def has_published(self) -> bool:
        """Whether any cell has a published number."""
        return any(cell.published for cell in self.cells)


@dataclass(frozen=True)
class Group:
    """Rows under a common name, which may be ""."""

    name: str
    rows: tuple[Row, ...]


@dataclass(frozen=True)
class Grid:
    """A table arranged for display.

    The last entry of `columns` is the average. The `groups` of rows are in table order. `footnotes` maps
    letters, in order, to notes about single cells, including the reasons why cells are empty.
    """

    columns: tuple[str, ...]
    groups: tuple[Group, ...]
    footnotes: Mapping[str, str]

    @property
    def has_published(self) -> bool:
        """Whether any cell has a published number."""
        return any(row.has_published for group in self.groups for row in group.rows)


def make_grid(table: pd.DataFrame) -> Grid:
    """Arrange a filled table (:func:`placecat.thesis.tables.fill_table`); missing cells are empty."""
    rows, columns = layout(table)
    footnotes: list[str] = []
    cells = {
        (record["group"], record["row"], record["column"]): _cell(record, footnotes)
        for record in table.to_dict("records")
    }
    groups = []
    for group, names in rows.items():
        of_row = [[cells.get((group, name, column), Cell()) for column in columns] for name in names]
        groups.append(Group(group, tuple(map(Row, names, map(tuple, of_row)))))
    by_letter = {_letters(number): text for number, text in enumerate(footnotes)}
    return Grid(tuple(columns), tuple(groups), by_letter)


def shown_table(
    settings: Mapping[str, Any], table: pd.DataFrame, dataset: Mapping[str, Any]
) -> dict[str, Any]:
    """Prepare one filled table for a template: its grid, its title, and sentences about its numbers.

    `settings` defines the table: ``name``, ``number`` (None if it is not in the thesis), ``title``,
    ``thesis_data``, and ``caption`` if the numbers are not percentages. `table` comes from
    :func:`placecat.thesis.tables.fill_table`; `dataset` contains ``title``, ``homes`` and ``thesis_data``.
    """
    return {
        **{key: settings[key] for key in ("name", "number", "title", "thesis_data")},
        "caption": settings.get("caption", ""),
        "data": dataset["title"],
        "comparable": comparable(settings, dataset),
        "grid": make_grid(table),
        "homes": homes_sentence(table, dataset["homes"]),
        "seeds": seeds_sentence(table) if in_percent(settings) else "",
    }


def make_cell(row: Mapping[Any, Any]) -> Cell:
    """Build a cell from the numbers in a row, which are NaN if missing.

    They are the measured and published percentages, the spread in points, and the number of seeds.
    """
    measured, published, spread, seeds = (row[name] for name in NUMBERS)
    difference = round(float(measured - published), 2) + 0.0
    return Cell(
        measured=number_text(measured),
        published=number_text(published),
        difference=None if pd.isna(difference) else difference,
        spread=None if pd.isna(spread) else float(spread),
        seeds=0 if pd.isna(seeds) else int(seeds),
    )


def number_text(value: float | None) -> str:
    """Format a number with two decimals; "" for None or NaN."""
    return "" if value is None or pd.isna(value) else f"{value:.2f}"


def homes_sentence(table: pd.DataFrame, homes: Sequence[str]) -> str:
    """Return a sentence saying which home each label such as "Home 1" stands for; "" if this is obvious."""
    named = {*table["row"], *table["column"]}
    pairs = [(home_label(number), home) for number, home in enumerate(homes, start=1)]
    pairs = [(label, home) for label, home in pairs if label in named]
    # Home 1 is obviously home_1.
    if all(label.lower() == home.lower().replace("_", " ") for label, home in pairs):
        return ""
    return ", ".join(f"{label} is {home}" for label, home in pairs) + "."


def seeds_sentence(table: pd.DataFrame) -> str:
    """Say how many seeds the numbers are averaged over, and how much they vary; "" if nothing is random.

    The table has the columns measured, spread (in points) and seeds. If it also has group, row or column, the
    sentence says where the spread is largest.
    """
    random = table[(table["seeds"] > 1) & table["spread"].notna() & table["measured"].notna()]
    if random.empty:
        return ""
    one = random.nlargest(1, "spread").iloc[0]
    where = ", ".join(str(one[name]) for name in AXES if one.get(name))
    all_random = len(random) == table["measured"].notna().sum()
    subject = "Numbers are means" if all_random else "Numbers that depend on the seed are means"
    seeds = " or ".join(str(int(count)) for count in sorted(set(random["seeds"])))
    return (
        f"{subject} over {seeds} seeds. The seeds differ by {random['spread'].median():.2f} points in the "
        f"median cell and by at most {one['spread']:.2f} points{f' ({where})' if where else ''}."
    )


def _mark(notes: Notes, kind: Kind, footnotes: list[str]) -> str:
    """Return the letters of all notes of one kind, e.g. "a,c", and add new notes to `footnotes`."""
    texts = [note.text for note in notes if note.kind is kind]
    footnotes += [text for text in dict.fromkeys(texts) if text not in footnotes]
    return ",".join(_letters(footnotes.index(text)) for text in texts)


def _letters(number: int) -> str:
    """Return the letters of the n-th footnote (from 0): a, b, ..., z, aa, ab, ..."""
    rest, last = divmod(number, 26)
    return (_letters(rest - 1) if rest else "") + chr(ord("a") + last)


def _cell(record: Mapping[Hashable, Any], footnotes: list[str]) -> Cell:
    notes: Notes = record["notes"]
    cell = make_cell(record)
    is_not_available = any(note.kind is Kind.NOT_AVAILABLE for note in notes)
    return replace(
        cell,
        published="n/a" if is_not_available else cell.published,
        mark=_mark(notes, Kind.MEASURED, footnotes),
        published_mark=_mark(notes, Kind.PUBLISHED, footnotes),
    )


def shade(difference: float | None) -> str:
    """Return the name of a cell's shade, given the difference between its measured and published numbers.

    The difference is measured minus published in points, or None if there is nothing to compare. The name
    ranges from "above-1" to "above-4" or from "below-1" to "below-4", with higher numbers for larger
    differences. It is "" if the difference is small or missing.
    """
    if difference is None:
        return ""
    level = sum(abs(difference) >= step for step in STEPS)
    return f"{'above' if difference > 0 else 'below'}-{level}" if level else ""


def legend() -> list[tuple[str, str]]:
    """List all shades and their meanings, from far below to far above."""
    bounds = [f"{low:g} to {high:g}" for low, high in itertools.pairwise(STEPS)]
    bounds.append(f"{STEPS[-1]:g} or more")
    below = [(f"below-{level}", f"{text} below") for level, text in enumerate(bounds, start=1)]
    above = [(f"above-{level}", f"{text} above") for level, text in enumerate(bounds, start=1)]
    return [*reversed(below), ("", f"within {STEPS[0]:g}"), *above]
