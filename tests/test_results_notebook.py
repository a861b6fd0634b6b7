"""Execute docs/results.ipynb."""

import json

import pytest
from matplotlib import pyplot as plt

import made_report
from placecat import paths

NOTEBOOK = made_report.ROOT / "docs/results.ipynb"


def cells():
    return [cell for cell in json.loads(NOTEBOOK.read_text())["cells"] if cell["cell_type"] == "code"]


def test_outputs_are_stripped():
    assert all(cell["outputs"] == [] and cell["execution_count"] is None for cell in cells())


@pytest.mark.skipif(not (made_report.ROOT / paths.RESULTS).is_file(), reason="the stage report has not run")
def test_the_notebook_runs(monkeypatch):
    monkeypatch.chdir(NOTEBOOK.parent)
    monkeypatch.setenv("MPLBACKEND", "agg")
    names = {}
    for cell in cells():
        exec("".join(cell["source"]), names)
    assert len(names["table_26"]) == 18
    assert names["table_26"]["measured"].notna().all()
    _check_picture(plt.gcf())


def _check_picture(figure):
    """Check that nothing is cut off or covers the bars."""
    figure.canvas.draw()
    (axes,) = figure.axes
    legend = axes.get_legend().get_window_extent()
    assert not any(legend.overlaps(bar.get_window_extent()) for bar in axes.patches)
    for box in (legend, axes.get_tightbbox()):
        assert figure.bbox.x0 <= box.x0 < box.x1 <= figure.bbox.x1
        assert figure.bbox.y0 <= box.y0 < box.y1 <= figure.bbox.y1
