"""The pictures of a table's runs in MLflow, as files."""

from collections.abc import Mapping
from pathlib import Path

import pandas as pd

from placecat.drawing.style import house_style, save
from placecat.report.charts.accuracy import accuracy_chart
from placecat.report.charts.confusion import confusion_sheet
from placecat.results.measured import Measured

_BY_HAND = {"figure.constrained_layout.use": False, "figure.dpi": 120, "savefig.dpi": "figure"}


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

    See `accuracy_chart` and `confusion_sheet`. A table whose numbers are no percentages has no `chart`.
    """
    written = []
    with house_style():
        if chart and (bars := accuracy_chart(title, cells, published=published)) is not None:
            save(bars, folder / "chart.png")
            written.append(folder / "chart.png")
    with house_style(_BY_HAND):
        caption = "A row of a matrix is a true place, a column what was decided."
        if (sheet := confusion_sheet(f"{title}\n{caption}", rows)) is not None:
            save(sheet, folder / "confusion.png")
            written.append(folder / "confusion.png")
    return written
