"""The contents of the MLflow runs for a table and its rows: parameters, metrics, a description and files."""

from collections.abc import Callable, Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd

from placecat import files
from placecat.drawing.style import house_style, save
from placecat.evaluation.trials import AXES, HOMES, trial_name
from placecat.evaluation.verdict import VERDICTS
from placecat.mlflow_log.params import params_of_results
from placecat.mlflow_log.store import key
from placecat.mlflow_log.tables import RUN_ID, RowRun, TableRun
from placecat.provenance.made import Made
from placecat.report.charts.accuracy import accuracy_chart
from placecat.report.charts.matrices import draw_matrices, draw_sheet
from placecat.report.formats import table_markdown
from placecat.report.summary import readings_of
from placecat.results.confusion import confusion_rows, pooled_rows
from placecat.results.measured import Measured, Results, score_rows
from placecat.thesis.decisions import decisions_of
from placecat.thesis.number import AVERAGE
from placecat.thesis.tables import COLUMNS, comparable, in_percent, label

# MLflow accepts up to 8000 characters. The margin leaves room for the run id, which is longer than its
# placeholder.
_LONGEST_DESCRIPTION = 7900
# Paragraphs have no line breaks, since the user interface would show them.
_READING = (
    "\n**How to read it.** Each row of the table is a nested run. To compare rows, expand this run in "
    "the list with the plus sign on its left, select rows and press *Compare*, or see *Model metrics* here. "
    "{metrics} *Artifacts* has the table as CSV, Markdown and LaTeX, {chart}and the confusion matrices.\n"
)
_ACCURACIES = (
    "`accuracy` is the mean over places, seeds and homes, in percent; for one home, it is `accuracy/home_1` "
    "in a row and `home_1` here. `log_loss` (nats), `calibration_error` and `stay_accuracy` (percent) "
    "measure the quality of the probabilities, averaged over the homes."
)
_CHART = "`chart.png` with the averages (one mark per {point}), "
_FIGURES = (
    "The figures of the thesis with their original numbers, and additional figures, all drawn from the data "
    "and models of this run.\n\n"
)


def table_run(
    table: Mapping[str, Any],
    cells: pd.DataFrame,
    results: Results,
    dataset: Mapping[str, Any],
    settings: Mapping[str, str],
    written: Sequence[Path],
    made: Callable[[str], Made],
) -> TableRun:
    """Gather the contents of the run for one table from its definition and its filled `cells`.

    `dataset` describes the data behind the table (:func:`placecat.thesis.tables.dataset_of`). `settings` are
    the settings that affect its numbers, by dotted name. `written` lists the table's files, such as its CSV.
    `made` takes the name of a result and describes how it was made.
    """
    # The title of an addition already starts with this label.
    title = f"{label(table)}: {table['title'].removeprefix(f'{label(table)}: ')}"
    beside = comparable(table, dataset)
    decisions = decisions_of(table, results)
    quality = _quality(table, results)
    rows = []
    for (group, row), part in cells.groupby(["group", "row"], sort=False):
        labels = (str(group), str(row))
        how = {name: made(name) for name in _results(table, labels, part["column"], results)}
        rows.append(_row_run(table, labels, part, decisions.get(labels, {}), quality.get(labels, {}), how))
    by_cell = {
        (*labels, column): one for labels, of_row in decisions.items() for column, one in of_row.items()
    }
    counts = [repr(score_rows("/".join(labels), one)) for labels, one in by_cell.items()]

    def write(folder: Path) -> list[Path]:
        paths = list(written)
        with house_style():
            if in_percent(table) and (chart := accuracy_chart(title, cells, published=beside)):
                save(chart, folder / "chart.png")
                paths.append(folder / "chart.png")
        if draw_sheet(folder / "confusion.png", title, decisions):
            paths.append(folder / "confusion.png")
        matrices = [
            pooled_rows(one).assign(group=group, row=row, column=column)
            for (group, row, column), one in by_cell.items()
        ]
        return [*paths, *_write_counts(folder, matrices, ["group", "row", "column", "truth"])]

    return TableRun(
        name=table["name"],
        title=title,
        content="\n".join([cells[COLUMNS].to_csv(index=False), *counts, repr(sorted(quality.items()))]),
        params=settings,
        metrics=_metrics(cells, in_percent(table))
        | {key(measure, *labels): value for labels, row in quality.items() for measure, value in row.items()},
        description=_description(table, cells, dataset, beside),
        rows=rows,
        files=write,
    )


