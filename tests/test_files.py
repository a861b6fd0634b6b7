import os
from pathlib import Path

import numpy as np
import pandas as pd
import pytest

from placecat import files
from placecat.errors import PlacecatError


def test_a_failing_block_leaves_the_old_file(tmp_path):
    target = tmp_path / "result.txt"
    target.write_text("old")
    with pytest.raises(RuntimeError), files.replacing(target) as temporary:
        temporary.write_text("half")
        raise RuntimeError
    assert target.read_text() == "old"
    assert [path.name for path in tmp_path.iterdir()] == ["result.txt"]


def test_a_failing_folder_leaves_nothing(tmp_path):
    with pytest.raises(RuntimeError), files.replacing(tmp_path / "deep" / "folder") as temporary:
        temporary.mkdir()
        (temporary / "half").touch()
        raise RuntimeError
    assert list((tmp_path / "deep").iterdir()) == []


def test_a_folder_replaces_a_folder(tmp_path):
    (tmp_path / "out").mkdir()
    (tmp_path / "out" / "old").touch()
    with files.replacing(tmp_path / "out") as temporary:
        temporary.mkdir()
        (temporary / "new").touch()
    assert [path.name for path in (tmp_path / "out").iterdir()] == ["new"]


@pytest.mark.parametrize(
    "name", ["kept", ".", "..", "new/..", "kept/..", "kept/../../{folder}", "{folder}", ""]
)
def test_a_file_never_removes_a_folder(tmp_path, monkeypatch, name):
    (tmp_path / "kept").mkdir()
    (tmp_path / "kept/mine").touch()
    monkeypatch.chdir(tmp_path)
    target = Path(name.format(folder=tmp_path if name.startswith("{") else tmp_path.name))
    with pytest.raises(PlacecatError, match=r"choose|specify"):
        files.write_text(target, "x")
    assert (tmp_path / "kept/mine").exists()


@pytest.mark.parametrize("name", ["..", "new/..", "inner/../.."])
def test_a_folder_that_is_in_use_is_not_replaced(tmp_path, monkeypatch, name):
    (tmp_path / "inner").mkdir()
    (tmp_path / "inner/mine").touch()
    monkeypatch.chdir(tmp_path / "inner")
    with pytest.raises(PlacecatError, match="in use"), files.replacing(Path(name)) as temporary:
        temporary.mkdir()
    assert (tmp_path / "inner/mine").exists()


def test_arrays_round_trip_in_the_same_bytes(tmp_path):
    arrays = {"a/b": np.arange(6.0).reshape(2, 3), "names": np.array(["x", "yy"])}
    files.write_arrays(tmp_path / "one.npz", arrays)
    files.write_arrays(tmp_path / "two.npz", arrays)
    assert (tmp_path / "one.npz").read_bytes() == (tmp_path / "two.npz").read_bytes()
    read = files.read_arrays(tmp_path / "one.npz")
    assert {name: array.tolist() for name, array in read.items()} == {
        name: array.tolist() for name, array in arrays.items()
    }


def test_only_an_ordinary_file_is_replaced(tmp_path):
    os.mkfifo(tmp_path / "pipe")
    for write in (files.check_writable, lambda path: files.write_json(path, {})):
        with pytest.raises(PlacecatError, match="pipe is not a regular file"):
            write(tmp_path / "pipe")
    assert [path.name for path in tmp_path.iterdir()] == ["pipe"]


def test_unwritable_targets_are_found_in_advance(tmp_path):
    (tmp_path / "file").write_text("")
    for path, why in [(tmp_path / "file/x", "a file is where"), (tmp_path / ("x" * 255), "a shorter name")]:
        with pytest.raises(PlacecatError, match=f"cannot write .*{why}"):
            files.check_writable(path)
    files.check_writable(tmp_path / "new/model")
    assert list((tmp_path / "new").iterdir()) == []


def test_objects_are_never_pickled(tmp_path):
    with pytest.raises(TypeError, match="which need pickle"):
        files.write_arrays(tmp_path / "one.npz", {"a": np.array([{}])})
    with pytest.raises(ValueError):
        files.write_array(tmp_path / "one.npy", np.array([{}]))
    assert list(tmp_path.iterdir()) == []


def test_csv_keeps_empty_text(tmp_path):
    files.write_csv(tmp_path / "t.csv", pd.DataFrame({"label": ["", "x"], "n": [1, 2]}))
    assert files.read_table(tmp_path / "t.csv", ["label"])["label"].tolist() == ["", "x"]


def test_text_columns_are_not_read_as_numbers(tmp_path):
    path = tmp_path / "table.csv"
    path.write_text("row,section,measured\n46,4.10,1.5\n,NA,\n")
    table = files.read_table(path, ["row", "section", "note"])
    assert table["row"].tolist() == ["46", ""]
    assert table["section"].tolist() == ["4.10", "NA"]
    assert table["measured"].tolist()[0] == 1.5
    assert table["measured"].isna().tolist() == [False, True]
    assert files.read_cells(path).to_numpy().tolist() == [["46", "4.10", "1.5"], ["", "NA", ""]]
    with pytest.raises(PlacecatError, match=r"other\.csv is missing"):
        files.read_table(tmp_path / "other.csv", [])
