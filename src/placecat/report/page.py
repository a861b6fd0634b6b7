"""The report: one self-contained HTML page with every table, figure, finding and setting."""

import json
from collections.abc import Hashable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache
from typing import Any

import pandas as pd
from jinja2 import Environment
from markupsafe import Markup, escape

from placecat.provenance.cells import Table
from placecat.report.embed import embed
from placecat.report.grid import Cell, legend, make_cell, number_text, seeds_sentence, shade, shown_table
from placecat.report.sections import arrange
from placecat.report.summary import WU, best_system, count_verdicts, headlines, judged_together, readings_of
from placecat.templates import environment
from placecat.thesis.notes import joined

# CSS pixels per figure pixel. Figures with 200 pixels per inch then appear at 125%.
_FIGURE_SCALE = 0.6
# Attributes of a report that are passed to the template unchanged.
_UNCHANGED = ("dataset", "frames", "data_version", "replication", "times", "speed", "scale")


@dataclass(frozen=True)
class Figure:
    """One figure on the page.

    `number` is its number in the thesis, or None for an additional figure. `title` is its caption, and `name`
    its name, e.g. "figure_02". A missing figure has a `reason` instead of a `png`. `pdf` is the path of the
    PDF relative to the page, or "". `settings` lists the figure's settings, e.g. "frames=300, home=2".
    """

    number: int | None
    title: str
    png: bytes | None
    reason: str = ""
    name: str = ""
    pdf: str = ""
    settings: str = ""


@dataclass(frozen=True)
class Report:
    """The content of the page, with tables and figures in any order.

    `dataset` contains the run's ``title``, ``homes``, ``classes``, ``thesis_data`` and, optionally, a
    ``note``. `frames` maps each home to its number of frames in each place and its number of ``unlabelled``
    frames. `data_version` is the checksum of the data, and `settings` is the content of params.yaml.
    `in_text` contains the numbers that appear only in the thesis's text, with the columns name, section,
    quantity, home, published, measured, spread, seeds and notes. `findings` and `comparisons` come from
    :func:`placecat.thesis.findings.ledger`, which explains their columns. The other attributes are optional:

    replication
        The findings on many homes: the ``title`` of their data set, the numbers of ``homes`` and ``groups``,
        the ``level`` of the intervals, and ``verdicts`` (the number of findings with each verdict).
        ``findings`` is a table with the columns number, difference, low, high, units, verdict, and
        ``replicated``, which is False for findings on data other than homes.
    times
        A stored record of a run's times. ``stages`` is a table with the columns stage, runs and seconds; a
        stage may run several times, for example once per home. ``data`` is the title of the data set,
        ``cores`` is the number of cores in the machine, and ``total`` is the duration of the complete run in
        seconds.
    speed, scale
        Stored records from :func:`placecat.report.benchmarks.shown_speed` and
        :func:`placecat.report.scale.shown_scale`; each also has ``chart``, a PNG or None.
    explanations
        From :func:`placecat.provenance.text.explanations`, with ``stages``
        (:func:`placecat.provenance.lines.stage_texts`).
    """

    dataset: Mapping[str, Any]
    frames: Mapping[str, Mapping[str, int]]
    data_version: str
    tables: Sequence[Table]
    figures: Sequence[Figure]
    in_text: pd.DataFrame
    findings: pd.DataFrame
    comparisons: pd.DataFrame
    settings: str
    replication: Mapping[str, Any] | None = None
    times: Mapping[str, Any] | None = None
    speed: Mapping[str, Any] | None = None
    scale: Mapping[str, Any] | None = None
    explanations: Mapping[str, Any] | None = None


def page_html(report: Report) -> str:
    """Render the page. Identical reports produce identical HTML."""
    tables = {one.settings["number"]: _shown_table(one) for one in report.tables if one.settings["number"]}
    additions = [_shown_table(one) for one in report.tables if not one.settings["number"]]
    figures = {one.number: _shown_figure(one) for one in report.figures if one.number}
    added_figures = [_shown_figure(one) for one in report.figures if not one.number]
    sections, rest = arrange(tables, figures)
    table_26 = next((one.cells for one in report.tables if one.settings["number"] == 26), None)
    comparisons = report.comparisons.drop(columns=["left_results", "right_results"], errors="ignore")
    replicated = [] if report.replication is None else _records(report.replication["findings"])
    in_text = report.in_text.rename(columns={"quantity": "row", "home": "column"})
    return (
        page_templates()
        .get_template("page.html.j2")
        .render(
            **{name: getattr(report, name) for name in _UNCHANGED},
            best=None if table_26 is None else best_system(table_26),
            headlines=[] if table_26 is None else headlines(table_26),
            wu=WU,
            verdicts=count_verdicts(report.findings),
            findings=_records(report.findings),
            readings=readings_of(report.findings),
            replicated={one["number"]: one for one in replicated if one["replicated"]},
            interval_limit=_interval_limit(report.findings),
            judged_together=judged_together(report.comparisons),
            comparisons=_plain(comparisons),
            sections=sections,
            rest=rest,
            tables=tables,
            figures=figures,
            additions=additions,
            added_figures=added_figures,
            in_text=_entries(report.in_text),
            in_text_seeds=seeds_sentence(in_text),
            legend=legend(),
            settings=_blocks(report.settings),
            explanations=_json(report.explanations),
            time_rows=[] if report.times is None else _records(report.times["stages"]),
        )
    )


def anchor(settings: Mapping[str, Any]) -> str:
    """Return a table's anchor, e.g. ``table-26``, or ``addition-some-name`` if it has no number."""
    number = settings["number"]
    return f"addition-{settings['name']}".replace("_", "-") if number is None else f"table-{number}"


