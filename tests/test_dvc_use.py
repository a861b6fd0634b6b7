"""DVC in typical use: a remote, and experiments with Hydra overrides."""

import csv
import json
import shutil

import pytest
import yaml

from placecat.config.compose import compose
from placecat.settings import read_yaml
from project import ROOT, commit, contents, init, light_conf, rendered, repro, run
from sketch import draw_homes

IDENTITY = {
    f"GIT_{who}_{what}": f"test{at}"
    for who in ("AUTHOR", "COMMITTER")
    for what, at in (("NAME", ""), ("EMAIL", "@example.org"))
}
OWN_HOMES = ("dataset=my_homes", "dataset.root=data/drawn", "dataset.homes=[Home1,Home2,Home3,Home4]")
# Without this option, `dvc exp show` also has columns with the checksums of dependencies.
WITHOUT_CHECKSUMS = ("--drop", r"(conf|data|reports|src)/|params\.yaml$")


@pytest.fixture(scope="module")
def clone(reproduced, tmp_path_factory):
    """A clone of the committed pipeline, with the outputs of the first run pulled from a directory."""
    folder, _, _ = reproduced
    base = tmp_path_factory.mktemp("remote")
    first, second = base / "first", base / "second"
    shutil.copytree(folder, first, symlinks=True)
    run(first, "dvc", "remote", "add", "-q", "-d", "store", "../store")
    commit(first)
    run(first, "dvc", "push", "-q")
    run(base, "git", "clone", "-q", "first", "second")
    for out in rendered():
        # In the project, the videos are in git, but git does not store the empty folders of this copy.
        (second / out).mkdir()
    assert not (second / "data/features").exists()
    run(second, "dvc", "pull", "-q")
    return first, second


@pytest.mark.xdist_group("pipeline")
def test_after_a_pull_everything_is_there_and_nothing_has_to_run(clone):
    first, second = clone
    parts = ("reports", *(path.relative_to(first).as_posix() for path in (first / "data").iterdir()))
    # Only the first folder has the times of its stages.
    pushed = {name: of for name, of in contents(first, *parts).items() if not name.startswith("data/times")}
    assert {"reports/index.html", "reports/figures/figures.json", "data/toy.csv"} <= pushed.keys()
    assert contents(second, *parts) == pushed
    ran, result = repro(second)
    assert ran == []
    assert "up to date" in result.stdout
    assert run(second, "git", "status", "--short").stdout == ""


@pytest.fixture(scope="module")
def experiments(tmp_path_factory):
    """A project in which the stage `sequences` has run on drawn homes and was committed."""
    folder = tmp_path_factory.mktemp("experiments")
    conf = light_conf(folder / "conf")
    stages = read_yaml(ROOT / "dvc.yaml")["stages"]
    (folder / "dvc.yaml").write_text(yaml.safe_dump({"stages": {"sequences": stages["sequences"]}}))
    for package in ("footage", "sequences"):
        shutil.copytree(ROOT / "src/placecat" / package, folder / "src/placecat" / package)
    (folder / "src/placecat/stages").mkdir()
    shutil.copy(ROOT / "src/placecat/stages/sequences.py", folder / "src/placecat/stages")
    (folder / ".gitignore").write_text("/data/sequences\n/data/times\n__pycache__/\n")
    draw_homes(folder / "data/drawn", homes=4, frames_per_room=2)
    (folder / "params.yaml").write_text(compose(OWN_HOMES, conf=conf))
    init(folder)
    repro(folder)
    commit(folder)
    return folder


def test_an_experiment_is_composed_run_and_shown(experiments):
    """Since `dvc exp run` composes conf/ as `placecat params` does, only the overridden setting differs."""
    overrides = [argument for override in OWN_HOMES for argument in ("-S", override)]
    fast = ("-n", "fast", *overrides, "-S", "dataset.fps=10.0")
    run(experiments, "dvc", "exp", "run", *fast, **IDENTITY)
    changed = run(experiments, "git", "diff", "-U0", "params.yaml").stdout.splitlines()
    lines = [line for line in changed if line[:1] in "+-" and line[:3] not in ("+++", "---")]
    assert lines == ["-  fps: 30.0", "+  fps: 10.0"]
    shown = run(experiments, "dvc", "exp", "show", "--csv", "--only-changed", *WITHOUT_CHECKSUMS).stdout
    rows = {row["Experiment"] or row["rev"]: row for row in csv.DictReader(shown.splitlines())}
    baseline = run(experiments, "git", "branch", "--show-current").stdout.strip()
    fps = {name: float(row["dataset.fps"]) for name, row in rows.items()}
    assert fps == {"workspace": 10, baseline: 30, "fast": 10}
    # None of the thousands of other settings is shown.
    always = {"Experiment", "rev", "typ", "parent", "Created", "State", "Executor"}
    assert rows["fast"].keys() - always == {"dataset.fps"}
    difference = json.loads(run(experiments, "dvc", "exp", "diff", "HEAD", "fast", "--json").stdout)
    assert difference["params"] == {"params.yaml": {"dataset.fps": {"old": 30, "new": 10, "diff": -20}}}
