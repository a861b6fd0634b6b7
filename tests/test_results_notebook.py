"""Execute docs/results.ipynb."""

import json

import pytest

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
    assert len(names["table_26"]) == 36
    assert names["table_26"]["measured"].notna().all()