def figures_run(folder: Path) -> TableRun:
    """Build one run from a folder of figures written by the `figures` stage."""
    entries = files.read_json(folder / "figures.json")
    drawn = [folder / Path(entry["file"]).name for entry in entries if entry["file"]]
    lines = [
        ("- **Addition.** " if entry["number"] is None else f"- **Figure {entry['number']}.** ")
        + (entry["title"] if entry["file"] else f"Left out: {entry['reason']}")
        for entry in entries
    ]
    sums = [files.checksum(path) for path in drawn]
    return TableRun(
        name="figures",
        title="Figures of the thesis",
        content="\n".join([*lines, *sums]),
        params={"figures": ", ".join(entry["name"] for entry in entries if entry["file"])},
        metrics={"drawn": len(drawn), "left_out": len(entries) - len(drawn)},
        description=_cut(_FIGURES + "\n".join(lines)),
        files=lambda temporary: drawn,
        kind="figures",
    )


def findings_run(findings: Path, comparisons: Path) -> TableRun:
    """Gather the files of the `findings` stage into one run, with a metric for each verdict and reading."""
    table = files.read_table(findings, ["claim"])
    readings = readings_of(table)
    names = [name.replace("_", " ") for name in readings.values()]
    rows = table.fillna("")[["number", "claim", "verdict", *readings]].astype(str).to_numpy().tolist()
    head, *lines = (f"| {' | '.join(row)} |" for row in [["No.", "Finding", "Verdict", *names], *rows])
    lines = [head, "|---:" + "|---" * (2 + len(names)) + "|", *lines]
    metrics = {
        key(name, verdict): float((table[column] == verdict).sum())
        for column, name in ({"verdict": "as_used"} | readings).items()
        for verdict in VERDICTS
    }
    return TableRun(
        name="findings",
        title="Findings of the thesis",
        content="\n".join(path.read_text(encoding="utf-8") for path in (findings, comparisons)),
        params={"findings": str(len(table))},
        metrics=metrics,
        description=_cut("\n".join(lines) + "\n"),
        files=lambda temporary: [findings, comparisons],
        kind="findings",
    )


def _row_run(
    table: Mapping[str, Any],
    labels: tuple[str, str],
    cells: pd.DataFrame,
    decisions: Mapping[str, Measured],
    quality: Mapping[str, float],
    how: Mapping[str, Made],
) -> RowRun:
    # The name includes the table, since MLflow's list mixes runs of many tables.
    of_table = table["name"].replace("_0", "_").replace("_", " ").capitalize()
    name = ": ".join(filter(None, (of_table, ", ".join(filter(None, labels)))))
    shown = {"table": label(table), "group": labels[0], "row": labels[1], "result": ", ".join(how)}
    measured = cells[np.isfinite(cells["measured"])]
    columns = [_measure(column, in_percent(table)) for column in measured["column"]]
    return RowRun(
        name=name,
        params={key: text for key, text in shown.items() if text} | params_of_results(how),
        metrics=dict(zip(columns, measured["measured"], strict=True)) | dict(quality),
        description="\n".join(f"- `{result}`: {one.title}" for result, one in how.items()),
        files=lambda folder: _write_row(folder, name, decisions),
    )


def _write_row(folder: Path, name: str, decisions: Mapping[str, Measured]) -> list[Path]:
    if not decisions:
        return []
    draw_matrices(folder / "confusion.png", name, decisions)
    labels = ["column", "home", "seed", "truth"]
    parts = [confusion_rows(one).assign(column=column) for column, one in decisions.items()]
    if list(decisions) == [""]:
        labels, parts = labels[1:], [one.drop(columns="column") for one in parts]
    return [folder / "confusion.png", *_write_counts(folder, parts, labels)]


