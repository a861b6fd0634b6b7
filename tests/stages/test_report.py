"""The stage `report` on generated reports."""

import json
import re
import shutil
from pathlib import Path

import pandas as pd
import pytest

import made_report
from placecat import files, paths, results, settings
from placecat.errors import PlacecatError
from placecat.provenance.lines import lines_of
from placecat.stages import report
from placecat.thesis import in_text, notes
from placecat.thesis.tables import tables_of

LOCK = "stages:\n  sequences:\n    outs:\n    - md5: 00ff.dir\n"


@pytest.fixture(scope="module")
def prepared(tmp_path_factory):
    """Prepare a folder with everything that the stage reads."""
    folder = tmp_path_factory.mktemp("prepared")
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(folder)
        prepare()
    return folder


def copied(folder, destination):
    """Make a copy that may be changed; `conf` and the data of the thesis remain links."""
    return shutil.copytree(folder, destination, symlinks=True)


@pytest.fixture
def folder(prepared, tmp_path, monkeypatch):
    """A copy of the prepared folder as the current folder."""
    copy = copied(prepared, tmp_path / "copy")
    monkeypatch.chdir(copy)
    return copy


def run_in(folder):
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(folder)
        report.main()
    return folder


@pytest.fixture(scope="module")
def written(prepared, tmp_path_factory):
    """A folder in which the stage has run; tests do not change it."""
    return run_in(copied(prepared, tmp_path_factory.mktemp("written") / "copy"))


@pytest.fixture(scope="module")
def changed(prepared, tmp_path_factory):
    """A folder in which the stage has run with recorded times and without the first figure."""
    folder = copied(prepared, tmp_path_factory.mktemp("changed") / "copy")
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(folder)
        times = pd.DataFrame({"stage": ["sequences", "toy"], "runs": [1, 2], "seconds": [61.04, 2.0]})
        files.write_csv(paths.KEPT_TIMES, times)
        facts = {"data": "rendered homes", "stages": 2, "cores": 2, "total": 150.0}
        files.write_json(paths.KEPT_TIMES_FACTS, facts)
        entries = json.loads((paths.FIGURES / "figures.json").read_text())
        files.write_json(paths.FIGURES / "figures.json", entries[1:])
    return run_in(folder)


def prepare():
    """Write everything that the stage reads to the current folder."""
    paths.PARAMS.write_text((made_report.ROOT / "params.yaml").read_text())
    for name in ("conf", "data/thesis"):
        Path(name).parent.mkdir(exist_ok=True)
        Path(name).symlink_to(made_report.ROOT / name)
    Path("dvc.lock").write_text(LOCK)
    params = settings.load()
    for home in params["dataset"]["homes"]:
        files.write_csv(paths.SEQUENCES / home / "labels.csv", pd.DataFrame({"class": [0, 0, 1, -1]}))
    noted, origins = [], {}
    for name, table in tables_of(params).items():
        number = table["number"]
        cells = made_report.addition().cells if number is None else made_report.cells(number)
        files.write_csv(paths.TABLES / f"{name}.csv", cells.drop(columns="notes"))
        noted.append(notes.to_rows(name, cells))
        origins[name] = measured(cells, ["group", "row", "column"])
    figures = [
        {"name": "figure_02", "number": 2, "file": "figure_02.png", "title": "Two", "reason": None},
        {
            "name": "figure_20",
            "number": 20,
            "file": None,
            "title": "Twenty",
            "reason": "there is no university",
        },
        {
            "name": "figure_more",
            "number": None,
            "file": "figure_02.png",
            "title": "More.",
            "reason": None,
        },
    ]
    files.write_json(paths.FIGURES / "figures.json", figures)
    (paths.FIGURES / "figure_02.png").write_bytes(made_report.png())
    said = made_report.in_text()
    files.write_csv(paths.IN_TEXT, said.drop(columns="notes"))
    noted.append(notes.to_rows(in_text.NAME, said, in_text.KEY))
    files.write_csv(paths.NOTES, pd.concat(noted))
    files.write_json(paths.ORIGINS, origins | {in_text.NAME: measured(said, in_text.KEY)})
    files.write_csv(paths.FINDINGS, made_report.findings())
    files.write_csv(paths.COMPARISONS, made_report.comparisons())