def duration(seconds: float) -> str:
    """Format a duration given in seconds, e.g. "2 h 5 min", "4 min 3 s" or "0.8 s"."""
    if seconds < 9.95:
        return f"{seconds:.1f} s"
    minutes, rest = divmod(round(seconds), 60)
    hours, minutes = divmod(minutes, 60)
    parts = [f"{hours} h"] * bool(hours) + [f"{minutes} min"] * bool(minutes)
    return " ".join(parts + [f"{rest} s"] * (not hours and bool(rest or not minutes)))


# Cached because each new environment would compile its templates again.
@cache
def page_templates() -> Environment:
    """Return the Jinja environment for the page templates, including its filters."""
    templates = environment("placecat.report").overlay()
    templates.filters = templates.filters | {
        "at": _at,
        "breakable": _breakable,
        "duration": duration,
        "number": _number,
        "picture": shown_picture,
        "shade": shade,
        "signed": _signed,
    }
    return templates


def _shown_table(table: Table) -> dict[str, Any]:
    return {"anchor": anchor(table.settings), **shown_table(table.settings, table.cells, table.dataset)}


def _shown_figure(figure: Figure) -> dict[str, Any]:
    added = figure.number is None
    return {
        "anchor": f"addition-{figure.name}".replace("_", "-") if added else f"figure-{figure.number}",
        "label": "Addition" if added else f"Figure {figure.number}",
        "name": figure.name.removeprefix("figure_").replace("_", " "),
        "title": figure.title,
        "reason": figure.reason,
        "pdf": figure.pdf,
        "settings": figure.settings,
        **({"source": None} if figure.png is None else shown_picture(figure.png)),
    }


def shown_picture(png: bytes) -> dict[str, Any]:
    """Return an image's data URI (``source``) and its display ``width`` and ``height`` in CSS pixels."""
    picture = embed(png)
    width, height = (round(pixels * _FIGURE_SCALE) for pixels in (picture.width, picture.height))
    return {"source": picture.source, "width": width, "height": height}


def _entries(in_text: pd.DataFrame) -> list[dict[str, Any]]:
    """Group the numbers in the text by subject."""
    entries = []
    for name, part in in_text.groupby("name", sort=False):
        rows = [
            {
                "quantity": record["quantity"],
                "home": record["home"],
                "cell": _cell_of_text(record),
                "note": joined(note for note in record["notes"] if not note.is_of_the_table),
            }
            for record in part.to_dict("records")
        ]
        named = {"anchor": f"in-text-{name}".replace("_", "-"), "name": str(name).replace("_", " ")}
        entries.append(named | {"section": part["section"].iloc[0], "rows": rows})
    return entries


def _cell_of_text(record: Mapping[Any, Any]) -> Cell:
    """Build the cell for a number in the text; a number that is not a percentage may have more decimals."""
    cell, values = make_cell(record), (record["measured"], record["published"])
    if all(pd.isna(value) or value == round(value, 2) for value in values):
        return cell
    measured, published = ("" if pd.isna(value) else f"{value:.5f}" for value in values)
    return replace(cell, measured=measured, published=published, difference=None)


def _records(table: pd.DataFrame) -> list[dict[Hashable, Any]]:
    """Turn rows into dictionaries, with None for missing values."""
    return table.astype(object).where(table.notna(), None).to_dict("records")


def _plain(table: pd.DataFrame) -> dict[str, Any]:
    """Return a table's columns, each with a flag that says whether it is numeric, and its cells as text."""
    numeric = {name: pd.api.types.is_numeric_dtype(table[name]) for name in table.columns}
    columns = [{"name": str(name).replace("_", " "), "numeric": numeric[name]} for name in table.columns]
    rows = [[_number(value) for value in row] for row in table.itertuples(index=False)]
    return {"columns": columns, "rows": rows}


def _number(value: Any) -> str:
    """Format floats with two decimals, integers with none, and None and NaN as ""; leave text unchanged."""
    if value is None or isinstance(value, float):
        return number_text(value)
    return str(value)


def _breakable(text: str) -> Markup:
    """Allow a line break after each plus sign in a long label."""
    return escape(text).replace("+", Markup("+<wbr>"))


def _signed(value: float) -> str:
    """Format points with a sign, using a true minus, e.g. "−1.20"."""
    return f"{value:+.2f}".replace("-", "−")


def _at(points: float, limit: float) -> str:
    """Return a value's position on a 100-pixel axis from -limit to limit.

    Values beyond the limits are drawn at the ends of the axis.
    """
    return f"{50 + 46 * max(-limit, min(limit, points)) / limit:.1f}"


def _interval_limit(findings: pd.DataFrame) -> float:
    """Choose the axis limit for the ledger's intervals: a multiple of 5 points, at most 25."""
    bounds = findings[["difference", "low", "high"]].apply(pd.to_numeric, errors="coerce").abs().max().max()
    return 5.0 if pd.isna(bounds) else float(min(25.0, 5.0 * max(1.0, -(-bounds // 5))))


def _json(content: Mapping[str, Any] | None) -> Markup | None:
    """Format content as compact JSON that is safe inside a script element."""
    if content is None:
        return None
    text = json.dumps(content, ensure_ascii=False, separators=(",", ":"))
    return Markup(text.replace("<", "\\u003c"))


def _blocks(settings: str) -> list[dict[str, str]]:
    """Split the settings into blocks of lines, one for each top-level name."""
    blocks: list[dict[str, str]] = []
    for line in settings.splitlines():
        if not blocks or (line and not line.startswith((" ", "-", "#"))):
            blocks.append({"name": line.split(":")[0], "text": line})
        else:
            blocks[-1]["text"] += f"\n{line}"
    return blocks
