"""A filled table as a grid for people: rows and columns in order, numbers as text, notes as footnotes."""

from collections.abc import Hashable, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import pandas as pd

from placecat.thesis.notes import Kind, Notes
from placecat.thesis.number import AVERAGE, home_label

NOT_AVAILABLE = "n/a"


@dataclass(frozen=True)
class Cell:
    """One cell.

    Attributes
    ----------
    measured, published
        Percent with two decimals, "" for none; `published` is "n/a" where the thesis has that.
    difference
        Measured minus published in points; None unless there are both.
    spread
        The largest minus the smallest of the seeds in points; None where nothing is random.
    seeds
        Number of seeds, 0 where nothing is random.
    mark, published_mark
        Letters of the footnotes on the two numbers, "" for none.
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
    """A row's name and one cell a column."""

    name: str
    cells: tuple[Cell, ...]

    @property
    def has_published(self) -> bool:
        """Whether any cell has a published number."""
        return any(cell.published for cell in self.cells)


@dataclass(frozen=True)
class Group:
    """Rows under a common name, "" for none."""

    name: str
    rows: tuple[Row, ...]

    @property
    def has_published(self) -> bool:
        """Whether any row has a published number."""
        return any(row.has_published for row in self.rows)


@dataclass(frozen=True)
class Footnote:
    """A letter, what it stands for, and on how many cells it stands."""

    mark: str
    text: str
    cells: int


@dataclass(frozen=True)
class Grid:
    """A table.

    Attributes
    ----------
    columns
        Names of the columns in order, the average last.
    groups
        Rows in groups, in the table's order.
    footnotes
        Reasons of empty cells and notes on single cells, in order of their letters.
    """

    columns: tuple[str, ...]
    groups: tuple[Group, ...]
    footnotes: tuple[Footnote, ...]

    @property
    def has_published(self) -> bool:
        """Whether any group has a published number."""
        return any(group.has_published for group in self.groups)


def make_grid(table: pd.DataFrame) -> Grid:
    """Arrange the long form of a table.

    Parameters
    ----------
    table
        From :func:`placecat.thesis.tables.fill_table`: columns group, row, column, published, measured,
        spread, seeds, notes.

    Returns
    -------
    Grid
        Cells that the long form lacks are empty.
    """
    columns = _ordered(table["column"])
    footnotes = _Footnotes()
    cells = {
        (record["group"], record["row"], record["column"]): _cell(record, footnotes)
        for record in table.to_dict("records")
    }
    groups = []
    for group, part in table.groupby("group", sort=False):
        rows = [
            Row(name, tuple(cells.get((group, name, column), Cell()) for column in columns))
            for name in _ordered(part["row"])
        ]
        groups.append(Group(str(group), tuple(rows)))
    return Grid(tuple(columns), tuple(groups), footnotes.all())


def make_cell(
    measured: float | None,
    published: float | None,
    spread: float | None = None,
    seeds: float = 0,
) -> Cell:
    """A cell of two percentages, each None or NaN for none; `spread` likewise, in points."""
    difference = None
    if measured is not None and published is not None and pd.notna(measured - published):
        difference = round(float(measured - published), 2) + 0.0
    return Cell(
        measured=number_text(measured),
        published=number_text(published),
        difference=difference,
        spread=float(spread) if spread is not None and pd.notna(spread) else None,
        seeds=int(seeds) if pd.notna(seeds) else 0,
    )


def number_text(value: float | None) -> str:
    """A number with two decimals, "" for None or NaN."""
    return "" if value is None or pd.isna(value) else f"{value:.2f}"


def homes_sentence(table: pd.DataFrame, homes: Sequence[str]) -> str:
    """Say which home is "Home 1", for those that name a row or a column; "" for none.

    Parameters
    ----------
    table
        Columns row and column.
    homes
        Names of the data set's homes in order.
    """
    named = {*table["row"], *table["column"]}
    pairs = [(home_label(number), home) for number, home in enumerate(homes, start=1)]
    pairs = [(label, home) for label, home in pairs if label in named]
    # That Home 1 is home_1 goes without saying.
    if all(label.lower() == home.lower().replace("_", " ") for label, home in pairs):
        return ""
    return ", ".join(f"{label} is {home}" for label, home in pairs) + "."


def seeds_sentence(table: pd.DataFrame) -> str:
    """Say how many seeds the numbers are the mean of and how far those lie apart; "" where nothing is random.

    Parameters
    ----------
    table
        Columns measured, spread (points) and seeds, and for the place of the largest spread those of
        group, row, column that it has.
    """
    random = table[(table["seeds"] > 1) & table["spread"].notna() & table["measured"].notna()]
    if random.empty:
        return ""
    one = random.nlargest(1, "spread").iloc[0]
    where = ", ".join(str(one[name]) for name in ("group", "row", "column") if one.get(name))
    all_random = len(random) == table["measured"].notna().sum()
    subject = "Numbers are means" if all_random else "Numbers that depend on chance are means"
    seeds = " or ".join(str(int(count)) for count in sorted(set(random["seeds"])))
    return (
        f"{subject} of {seeds} seeds, which lie {random['spread'].median():.2f} points apart in the median "
        f"cell and {one['spread']:.2f} at most{f' ({where})' if where else ''}."
    )


def _ordered(names: Iterable[str]) -> Sequence[str]:
    """Names without repetition, the average last: cells that only this run has follow the published ones."""
    found = list(dict.fromkeys(names))
    return [name for name in found if name != AVERAGE] + [name for name in found if name == AVERAGE]


class _Footnotes:
    """Gives each text a letter, in order of appearance."""

    def __init__(self) -> None:
        self._cells: dict[str, int] = {}

    def mark(self, texts: Iterable[str]) -> str:
        """Letters of some texts, e.g. "a,c"."""
        for text in (texts := list(texts)):
            self._cells[text] = self._cells.get(text, 0) + 1
        order = list(self._cells)
        return ",".join(_letters(order.index(text)) for text in texts)

    def all(self) -> tuple[Footnote, ...]:
        """Every footnote."""
        return tuple(
            Footnote(_letters(number), text, cells)
            for number, (text, cells) in enumerate(self._cells.items())
        )


def _letters(number: int) -> str:
    """A, b, ..., z, aa, ab, ..."""
    rest, last = divmod(number, 26)
    return (_letters(rest - 1) if rest else "") + chr(ord("a") + last)


def _cell(record: Mapping[Hashable, Any], footnotes: _Footnotes) -> Cell:
    notes: Notes = record["notes"]
    cell = make_cell(record["measured"], record["published"], record["spread"], record["seeds"])
    return replace(
        cell,
        published=NOT_AVAILABLE if any(note.kind is Kind.NOT_AVAILABLE for note in notes) else cell.published,
        mark=footnotes.mark(note.text for note in notes if note.kind is Kind.MEASURED),
        published_mark=footnotes.mark(note.text for note in notes if note.kind is Kind.PUBLISHED),
    )
