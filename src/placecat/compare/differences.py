"""Compare the tables and verdicts of an old and a new run, and describe the differences."""

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import pandas as pd

NONE = "none"
# Columns that hold a cell's content or its table's number. The other columns identify the cell.
_CONTENT = ("table", "published", "measured", "spread", "seeds", "note", "data")
# The report lists at most this many tables, verdicts and settings.
_TABLES, _VERDICTS, _SETTINGS = 10, 10, 3


@dataclass(frozen=True)
class TableDifference:
    """The differences in one table, such as ``table_26``.

    `cells` counts the compared cells: those with an old number, a new number, or both. `differing` counts the
    cells whose number or spread over seeds has changed. `largest` is the largest difference in points, and
    `where` contains the labels of the cell with this difference. If no two numbers differ, `largest` is 0 and
    `where` is "". `appeared` counts the cells that have only a new number, and `disappeared` those that have
    only an old one.
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
        """The table's display name, e.g. "Table 26"."""
        number = re.fullmatch(r"table_0*(\d+)", self.name)
        return f"Table {number[1]}" if number else self.name.replace("_", " ")


@dataclass(frozen=True)
class Turned:
    """A finding whose verdict has changed; the verdict is `NONE` if a run does not contain the finding."""

    finding: str
    kept: str
    now: str
    claim: str = ""


