"""The pictures of a table's runs in MLflow, as files."""

from collections.abc import Mapping, Sequence
from pathlib import Path

import pandas as pd
from matplotlib import style
from matplotlib.figure import Figure

from placecat import files
from placecat.reporting.charts.accuracy import accuracy_chart
from placecat.reporting.charts.confusion import Matrices, confusion_sheet
from placecat.reporting.figures import palette
from placecat.reporting.results import Measured

# Beside the figures' modules, of which the package itself would draw in all that they use.
_STYLE = Path(palette.__file__).with_name("placecat.mplstyle")
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
    """Write ``chart.png`` and ``confusion.png`` of a table; gives the paths of what there is to show.

    Parameters
    ----------
    cells, published
        See :func:`placecat.reporting.charts.accuracy.accuracy_chart`.
    rows
        See :func:`placecat.reporting.charts.confusion.confusion_sheet`.
    chart
        False for a table whose numbers are no percentages: ``chart.png`` is left out.
    """
    written = []
    with style.context([_STYLE], after_reset=True):
        if chart and (bars := accuracy_chart(title, cells, published=published)) is not None:
            _save(bars, folder / "chart.png")
            written.append(folder / "chart.png")
    with style.context([_STYLE, _BY_HAND], after_reset=True):
        caption = "A row of a matrix is a true place, a column what was decided."
        if (sheet := confusion_sheet(f"{title}\n{caption}", rows)) is not None:
            _save(sheet, folder / "confusion.png")
            written.append(folder / "confusion.png")
    return written


class MatrixDrawer:
    """Writes the confusion matrices of one row after the other."""

    def __init__(self) -> None:
        self._sheets: dict[tuple[tuple[str, ...], int], Matrices] = {}

    def draw(self, target: Path, title: str, matrices: Mapping[str, Measured]) -> None:
        """Write one PNG.

        Parameters
        ----------
        matrices
            Caption to what was measured, one or more of the same places.
        """
        with style.context([_STYLE, _BY_HAND], after_reset=True):
            classes: Sequence[str] = next(iter(matrices.values())).classes
            kind = (tuple(classes), len(matrices))
            if kind not in self._sheets:
                self._sheets[kind] = Matrices(*kind)
            _save(self._sheets[kind].fill(title, matrices), target)


def _save(figure: Figure, target: Path) -> None:
    """As :func:`placecat.reporting.figures.save`: the same figure gives the same bytes."""
    with files.replacing(target) as temporary:
        figure.savefig(temporary, format="png", metadata={"Software": None})
