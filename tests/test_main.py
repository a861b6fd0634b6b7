import json
import shutil
import subprocess

import pytest

from placecat import settings
from placecat.__main__ import main
from placecat.errors import PlacecatError
from placecat.stages import sequences
from project import ROOT, commit, init, light_conf, run

# One worker runs all of these tests, so that their small project runs only once.
pytestmark = pytest.mark.xdist_group("main")


@pytest.fixture
def folder(tmp_path, monkeypatch):
    light_conf(tmp_path / "conf")
    monkeypatch.chdir(tmp_path)
    return tmp_path


def test_params_writes_the_composed_settings(folder):
    main(["params", "smoothing.delay_seconds=0.5"])
    assert settings.load()["smoothing"]["delay_seconds"] == 0.5


def test_params_without_overrides_are_the_committed_ones(folder):
    shutil.rmtree(folder / "conf")
    shutil.copytree(ROOT / "conf", folder / "conf")
    # The command writes the list again.
    (folder / "conf/found.yaml").unlink()
    main(["params"])
    assert (folder / "conf/found.yaml").read_text() == (ROOT / "conf/found.yaml").read_text()
    assert (folder / "params.yaml").read_text() == (ROOT / "params.yaml").read_text()


def test_a_user_error_ends_with_one_message(folder):
    with pytest.raises(SystemExit) as caught:
        main(["params", "smoothing.delay_secondss=0.5"])
    assert str(caught.value).startswith("placecat: the settings cannot be composed: ")
    assert not (folder / "params.yaml").exists()


def test_outside_the_project_it_says_so(tmp_path):
    result = run(tmp_path, "placecat", "params", check=False)
    assert result.returncode == 1
    assert "run placecat in the project folder" in result.stderr
    assert "Traceback" not in result.stderr


def test_a_missing_data_set_stops_the_first_stage(folder):
    main(["params", "dataset=my_homes", "dataset.root=nowhere"])
    with pytest.raises(PlacecatError, match=r"dataset\.root is nowhere, but this folder does not exist"):
        sequences.main()


@pytest.mark.parametrize(
    "command",
    ["", "params", "repro", "compare", "times", "train", "predict", "demo", "explain", "import panoramas"],
)
def test_every_command_has_help(command, capsys):
    with pytest.raises(SystemExit) as caught:
        main([*command.split(), "--help"])
    assert caught.value.code == 0
    text = capsys.readouterr().out
    assert text.startswith(f"usage: placecat {command}".strip())
    assert {
        "": "compare",
        "params": "OVERRIDE",
        "repro": "--force",
        "compare": "REVISION",
        "times": "--keep",
        "train": "--without HOME",
        "predict": "--labels CSV",
        "demo": "predictions/demo",
        "explain": "--again",
        "import panoramas": "DESTINATION",
    }[command] in text


def test_without_a_model_predict_says_how_to_make_one(folder):
    with pytest.raises(SystemExit) as caught:
        main(["predict", "walk.mp4"])
    message = "the model data/model.placecat is missing: create one with `make repro` or `placecat train`"
    assert str(caught.value).startswith("placecat: ")
    assert message in str(caught.value)
    assert "\n" not in str(caught.value)


