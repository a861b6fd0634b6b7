"""`placecat explain --again` on a complete run."""

import shutil

import pytest

from placecat import files, paths
from placecat.errors import PlacecatError
from placecat.explain.again import compute
from placecat.explain.command import read
from placecat.explain.find import find


def _of_a_run(test):
    return pytest.mark.slow(pytest.mark.xdist_group("pipeline")(test))


# A cue with clusters and one without, integration, smoothing, a filter, a gain, a trial, probabilities, text.
CELLS = [
    "table_26.1.1",
    "table_26.6.1",
    "table_26.8.1",
    "table_26.9.7",
    "table_27.1.1",
    "table_12.1.1",
    "addition_probabilities.1.1",
    "addition_toy.1.1",
    "in_text.1",
]


@_of_a_run
@pytest.mark.parametrize("number", CELLS)
def test_a_recomputed_cell_has_the_same_bits(reproduced, monkeypatch, number):
    folder, _, _ = reproduced
    monkeypatch.chdir(folder)
    same, said = compute(find([number], read())[0])
    assert same, said


@_of_a_run
def test_a_different_bit_is_reported(reproduced, tmp_path, monkeypatch):
    folder, _, _ = reproduced
    monkeypatch.chdir(shutil.copytree(folder, tmp_path / "copy", symlinks=True))
    origins = files.read_json(paths.ORIGINS)
    for row in origins["table_26"]:
        row["values"] = [value + 1e-9 for value in row["values"]]
    paths.ORIGINS.unlink()
    files.write_json(paths.ORIGINS, origins)
    same, said = compute("table_26.9.1")
    assert not same
    assert "do NOT match" in said


def test_a_missing_run_is_an_error(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    files.write_json(paths.PARAMS, {"dataset": {}})
    with pytest.raises(PlacecatError, match=r"origins.json is missing.*run `dvc repro`"):
        compute("table_26.1.1")
