"""Which items of a stage are remade, and which are not."""

import json
import shutil
from pathlib import Path

import pytest
import yaml

from placecat.runs import items
from placecat.runs.items import Inputs

FOLDER = Path("data/cues")


@pytest.fixture
def made(tmp_path, monkeypatch):
    """Return a function that refreshes two items of one file each and returns the names of those remade."""
    monkeypatch.chdir(tmp_path)
    Path("src").mkdir()
    Path("src/code.py").write_text("1")
    Path("dvc.yaml").write_text(yaml.safe_dump({"stages": {"cues": {"deps": ["src/code.py", "one"]}}}))
    for name in ("one", "two"):
        Path(name).write_text(name)

    def refresh(names=("one", "two"), **settings):
        done = []

        def make(name, folder):
            done.append(name)
            (folder / "deep").mkdir(parents=True)
            (folder / "deep/file").write_text(Path(name).read_text())

        wanted = {name: Inputs(settings.get(name, {}), (Path(name),)) for name in names}
        items.refresh("cues", FOLDER, wanted, make)
        return done

    assert refresh() == ["one", "two"]
    return refresh


def test_unchanged_items_are_left_alone(made):
    assert made() == []


def test_all_items_to_make_are_named_before_the_first_is_made(made):
    calls = []

    def refresh():
        wanted = {name: Inputs({}, (Path(name),)) for name in ("one", "two", "three")}
        items.refresh("cues", FOLDER, wanted, make, begin=calls.append)

    def make(name, folder):
        calls.append(name)
        folder.mkdir()

    Path("three").write_text("3")
    Path("one").write_text("1")
    refresh()
    assert calls == [["one", "three"], "one", "three"]
    refresh()
    assert len(calls) == 3


@pytest.mark.parametrize(
    "damage",
    [
        lambda: Path("two").write_text("2"),
        lambda: (FOLDER / "two/deep/file").write_text("damaged"),
        lambda: (FOLDER / "two/deep/file").unlink(),
        lambda: (FOLDER / "two/more").write_text("by hand"),
        lambda: (FOLDER / "two/manifest.json").write_text("{"),
        lambda: (FOLDER / "two/manifest.json").unlink(),
        lambda: shutil.rmtree(FOLDER / "two"),
    ],
    ids=["input", "output", "lost output", "further output", "manifest", "lost manifest", "lost item"],
)
def test_only_changed_or_damaged_items_are_made_again(made, damage):
    before = contents()
    damage()
    assert made() == ["two"]
    assert made() == []
    assert contents().keys() == before.keys()


def contents():
    return {path: path.read_bytes() for path in FOLDER.rglob("*") if path.is_file()}


def test_settings_and_code_are_inputs_of_an_item(made):
    assert made(one={"nu": 0.1}) == ["one"]
    assert made(one={"nu": 0.1}) == []
    Path("src/code.py").write_text("2")
    assert made(one={"nu": 0.1}) == ["one", "two"]


def test_unwanted_items_and_leftovers_of_a_killed_stage_are_removed(made):
    (FOLDER / ".two.partial").mkdir()
    assert made(["one"]) == []
    assert [path.name for path in FOLDER.iterdir()] == ["one"]


def test_a_failed_stage_keeps_its_finished_items(made):
    Path("one").write_text("1")
    Path("two").unlink()
    with pytest.raises(FileNotFoundError):
        made()
    Path("two").write_text("2")
    assert made() == ["two"]


def test_only_the_files_read_from_an_item_of_another_stage_count(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    features = Path("data/features")

    def describe(descriptors):
        def make(_, folder):
            folder.mkdir()
            for name, text in descriptors.items():
                (folder / name).write_text(text)

        items.refresh("features", features, {"home": Inputs(descriptors, ())}, make)

    def train():
        done = []
        wanted = {"gist": Inputs({}, (features / "home/gist.npy",)), "all": Inputs({}, (features / "home",))}
        items.refresh("cues", FOLDER, wanted, lambda name, folder: (done.append(name), folder.mkdir()))
        return done

    describe({"gist.npy": "1"})
    assert train() == ["gist", "all"]
    describe({"gist.npy": "1", "hog.npy": "2"})
    assert train() == ["all"]
    describe({"gist.npy": "3", "hog.npy": "2"})
    assert train() == ["gist", "all"]


def test_manifests_do_not_depend_on_the_machine(made, tmp_path):
    first = contents()
    for content in first.values():
        assert str(tmp_path).encode() not in content
    manifest = json.loads(first[FOLDER / "one/manifest.json"])
    assert manifest.keys() == {"files", "made_from"}
    shutil.rmtree(FOLDER)
    made()
    assert contents() == first