# A quick pipeline with a stage that loops over homes, and a stage that writes two tables.
CONF = """
dataset:
  name: made
  title: made homes
  thesis_data: null
  layout: vpc2009
  root: homes
  homes: [a, b]
  fps: null
  camera: made
  classes: [kitchen, bedroom]
  ignored: []
  aliases: {}
  require_all_classes: true
probabilities: {bins: 10, smallest: 0.1}
reproducibility: {tolerance: 2.0}
"""
PIPELINE = """
stages:
  render:
    cmd: python render.py
    frozen: true
    outs: [{videos: {cache: false, persist: true}}]
  features:
    cmd: python features.py
    deps: [features.py]
    params: [dataset.homes]
    outs: [data/features]
  tables:
    cmd: python tables.py
    deps: [data/features, measured.txt, tables.py]
    params: [probabilities, dataset]
    outs: [{reports/tables: {cache: false}}]
"""
FEATURES = """
import time
from pathlib import Path

from placecat import settings
from placecat.files import write_text
from placecat.stages import run


def main():
    \"\"\"Describe the homes.\"\"\"
    time.sleep(0.4)
    for home in settings.load()["dataset"]["homes"]:
        write_text(Path(f"data/features/{home}.txt"), home)


run(main)
"""
TABLES = """
from pathlib import Path

from placecat import settings
from placecat.errors import PlacecatError
from placecat.files import replacing, write_text
from placecat.stages import run

HEAD = "table,group,row,column,published,measured,spread,seeds,note"


def main():
    \"\"\"Write the tables.\"\"\"
    params = settings.load()
    measured = float(Path("measured.txt").read_text()) + (params["probabilities"]["bins"] - 10)
    if measured < 0:
        raise PlacecatError("nothing was measured")
    note = f"measured on {params['dataset']['title']}"
    with replacing(Path("reports/tables")) as folder:
        for number, value in ((26, measured), (5, 40.0)):
            row = f"{number},,Gist,Home 1,30.0,{value},,0,{note}"
            write_text(folder / f"table_{number:02d}.csv", f"{HEAD}\\n{row}\\n")
        text = f"# Table 26\\n\\n| Gist | {measured} |\\n\\n## Published\\n\\n| Gist | 30.0 |\\n"
        write_text(folder / "table_26.md", text)


run(main)
"""


@pytest.fixture(scope="module")
def ran(tmp_path_factory):
    """A small project after a complete `placecat repro`, before the first commit."""
    folder = tmp_path_factory.mktemp("ran")
    (folder / "conf").mkdir()
    for name, text in {
        "conf/config.yaml": CONF,
        "dvc.yaml": PIPELINE,
        "features.py": FEATURES,
        "tables.py": TABLES,
        "measured.txt": "31.2\n",
        "videos": "",
        ".gitignore": "/data\n",
    }.items():
        (folder / name).write_text(text)
    init(folder)
    return folder, placecat(folder, "repro")


@pytest.fixture
def committed(ran, tmp_path):
    """A copy of the project with everything in git."""
    folder = tmp_path / "copy"
    shutil.copytree(ran[0], folder, symlinks=True)
    commit(folder)
    return folder


def placecat(folder, *arguments, **extra):
    return run(folder, "python", "-m", "placecat", *arguments, check=False, **extra)


@pytest.fixture
def inside(committed, monkeypatch, capsys):
    """Return a function that runs `placecat` in this process, which is faster than starting one."""

    def call(*arguments, folder=committed):
        monkeypatch.chdir(folder)
        capsys.readouterr()
        status = 0
        try:
            main(arguments)
        except SystemExit as end:
            status = end.code
        out, err = capsys.readouterr()
        if isinstance(status, str):
            # Python does the same.
            status, err = 1, f"{err}{status}\n"
        return subprocess.CompletedProcess(arguments, status, out, err)

    return call


def refused(result, message):
    assert result.returncode == 1
    assert result.stderr.startswith("placecat: ")
    assert message in result.stderr
    assert len(result.stderr.splitlines()) == 1


def test_the_first_run_has_table_26_and_times_and_nothing_to_compare_with(ran):
    folder, result = ran
    assert result.returncode == 0, result.stderr
    assert "# Table 26\n\n| Gist | 31.2 |\n\nAll tables: reports/tables" in result.stdout
    times = result.stdout.partition("Times of the stages that ran:\n")[2].split("\n\n")[0].splitlines()
    assert {line.split("  ")[1] for line in times[:2]} == {"features", "tables"}
    assert [line.split("  ")[1] for line in times[2:]] == ["2 stages", "DVC and the rest", "all"]
    assert "Tables are not compared: git has no revision 'HEAD'" in result.stdout
    lines = (folder / "data/times.csv").read_text().splitlines()
    assert {line.partition(",")[0] for line in lines[:3]} == {"stage", "features", "tables"}
    complete = json.loads((folder / "data/times.json").read_text())
    assert complete["facts"]["stages"] == 2
    assert complete["facts"]["data"] == "made homes"
    assert complete["facts"]["total"] > sum(one["seconds"] for one in complete["by_stage"]) >= 0.4


