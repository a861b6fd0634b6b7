"""The page that shows two runs side by side, from made-up runs."""

import json
import re
from pathlib import Path

import pandas as pd
import pytest

import made_report
from browser import evaluate, needs_chromium
from placecat import files, paths
from placecat.compare.kept_in_git import Figures, Kept, read_figures
from placecat.compare.page import page_html, write
from project import run

NAMES = ({"name": "git v1", "about": "abc1234, 2026-01-01: <first>"}, {"name": "this folder", "about": ""})


def side(*, hmm="50.0", verdict="holds", nu=0.2, workers=1):
    tables = {
        "table_26": pd.DataFrame(
            {"group": "5-5-1", "row": ["Gist", "HMM"], "column": "Home 1", "measured": ["30.0", hmm]}
        ),
        "table_01": pd.DataFrame(
            {"group": [""], "row": ["<i>"], "column": ["Average"], "measured": ["20.5"]}
        ),
        "in_text": pd.DataFrame(
            {"name": ["gist"], "quantity": ["colour"], "home": ["Home 6"], "measured": ["1.0"]}
        ),
    }
    findings = pd.DataFrame(
        {"number": ["1", "2"], "claim": ["One & all.", "Two."], "verdict": [verdict, "holds"]}
    )
    settings = {
        "cues": {"gist": {"nu": nu}},
        "compute": {"workers": workers},
        "dataset": {"title": "made homes"},
    }
    return Kept(tables, findings, settings)


def figures(*seeds):
    pictures = {
        f"figure_{number:02d}": made_report.png(seed=seed) for number, seed in enumerate(seeds, start=2)
    }
    return Figures(pictures, {name: f"Caption of {name}." for name in pictures})


@pytest.fixture
def outside(tmp_path, monkeypatch):
    """A folder without a project's table definitions, so no table has a title."""
    monkeypatch.chdir(tmp_path)
    for name in (paths.TABLE_DEFINITIONS, paths.FINDING_DEFINITIONS):
        name.mkdir(parents=True)
    files.write_text(paths.IN_TEXT_DEFINITIONS, "gist: {}\n")


def text_of(html):
    return re.sub(r"\s+", " ", re.sub(r"<[^>]*>", "", html))


def test_only_differing_cells_show_both_values(outside):
    old, new = side(hmm="47.5", verdict="undecided", nu=0.1, workers=2), side()
    html = page_html(NAMES, (old, new), (figures(0, 1), figures(0, 2, 3)), ["Said first."])
    assert (
        '<td class="above-1 changed" data-value="50.00" title="+2.50 points"><del>47.50</del> <ins>50.00'
        in html
    )
    assert html.count("<del>") == html.count("<ins>") == 2  # one of them in the explanation
    assert re.findall(r'<section class="table" id="([^"]*)"', html)[-1] == "table-26"
    assert '<code>cues.gist.nu</code></th><td class="words"><code>0.1</code></td>' in html
    assert "compute.workers" not in html
    assert 'id="finding-1"' in html and 'id="finding-2"' not in html
    assert re.findall(r'<figure id="([^"]*)"', html) == ["figure-3", "figure-4"]
    assert html.count("<img") == 3
    said = text_of(html)
    assert "Differences: settings 1, verdicts 1, tables 1 (cells 1), figures 2." in said
    assert "Unchanged: table 01; Numbers in the thesis’s text." in said.replace("table_01", "table 01")
    assert "Said first." in said and "&lt;first&gt;" in html and "<first>" not in html
    assert re.findall(r'(?:src|href)="(?!#|data:)[^"]*"', html) == []


def test_equal_runs_show_no_differences(outside):
    html = page_html(NAMES, (side(), side()), (figures(0), figures(0)), [])
    assert "<figure" not in html and 'class="table"' not in html
    assert "No settings differ." in html and "No verdicts differ." in html


@needs_chromium
@pytest.mark.parametrize("width", [390, 1300])
def test_the_page_fits_the_window_and_logs_nothing(outside, tmp_path, width):
    target = tmp_path / "page.html"
    drawn = figures(0), Figures(missing="run that")
    target.write_text(page_html(NAMES, (side(hmm="47.5"), side()), drawn, []), encoding="utf-8")
    found, console = evaluate(
        target,
        tmp_path,
        "return [document.documentElement.scrollWidth, document.querySelector('.tools').hidden,"
        "document.querySelector('#figures').textContent];",
        width=width,
    )
    assert console == []
    assert found[0] <= width
    assert found[1] is False
    assert "Figures are not compared: run that." in found[2]


def test_figures_are_read_from_a_folder(tmp_path):
    (tmp_path / paths.TABLES).mkdir(parents=True)
    assert "run `dvc repro figures` in that project" in read_figures(str(tmp_path)).missing
    folder = tmp_path / paths.FIGURES
    folder.mkdir()
    entries = [
        {"name": "figure_02", "file": "figure_02.png", "title": "Two."},
        {"name": "figure_03", "file": None, "title": "Three."},
    ]
    (folder / "figures.json").write_text(json.dumps(entries))
    (folder / "figure_02.png").write_bytes(b"png")
    assert read_figures(str(tmp_path)) == Figures({"figure_02": b"png"}, {"figure_02": "Two."})


@pytest.mark.slow
def test_figures_of_a_revision_come_from_the_cache(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    paths.FIGURES.mkdir(parents=True)
    (paths.FIGURES / "figures.json").write_text(
        json.dumps([{"name": "figure_02", "file": "figure_02.png", "title": "Two."}])
    )
    (paths.FIGURES / "figure_02.png").write_bytes(b"first")
    run(tmp_path, "git", "init", "-q")
    run(tmp_path, "dvc", "init", "-q")
    run(tmp_path, "dvc", "add", "-q", paths.FIGURES.as_posix())
    run(tmp_path, "git", "add", "-A")
    run(tmp_path, "git", "-c", "user.name=a", "-c", "user.email=a@b", "commit", "-q", "-m", "figures")
    (paths.FIGURES / "figure_02.png").unlink()
    assert read_figures("HEAD").pictures == {"figure_02": b"first"}
    for path in Path(".dvc/cache/files").rglob("*"):
        if path.is_file():
            path.unlink()
    missing = read_figures("HEAD").missing
    assert "DVC has no figures for git HEAD" in missing and "placecat repro" in missing


def test_the_page_does_not_overwrite_a_folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "page").mkdir()
    with pytest.raises(files.PlacecatError, match="page is a folder: specify a file name"):
        write(Path("page"), "", "", [])
