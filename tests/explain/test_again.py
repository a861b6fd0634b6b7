"""`placecat explain --again` on a whole run."""

import shutil

import pytest

from placecat import files, paths
from placecat.explain.again import compute
from placecat.explain.command import read
from placecat.explain.find import find

pytestmark = [pytest.mark.slow, pytest.mark.xdist_group("pipeline")]

# A cue with and without clusters, an integration, smoothing, a filter, a gain, a trial, probabilities, text.
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


@pytest.mark.parametrize("number", CELLS)
def test_a_cell_computed_again_has_the_same_bits(reproduced, monkeypatch, number):
    folder, _, _ = reproduced
    monkeypatch.chdir(folder)
    same, said = compute(find([number], read())[0])
    assert same, said


def test_a_bit_that_differs_is_told(reproduced, tmp_path, monkeypatch):
    folder, _, _ = reproduced
    monkeypatch.chdir(shutil.copytree(folder, tmp_path / "copy", symlinks=True))
    origins = files.read_json(paths.ORIGINS)
    for row in origins["table_26"]:
        row["values"] = [value + 1e-9 for value in row["values"]]
    paths.ORIGINS.unlink()
    files.write_json(paths.ORIGINS, origins)
    same, said = compute("table_26.9.1")
    assert not same
    assert "do NOT agree" in said
