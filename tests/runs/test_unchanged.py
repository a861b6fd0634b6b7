"""The dependencies of a stage must not change while it runs."""

import os

import made_pipeline
import pytest
import yaml

from placecat.errors import PlacecatError
from placecat.runs import items, unchanged
from project import run

DEPENDENCIES = ["src/one.py", "src/package", "data/frames", "${dataset.root}"]


@pytest.fixture
def folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(unchanged, "_at_start", None)
    (tmp_path / "dvc.yaml").write_text(yaml.safe_dump({"stages": {"one": {"deps": DEPENDENCIES}}}))
    (tmp_path / "params.yaml").write_text("dataset: {root: films}\n")
    for name in ("src/one.py", "src/package/inner.py", "src/other.py", "data/frames/1.csv", "films/a.mp4"):
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text("before")
    return tmp_path


@pytest.mark.parametrize(
    "name",
    [
        "params.yaml",
        "src/one.py",
        "src/package/inner.py",
        "src/package/new.py",
        "data/frames/1.csv",
        "films/a.mp4",
    ],
)
def test_a_changed_dependency_is_named(folder, name):
    unchanged.start("one")
    unchanged.check()
    with (folder / name).open("a") as file:
        file.write("# after\n")
    with pytest.raises(PlacecatError, match=f"{name} was changed while the stage one ran"):
        unchanged.check()


def test_a_removed_dependency_is_named(folder):
    unchanged.start("one")
    (folder / "films/a.mp4").unlink()
    with pytest.raises(PlacecatError, match=r"films/a\.mp4 was changed"):
        unchanged.check()


def test_other_files_and_new_timestamps_are_ignored(folder):
    unchanged.start("one")
    (folder / "src/other.py").write_text("after")
    (folder / "src/package/__pycache__").mkdir()
    (folder / "src/package/__pycache__/inner.pyc").write_text("compiled")
    os.utime(folder / "params.yaml", (1, 1))
    os.utime(folder / "src/one.py", (1, 1))
    unchanged.check()


def test_an_item_made_from_changed_inputs_is_not_kept(folder):
    unchanged.start("one")

    def make(name, target):
        target.mkdir()
        (target / "made").write_text("1")
        if name == "second":
            (folder / "params.yaml").write_text("dataset: {root: films, other: 1}\n")

    wanted = {name: items.Inputs(settings=1, paths=()) for name in ("first", "second", "third")}
    with pytest.raises(PlacecatError, match=r"params\.yaml was changed"):
        items.refresh("one", folder / "made", wanted, make)
    assert [path.name for path in (folder / "made").iterdir()] == ["first"]


@pytest.mark.slow
def test_dvc_does_not_record_settings_that_were_changed_while_a_stage_ran(tmp_path):
    folder = made_pipeline.make(tmp_path / "project", names=("first",))
    process = made_pipeline.start(folder, "dvc", "repro", log=tmp_path / "log", SECONDS="2")
    made_pipeline.wait_for(lambda: (folder / "ran.txt").exists() or process.poll() is not None)
    (folder / "params.yaml").write_text("reproducibility: {tolerance: 5.0}\n")
    assert process.wait(60) != 0
    said = (tmp_path / "log").read_text()
    assert "placecat: params.yaml was changed while the stage first ran" in said
    assert "Traceback" not in said
    run(folder, "dvc", "repro")
    assert (folder / "ran.txt").read_text().split() == ["first", "first"]