def measured(cells, key):
    """Return cell origins as the stage `tables` writes them; each cell comes from one cue without seeds."""
    return [
        {
            "cell": labels,
            "values": [value],
            "seeds": ["no-seed"],
            "origins": [["cues/gist/5-5-1", ["home_1"], ""]],
        }
        for *labels, value in cells[[*key, "measured"]].itertuples(index=False, name=None)
    ]


def page(folder):
    return (folder / paths.PAGE).read_text(encoding="utf-8")


def test_it_reads_everything_and_writes_the_page(written):
    text = page(written)
    assert re.findall(r'<section class="table" id="table-(\d+)"', text) == [str(n) for n in range(1, 32)]
    assert '<figure id="figure-2">\n<div class="sheet"><img src="data:image/' in text
    assert "Not drawn: there is no university." in text
    assert '<figure id="addition-figure-more">\n<div class="sheet"><img src="data:image/' in text
    assert "<b>Addition</b> More." in text
    assert text.count('<a href="figures/figure_02.pdf">PDF</a>') == 2
    assert (
        '<th scope="row">Home 1: home_1</th><td>2</td><td>1</td><td>0</td><td>0</td><td>0</td><td>1</td>'
        in text
    )
    assert "<code>00ff.dir</code>" in text
    # Text that looks like a number remains text.
    assert '<td class="f-section">4.10</td>' in text
    assert "<span>4.10 flat k means<" in text
    assert 'colspan="2">0.1</th>' in text
    assert "No times are stored" in text
    assert not re.search(r">\s*(?:nan|None)\s*<", text)


def test_a_kept_record_of_times_is_shown(changed):
    assert "run on rendered homes, which took 2 min 30 s on 2 cores" in page(changed)
    assert '<tr><th scope="row">sequences</th><td>1</td><td>61.0</td></tr>' in page(changed)


def test_the_bytes_are_the_same_and_empty_times_count_as_missing(written, folder):
    files.write_csv(paths.KEPT_TIMES, pd.DataFrame(columns=["stage", "runs", "seconds"]))
    files.write_json(paths.KEPT_TIMES_FACTS, {"data": "rendered homes", "cores": 2, "total": 0.0})
    report.main()
    assert "No times are stored" in page(folder)
    for path in (paths.PAGE, paths.RESULTS, paths.EXPLANATIONS):
        assert path.read_bytes() == (written / path).read_bytes()


@pytest.mark.parametrize("path", [paths.FINDINGS, paths.IN_TEXT, paths.TABLES / "table_07.csv"])
def test_missing_inputs_are_named(folder, path):
    path.unlink()
    with pytest.raises(PlacecatError, match=f"{path} is missing: run `dvc repro`"):
        report.main()


@pytest.mark.slow
def test_a_missing_figure_or_list_is_named(folder):
    (paths.FIGURES / "figure_02.png").unlink()
    with pytest.raises(PlacecatError, match=r"figure_02\.png is missing"):
        report.main()
    (paths.FIGURES / "figures.json").unlink()
    with pytest.raises(PlacecatError, match=r"figures\.json is missing"):
        report.main()


def test_figures_match_the_list(written, changed):
    assert 'figure-2"' in page(written)
    assert 'figure-2"' not in page(changed)


def test_every_number_has_an_explanation(written, monkeypatch):
    monkeypatch.chdir(written)
    table = results.load()
    cells = sum(len(pd.read_csv(path)) for path in paths.TABLES.glob("*.csv"))
    assert len(table) == cells + len(pd.read_csv(paths.IN_TEXT))
    assert table["cell"].is_unique
    one = table[table["cell"] == "table_26.9.3"].iloc[0]
    assert (one["group"], one["row"], one["column"]) == ("4-5-1, all cues", "HMM", "Home 3")
    assert (one["cues"], one["plan"], one["tested_frames"]) == ("gist", "5-5-1", 3)
    content = files.read_json(paths.EXPLANATIONS)
    assert list(content["cells"]) == list(table["cell"])
    said = dict(lines_of(content, "table_26.9.3"))
    assert said["data"].endswith("checksum 00ff.dir")
    assert said["tested on"] == "3 frames of home_1"
