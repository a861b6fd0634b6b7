"""How the tables of a run differ from those kept in git."""

import re
from collections.abc import Mapping
from dataclasses import dataclass
from enum import Enum
from typing import NamedTuple

import pandas as pd

NONE = "none"
# What a row says of its cell; its other columns say which cell it is, except for the table's number.
_SAID = ("table", "published", "measured", "spread", "seeds", "note", "data")


class Grade(Enum):
    """What a comparison comes to."""

    EQUAL = "equal"
    WITHIN = "within the tolerance"
    BEYOND = "beyond the tolerance"
    NOT_COMPARED = "not compared"


class _Cell(NamedTuple):
    """A cell's number and its spread over seeds, NaN for none, and its data set; "" without a number."""

    measured: float
    spread: float
    data: str


_EMPTY = _Cell(float("nan"), float("nan"), "")
_Cells = Mapping[tuple[str, ...], _Cell]
# A cell now, and kept.
_Pairs = dict[tuple[str, ...], tuple[_Cell, _Cell]]


@dataclass(frozen=True)
class TableDifference:
    """How one table, e.g. ``table_26``, differs.

    Attributes
    ----------
    cells
        Number of cells with a number, now or kept, that were compared.
    differing
        How many of them do not have the same number and the same spread over seeds.
    largest, where
        The largest difference of a number in points, and the labels of its cell; 0 and "" if there is none.
    appeared, disappeared
        How many have a number now and had none, and the other way round.
    """

    name: str
    cells: int
    differing: int
    largest: float
    where: str
    appeared: int
    disappeared: int

    @property
    def label(self) -> str:
        """The table's name for people, e.g. "Table 26"."""
        number = re.fullmatch(r"table_0*(\d+)", self.name)
        return f"Table {number[1]}" if number else self.name.replace("_", " ")


@dataclass(frozen=True)
class Turned:
    """A finding whose verdict is not the kept one; `NONE` on the side that lacks the finding."""

    finding: str
    kept: str
    now: str


@dataclass(frozen=True)
class Comparison:
    """How all tables and verdicts of a run differ from kept ones.

    Attributes
    ----------
    tables
        By name.
    data
        Data sets that kept cells and these were measured on, if they are not the same; such cells were not
        compared.
    findings
        Number of findings compared.
    turned
        Those whose verdict differs.
    """

    tables: tuple[TableDifference, ...]
    data: tuple[str, str] | None
    findings: int
    turned: tuple[Turned, ...]

    @property
    def cells(self) -> int:
        """Number of cells compared."""
        return sum(table.cells for table in self.tables)

    @property
    def differing(self) -> int:
        """Number of cells that differ."""
        return sum(table.differing for table in self.tables)

    @property
    def largest(self) -> TableDifference | None:
        """The table with the largest difference; None if no number differs."""
        worst = max(self.tables, key=lambda table: table.largest, default=None)
        return worst if worst is not None and worst.largest else None

    def grade(self, tolerance: float) -> Grade:
        """Judge the differences.

        A number that appeared or disappeared is beyond any tolerance. A verdict is not, since it may turn
        when a number moves a little.

        Parameters
        ----------
        tolerance
            Points by which a number may differ.
        """
        if not self.cells:
            return Grade.NOT_COMPARED
        if any(one.appeared or one.disappeared or one.largest > tolerance for one in self.tables):
            return Grade.BEYOND
        return Grade.WITHIN if self.differing or self.turned else Grade.EQUAL


def compare(
    now: Mapping[str, pd.DataFrame],
    kept: Mapping[str, pd.DataFrame],
    findings_now: pd.DataFrame | None = None,
    findings_kept: pd.DataFrame | None = None,
) -> Comparison:
    """Compare what a run made with what was kept.

    Where the two numbers of a cell are of two data sets, only cells of the same one are compared, and no
    verdicts.

    Parameters
    ----------
    now, kept
        Name of a table to its filled form, numbers as text or not, empty for none: the columns measured
        (percent), spread (points, may be missing) and data, the data set ("" if unknown); and columns that
        say which cell a row is, e.g. group, row, column.
    findings_now, findings_kept
        A row a finding, with the columns number and verdict; None for no findings.
    """
    names = sorted(now.keys() | kept.keys())
    pairs = {name: _pairs(_cells(now.get(name)), _cells(kept.get(name))) for name in names}
    apart = (
        (old.data, new.data)
        for cells in pairs.values()
        for new, old in cells.values()
        if new.data and old.data and new.data != old.data
    )
    data = next(apart, None)
    if data is not None:
        pairs = {
            name: {key: (new, old) for key, (new, old) in cells.items() if new.data and new.data == old.data}
            for name, cells in pairs.items()
        }
    tables = tuple(_compare_table(name, cells) for name, cells in pairs.items())
    if data is not None or findings_now is None or findings_kept is None:
        return Comparison(tables, data, 0, ())
    return Comparison(tables, data, *_compare_verdicts(findings_now, findings_kept))


def _cells(table: pd.DataFrame | None) -> dict[tuple[str, ...], _Cell]:
    if table is None:
        return {}
    labels = table[[column for column in table.columns if column not in _SAID]].fillna("").astype(str)
    numbers = table.reindex(columns=["measured", "spread"]).apply(pd.to_numeric, errors="coerce")
    titles = table["data"].where(numbers["measured"].notna(), "")
    return {
        key: _Cell(measured, spread, title)
        for key, (measured, spread), title in zip(
            labels.itertuples(index=False, name=None),
            numbers.itertuples(index=False, name=None),
            titles,
            strict=True,
        )
    }


def _pairs(now: _Cells, kept: _Cells) -> _Pairs:
    return {key: (now.get(key, _EMPTY), kept.get(key, _EMPTY)) for key in dict.fromkeys([*now, *kept])}


def _compare_table(name: str, pairs: _Pairs) -> TableDifference:
    cells = differing = appeared = disappeared = 0
    largest, where = 0.0, ""
    for key, (new, old) in pairs.items():
        is_new, is_old = not pd.isna(new.measured), not pd.isna(old.measured)
        cells += is_new or is_old
        appeared += is_new and not is_old
        disappeared += is_old and not is_new
        differing += not (_same(new.measured, old.measured) and _same(new.spread, old.spread))
        # Both have two decimals, their difference in floating point has more.
        distance = round(abs(new.measured - old.measured), 2) if is_new and is_old else 0.0
        if distance > largest:
            largest, where = distance, ", ".join(filter(None, key))
    return TableDifference(name, cells, differing, largest, where, appeared, disappeared)


def _same(one: float, other: float) -> bool:
    return one == other or (pd.isna(one) and pd.isna(other))


def _compare_verdicts(now: pd.DataFrame, kept: pd.DataFrame) -> tuple[int, tuple[Turned, ...]]:
    """Count findings, and list those whose verdicts differ."""
    new, old = (dict(zip(one["number"].astype(str), one["verdict"], strict=True)) for one in (now, kept))
    both = dict.fromkeys([*new, *old])
    turned = (Turned(finding, old.get(finding, NONE), new.get(finding, NONE)) for finding in both)
    return len(both), tuple(one for one in turned if one.kept != one.now)
