"""The pictures of a table's runs in MLflow, as files."""

from collections.abc import Mapping
from pathlib import Path

import pandas as pd

from placecat.drawing.style import house_style, save
from placecat.report.charts.accuracy import accuracy_chart
from placecat.report.charts.matrices import draw_sheet
from placecat.results.measured import Measured


def draw_table(
    folder: Path,
    title: str,
    cells: pd.DataFrame,
    rows: Mapping[tuple[str, str], Mapping[str, Measured]],
    *,
    published: bool,
    chart: bool = True,
) -> list[Path]:
    """Write ``chart.png`` and ``confusion.png`` of a table, if it has any, and give their paths.

    See `accuracy_chart` and `draw_sheet`. A table whose numbers are no percentages has no `chart`.
    """
    written = []
    with house_style():
        if chart and (bars := accuracy_chart(title, cells, published=published)) is not None:
            save(bars, folder / "chart.png")
            written.append(folder / "chart.png")
    if draw_sheet(folder / "confusion.png", title, rows):
        written.append(folder / "confusion.png")
    return written
