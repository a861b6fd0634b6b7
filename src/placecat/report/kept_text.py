"""Describe the differences between two runs."""

from collections.abc import Sequence

from placecat.report.kept import Comparison, Grade

# How many differing tables, verdicts and settings to name at most.
_TABLES, _VERDICTS, _SETTINGS = 10, 10, 3


def sentences(comparison: Comparison, tolerance: float, kept: str, settings: Sequence[str] = ()) -> list[str]:
    """Describe line by line how a run differs, given a tolerance in points.

    `kept` names the source of the old tables, e.g. "git HEAD"; `settings` are the names of changed settings.
    """
    grade = comparison.grade(tolerance)
    lines = []
    if comparison.data:
        what = "Tables" if grade is Grade.NOT_COMPARED else "Some cells of the tables"
        lines.append(
            f"{what} are not compared: the old ones ({kept}) were measured on {comparison.data[0]}, "
            f"the new ones on {comparison.data[1]}."
        )
    elif grade is Grade.NOT_COMPARED:
        lines.append(f"Tables are not compared: neither the new nor the old ones ({kept}) have a number.")
    if grade is not Grade.NOT_COMPARED:
        lines += _about_tables(comparison, tolerance, kept)
    if comparison.findings:
        lines += _about_findings(comparison)
    if settings and (comparison.differing or comparison.turned):
        lines.append(f"Settings differ: {_some(settings, _SETTINGS)}. Expect differences.")
    elif grade is Grade.BEYOND:
        lines.append(
            "A different kind of processor does not explain this. If code or data were changed on purpose, "
            "commit reports/ with them; otherwise check `git status` and that the environment matches "
            "requirements.lock."
        )
    return lines


def _about_tables(comparison: Comparison, tolerance: float, kept: str) -> list[str]:
    cells = comparison.cells
    text = f"Tables: {cells - comparison.differing} of {cells} cells equal the old ones ({kept})"
    worst = comparison.largest
    if worst is not None:
        side = "within" if worst.largest <= tolerance else "beyond"
        text += (
            f"; largest difference {worst.largest:.2f} points in {worst.label} ({worst.where}), "
            f"{side} the tolerance of {tolerance:g} points (reproducibility.tolerance)"
        )
    for count, what in (
        (sum(table.appeared for table in comparison.tables), "gained a number"),
        (sum(table.disappeared for table in comparison.tables), "lost a number"),
    ):
        if count:
            text += f"; {count} {what}"
    changed = sorted((one for one in comparison.tables if one.differing), key=lambda one: -one.largest)
    lines = [f"{text}."]
    for one in changed[:_TABLES]:
        more = f", by at most {one.largest:.2f} points" if one.largest else ""
        lines.append(f"  {one.label}: {one.differing} of {one.cells} cells differ{more}")
    if len(changed) > _TABLES:
        lines.append(f"  and {len(changed) - _TABLES} more tables by less")
    return lines


def _about_findings(comparison: Comparison) -> list[str]:
    same = comparison.findings - len(comparison.turned)
    text = f"Findings: {same} of {comparison.findings} verdicts equal the old ones"
    turned = [f"finding {one.finding} was {one.kept!r} and is now {one.now!r}" for one in comparison.turned]
    return [f"{text}{'; ' if turned else ''}{_some(turned, _VERDICTS, '; ')}."]


def _some(names: Sequence[str], limit: int, separator: str = ", ") -> str:
    more = f"{separator}and {len(names) - limit} more" if len(names) > limit else ""
    return separator.join(names[:limit]) + more
