"""Picture files of a table's runs in MLflow."""

from collections.abc import Mapping, Sequence
from pathlib import Path

import pandas as pd

from placecat.drawing.style import house_style, save
from placecat.report.charts.accuracy import accuracy_chart
from placecat.report.charts.confusion import Matrices, confusion_sheet
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
    """Write ``chart.png`` and ``confusion.png`` of a table, if it has any, and return their paths.

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


class MatrixDrawer:
    """Writes the confusion matrices of one row after the other."""

    def __init__(self) -> None:
        self._sheets: dict[tuple[tuple[str, ...], int], Matrices] = {}

    def draw(self, target: Path, title: str, matrices: Mapping[str, Measured]) -> None:
        """Write one PNG of matrices of the same places, by their captions."""
        with house_style(_BY_HAND):
            classes: Sequence[str] = next(iter(matrices.values())).classes
            kind = (tuple(classes), len(matrices))
            if kind not in self._sheets:
                self._sheets[kind] = Matrices(*kind)
            save(self._sheets[kind].fill(title, matrices), target)