@dataclass(frozen=True)
class Comparison:
    """The differences in all tables, sorted by name, and in all verdicts.

    If some cells come from different data sets, they are not compared, and `data` contains the titles of the
    old and new data sets. `findings` is the number of findings, and `turned` lists those whose verdict has
    changed.
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

    def exceeds(self, tolerance: float) -> bool:
        """Whether a number has appeared, disappeared, or changed by more than a tolerance in points.

        Verdicts are ignored, because even a small change in a number can change a verdict.
        """
        return any(one.appeared or one.disappeared or one.largest > tolerance for one in self.tables)


def compare(
    now: Mapping[str, pd.DataFrame],
    kept: Mapping[str, pd.DataFrame],
    findings_now: pd.DataFrame | None = None,
    findings_kept: pd.DataFrame | None = None,
) -> Comparison:
    """Compare new tables with old ones.

    Cells whose two numbers come from different data sets are not compared. If there are any, verdicts are not
    compared either. `now` and `kept` map names to the new and old tables. Numbers in the tables may be
    strings; a missing number is an empty string. Each row describes one cell. Its columns are measured
    (percent), spread (points, optional), data (the data set, "" if unknown), and those that identify the
    cell, such as group, row and column. A findings table has one row per finding, with the columns number and
    verdict. It is None if missing.
    """
    pairs = {
        name: _pairs(_cells(now.get(name)), _cells(kept.get(name)))
        for name in sorted(now.keys() | kept.keys())
    }
    on = pd.concat([pairs[name][["data_now", "data_kept"]] for name in pairs]) if pairs else pd.DataFrame()
    apart = [(old, new) for new, old in on.itertuples(index=False) if new and old and new != old]
    data = apart[0] if apart else None
    if data is not None:
        pairs = {
            name: cells[(cells["data_now"] == cells["data_kept"]) & (cells["data_now"] != "")]
            for name, cells in pairs.items()
        }
    tables = tuple(_compare_table(name, cells) for name, cells in pairs.items())
    if data is not None or findings_now is None or findings_kept is None:
        return Comparison(tables, data, 0, ())
    findings = {*findings_now["number"].astype(str), *findings_kept["number"].astype(str)}
    return Comparison(tables, data, len(findings), turned(findings_now, findings_kept))


def _cells(table: pd.DataFrame | None) -> pd.DataFrame:
    """Return each cell's number, spread and data set, indexed by the cell's labels.

    A missing spread is NaN. The data set is "" if the number is missing.
    """
    if table is None:
        table = pd.DataFrame(columns=["measured", "data"])
    labels = table[[column for column in table.columns if column not in _CONTENT]].fillna("").astype(str)
    cells = table.reindex(columns=["measured", "spread"]).apply(pd.to_numeric, errors="coerce")
    cells["data"] = table["data"].where(cells["measured"].notna(), "")
    cells.index = pd.Index(list(labels.itertuples(index=False, name=None)), dtype=object, tupleize_cols=False)
    return cells[~cells.index.duplicated(keep="last")]


def _pairs(now: pd.DataFrame, kept: pd.DataFrame) -> pd.DataFrame:
    """Join a new and an old table by cell; cells found only in the old table come last."""
    labels = now.index.append(kept.index.difference(now.index, sort=False))
    sides = (now.reindex(labels).add_suffix("_now"), kept.reindex(labels).add_suffix("_kept"))
    both = pd.concat(sides, axis=1)
    return both.fillna({"data_now": "", "data_kept": ""})


def _compare_table(name: str, cells: pd.DataFrame) -> TableDifference:
    new, old = cells["measured_now"], cells["measured_kept"]
    is_new, is_old = new.notna(), old.notna()
    spreads = cells["spread_now"], cells["spread_kept"]
    # A missing number is NaN, which differs from itself.
    differs = [(one != other) & (one.notna() | other.notna()) for one, other in ((new, old), spreads)]
    # Both numbers have two decimals, but their floating-point difference may have more.
    distance = (new - old).abs().round(2).dropna()
    largest = float(distance.max()) if len(distance) else 0.0
    where = ", ".join(filter(None, distance.index[int(distance.argmax())])) if largest else ""
    return TableDifference(
        name,
        cells=int((is_new | is_old).sum()),
        differing=int((differs[0] | differs[1]).sum()),
        largest=largest,
        where=where,
        appeared=int((is_new & ~is_old).sum()),
        disappeared=int((is_old & ~is_new).sum()),
    )


def turned(now: pd.DataFrame | None, kept: pd.DataFrame | None) -> tuple[Turned, ...]:
    """List the findings whose verdicts differ between two tables; None is treated as an empty table."""
    new, old = (
        {} if table is None else {str(row["number"]): row for row in table.to_dict("records")}
        for table in (now, kept)
    )
    found = []
    for finding in dict.fromkeys([*new, *old]):
        was, now_is = (side[finding]["verdict"] if finding in side else NONE for side in (old, new))
        if was != now_is:
            claim = (new.get(finding) or old[finding]).get("claim", "")
            found.append(Turned(finding, was, now_is, claim))
    return tuple(found)


def sentences(comparison: Comparison, tolerance: float, kept: str, settings: Sequence[str]) -> list[str]:
    """Describe how a run differs from an old one, as a list of lines.

    `tolerance` is in points. `kept` says where the old tables are, e.g. "git HEAD". `settings` lists the
    names of the changed settings.
    """
    lines = []
    if comparison.data:
        what = "Some cells of the tables" if comparison.cells else "Tables"
        lines.append(
            f"{what} are not compared: the old ones ({kept}) were measured on {comparison.data[0]}, "
            f"the new ones on {comparison.data[1]}."
        )
    elif not comparison.cells:
        lines.append(f"Tables are not compared: neither the new nor the old ones ({kept}) have a number.")
    if comparison.cells:
        lines += _about_tables(comparison, tolerance, kept)
    if comparison.findings:
        lines.append(_about_findings(comparison))
    if settings and (comparison.differing or comparison.turned):
        lines.append(f"Settings differ: {_some(settings, _SETTINGS)}. Expect differences.")
    elif comparison.exceeds(tolerance):
        lines.append(
            "A different processor does not explain these differences. If you changed code or data on "
            "purpose, commit reports/ with them; otherwise check `git status` and whether the environment "
            "matches requirements.lock."
        )
    return lines


def _about_tables(comparison: Comparison, tolerance: float, kept: str) -> list[str]:
    cells = comparison.cells
    text = f"Tables: {cells - comparison.differing} of {cells} cells match the old ones ({kept})"
    worst = comparison.largest
    if worst is not None:
        side = "within" if worst.largest <= tolerance else "beyond"
        text += (
            f"; largest difference {worst.largest:.2f} points in {worst.label} ({worst.where}), "
            f"{side} the tolerance of {tolerance:g} points (reproducibility.tolerance)"
        )
    if gained := sum(table.appeared for table in comparison.tables):
        text += f"; {gained} gained a number"
    if lost := sum(table.disappeared for table in comparison.tables):
        text += f"; {lost} lost a number"
    changed = sorted((one for one in comparison.tables if one.differing), key=lambda one: -one.largest)
    lines = [f"{text}."]
    for one in changed[:_TABLES]:
        more = f", by at most {one.largest:.2f} points" if one.largest else ""
        lines.append(f"  {one.label}: {one.differing} of {one.cells} cells differ{more}")
    if len(changed) > _TABLES:
        lines.append(f"  and {len(changed) - _TABLES} more tables, with smaller differences")
    return lines


def _about_findings(comparison: Comparison) -> str:
    same = comparison.findings - len(comparison.turned)
    text = f"Findings: {same} of {comparison.findings} verdicts match the old ones"
    changes = [f"finding {one.finding} was {one.kept!r} and is now {one.now!r}" for one in comparison.turned]
    return f"{text}{'; ' if changes else ''}{_some(changes, _VERDICTS, '; ')}."


def _some(names: Sequence[str], limit: int, separator: str = ", ") -> str:
    more = f"{separator}and {len(names) - limit} more" if len(names) > limit else ""
    return separator.join(names[:limit]) + more