def _write_counts(folder: Path, parts: Sequence[pd.DataFrame], labels: list[str]) -> list[Path]:
    """Write all counts to one file, label columns first.

    Returns a list with the path of the file, or an empty list if there are no counts.
    """
    if not parts:
        return []
    whole = pd.concat(parts)
    path = folder / "counts.csv"
    files.write_csv(path, whole[[*labels, *whole.columns.difference(labels, sort=False)]])
    return [path]


def _results(
    table: Mapping[str, Any], labels: tuple[str, str], columns: Iterable[str], results: Results
) -> list[str]:
    """Return the names of the results that a row shows."""
    if "result" in table:
        return [table["result"]]
    if "rows" in table:
        return [row["result"] for row in table["rows"] if (row["group"], row["row"]) == labels]
    names = []
    for column in columns:
        cell = zip(AXES, (*labels, column), strict=True)
        own = ("" if table["axes"].get(axis) == HOMES else part for axis, part in cell)
        names.append(trial_name(table["name"], *own))
    return [name for name in dict.fromkeys(names) if name in results.measured]


def _quality(table: Mapping[str, Any], results: Results) -> dict[tuple[str, str], dict[str, float]]:
    """Map each (group, row) to the quality of its probabilities.

    If the entire table shows one result, the only key is ("", ""). The mapping is empty for tables that
    already show these numbers, and for trials, which have none.
    """
    if not in_percent(table):
        return {}
    named = {(row["group"], row["row"]): row["result"] for row in table.get("rows", [])}
    named |= {("", ""): table["result"]} if "result" in table else {}
    return {
        labels: results.quality[name].averages() for labels, name in named.items() if name in results.quality
    }


def _metrics(cells: pd.DataFrame, percent: bool) -> dict[str, float]:
    """Return the metrics of a table by name.

    Names start with the column, so that MLflow charts the averages of all rows in one section. Averages come
    first, since the user interface preserves the order.
    """
    measured = cells[np.isfinite(cells["measured"])]
    measured = measured.sort_values("column", key=lambda column: column != AVERAGE, kind="stable")
    rows = measured[["group", "row", "column", "measured"]].itertuples(index=False, name=None)
    return {key(_section(column, percent), group, row): float(value) for group, row, column, value in rows}


def _measure(column: str, percent: bool) -> str:
    """Return the name of a metric: ``accuracy/home_1`` for "Home 1", or ``home_1`` if not in percent."""
    section = _section(column, percent)
    return key("accuracy", section) if percent and section != "accuracy" else section


def _section(column: str, percent: bool) -> str:
    """Return the section for the metrics of a column: ``home_1`` for "Home 1", ``accuracy`` for "Average"."""
    if percent and column in (AVERAGE, ""):
        return "accuracy"
    return key(column).lower().replace(" ", "_")


def _description(
    table: Mapping[str, Any], cells: pd.DataFrame, dataset: Mapping[str, Any], beside: bool
) -> str:
    if not beside:
        about_ours = cells["notes"].map(
            lambda notes: tuple(one for one in notes if not one.is_about_the_published)
        )
        cells = cells.assign(published=np.nan, notes=about_ours)
    chart, reading = "", _READING.format(metrics="", chart="")
    if in_percent(table):
        point = "home" if table["layout"] != "pooled_by_class" else "place"
        chart = f"![Chart of the averages](get-artifact?path=chart.png&run_uuid={RUN_ID})\n"
        reading = _READING.format(metrics=_ACCURACIES, chart=_CHART.format(point=point))
    # Omit the heading, since it repeats the name of the run.
    text = table_markdown(table, cells, dataset).partition("\n")[2].lstrip()
    return _cut(f"{text}\n{chart}{reading}")


def _cut(text: str) -> str:
    """Cut a description after the last line that fits within MLflow's limit."""
    if len(text) <= _LONGEST_DESCRIPTION:
        return text
    return text[: text.rindex("\n", 0, _LONGEST_DESCRIPTION - 40)] + "\n\n*The rest is in the artifacts.*\n"