def test_a_second_run_changes_nothing_and_runs_no_stage(committed):
    before = (committed / "data/times.json").read_bytes()
    result = placecat(committed, "repro")
    assert result.returncode == 0, result.stderr
    assert "Times: no stage had to run; " in result.stdout
    assert result.stdout.endswith("Tables: 2 of 2 cells match the old ones (git HEAD).\n")
    assert (committed / "data/times.json").read_bytes() == before


def test_a_partial_run_times_its_stages_and_tolerates_small_differences(committed):
    (committed / "measured.txt").write_text("31.5\n")
    before = (committed / "data/times.json").read_bytes()
    result = placecat(committed, "repro")
    assert result.returncode == 0, result.stderr
    assert "\n  1 stage " in result.stdout
    assert "features" not in result.stdout.partition("Times of the stages")[2]
    assert "largest difference 0.30 points in Table 26 (Gist, Home 1), within the tolerance" in result.stdout
    assert (committed / "data/times.json").read_bytes() == before
    assert (committed / "data/times.csv").read_text().startswith("stage,seconds\ntables,")


def test_a_large_difference_ends_with_status_3_until_it_is_kept(committed, inside):
    (committed / "measured.txt").write_text("36.2\n")
    result = placecat(committed, "repro")
    assert result.returncode == 3
    assert "largest difference 5.00 points in Table 26 (Gist, Home 1), beyond the tolerance" in result.stdout
    assert "commit reports/" in result.stdout
    alone = inside("compare")
    assert alone.returncode == 3
    assert result.stdout.endswith(alone.stdout)
    commit(committed)
    assert inside("compare").returncode == 0
    assert inside("compare", "HEAD~1").returncode == 3


def test_changed_settings_are_not_a_failure(committed):
    result = placecat(committed, "repro", "probabilities.bins=17")
    assert result.returncode == 0, result.stderr
    assert "1 of 2 cells match" in result.stdout
    assert "Settings differ: probabilities.bins. Expect differences." in result.stdout


def test_a_failed_run_shows_neither_times_nor_tables(committed):
    (committed / "measured.txt").write_text("-1\n")
    result = placecat(committed, "repro")
    assert result.returncode not in (0, 3)
    assert "placecat: nothing was measured" in result.stderr
    for text in ("Times", "Table 26", "Tables:"):
        assert text not in result.stdout


def test_times_of_a_complete_run_are_shown_and_kept(committed, inside):
    result = inside("times")
    assert result.returncode == 0
    assert result.stdout.startswith("Measured on made homes, ")
    assert "  features" in result.stdout
    assert not (committed / "reports/times.csv").exists()
    inside("times", "--keep")
    assert (committed / "reports/times.csv").read_text().startswith("stage,runs,seconds\n")
    assert json.loads((committed / "reports/times.json").read_text())["stages"] == 2


def test_force_runs_everything_except_frozen_stages(committed, inside):
    shutil.rmtree(committed / "data/times")
    (committed / "data/times.json").unlink()
    refused(inside("times", "--keep"), "run `placecat repro --force`")
    result = placecat(committed, "repro", "--force")
    assert result.returncode == 0, result.stderr
    assert "\n  2 stages " in result.stdout
    assert json.loads((committed / "data/times.json").read_text())["facts"]["stages"] == 2


def test_user_errors_in_compare_give_one_message(committed, inside, tmp_path):
    refused(inside("compare", "nowhere"), "git has no revision 'nowhere'")
    shutil.copytree(committed, tmp_path / "bare", ignore=shutil.ignore_patterns(".git", ".dvc"))
    refused(inside("compare", folder=tmp_path / "bare"), "this folder is not in a git repository")
    shutil.rmtree(committed / "reports")
    refused(inside("compare"), "reports/tables has no tables: run `placecat repro`")
