import json
from pathlib import Path

import pytest
import yaml

import made_run
from placecat.errors import PlacecatError
from placecat.report import figures
from placecat.stages import figures as stage


@pytest.fixture
def project(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    params = made_run.parameters()
    made_run.build(tmp_path, params)
    # The other figures need all frames.
    monkeypatch.setattr(
        figures, "names", lambda: ["figure_02", "figure_11", "figure_19", "figure_reliability"]
    )
    names = ("example", "clusters", "figure_11", "figure_19", "figure_reliability")
    own = {name: params["figures"][name] for name in names}
    return params | {"figures": own}


def save(params):
    Path("params.yaml").write_text(yaml.safe_dump(params), encoding="utf-8")


def test_missing_data_leave_out_a_figure_with_a_reason(project, tmp_path):
    save(project)
    stage.main()
    entries = json.loads((tmp_path / "reports/figures/figures.json").read_text())
    assert [entry["number"] for entry in entries] == [2, 11, 19, None]
    assert [entry["name"] for entry in entries] == figures.names()
    assert [entry["file"] for entry in entries] == ["figure_02.png", None, "figure_19.png", None]
    assert "was not computed" in entries[1]["reason"] and entries[0]["reason"] is None
    assert entries[2]["title"] == figures.caption("figure_19")
    written = {path.name for path in (tmp_path / "reports/figures").iterdir()}
    assert written == {
        *(f"figure_{name}" for name in ("02.pdf", "02.png", "19.pdf", "19.png")),
        "figures.json",
    }
    pdf = (tmp_path / "reports/figures/figure_19.pdf").read_bytes()
    assert b"/Subject (figures.figure_19." in pdf
    assert b"; dataset.name=" in pdf
    assert b"CreationDate" not in pdf


def test_an_invalid_setting_stops_the_stage(project, tmp_path):
    project["figures"]["figure_19"]["filter"] = "share"
    project["filters"]["share"] = {"threshold": None, "share": 0.1, "cues": [], "systems": []}
    save(project)
    with pytest.raises(PlacecatError, match="the filter share has no threshold"):
        stage.main()
    assert not (tmp_path / "reports/figures").exists()
