"""Explanations of the results in git: every cell can be found by its number and by its labels."""

import json
import subprocess
import sys
from functools import cache

import numpy as np
import pandas as pd
import pytest

import made_report
from placecat import files, paths, results
from placecat.errors import PlacecatError
from placecat.explain import command
from placecat.explain.command import explain_command
from placecat.explain.find import find
from placecat.provenance import lines, numbering, tidy
from placecat.provenance.made import all_stages, made
from placecat.provenance.origins import from_json, measurement
from placecat.results.measured import Measured, Results
from placecat.settings import read_yaml
from placecat.thesis.number import Number, Origin, mean, nothing
from placecat.thesis.records import trials_of

ROOT = made_report.ROOT


def content(*cells):
    """Return explanations of table cells, each given by its number, group, row and column."""
    return {
        "lines": [["table", "Table 26"]],
        "blocks": [[0]],
        "cells": {
            number: [0, ["group", group], ["row", row], ["column", column]]
            for number, group, row, column in cells
        },
    }


SMALL = content(
    ("table_26.1.1", "4-5-1", "HMM", "Home 3"),
    ("table_26.2.1", "5-5-1", "HMM", "Home 3"),
    ("table_26.3.1", "5-5-1", "Integration", "Home 3"),
)


@pytest.mark.parametrize(
    ("words", "expected"),
    [
        ("table_26.2.1", ["table_26.2.1"]),
        ("table_26 HMM home_3", ["table_26.1.1", "table_26.2.1"]),
        ("table_26 5-5-1 hmm", ["table_26.2.1"]),
        ("table_26 integr", ["table_26.3.1"]),
    ],
)
def test_a_cell_is_found_by_its_number_or_its_labels(words, expected):
    assert find(words.split(), SMALL) == expected


@pytest.mark.parametrize(
    ("words", "near"),
    [
        ("table_62", "table_26"),
        ("table_26.9.1", "table_26.1.1"),
        ("table_26 HMMM", "'HMM'"),
        ("table_26 HMN", r"did you mean 'HMM'\?$"),
        ("table_26 home_4", r"did you mean 'Home 3'\?$"),
        (
            "table_26 xyz",
            "use a group: '4-5-1', '5-5-1'; or a row: 'HMM', 'Integration'; or a column: 'Home 3'$",
        ),
    ],
)
def test_a_wrong_name_gives_similar_names(words, near):
    with pytest.raises(PlacecatError, match=near):
        find(words.split(), SMALL)


@pytest.fixture
def project(tmp_path, monkeypatch):
    """A folder with explanations of a few cells."""
    cells = {number: [*of, ["here", "41.83 % (seed-0 42.10)"]] for number, of in SMALL["cells"].items()}
    cells["table_26.1.1"].append(["thesis", "44.45; difference -2.62"])
    files.write_json(tmp_path / paths.EXPLANATIONS, SMALL | {"cells": cells})
    monkeypatch.chdir(tmp_path)


LIST = [
    "2 cells match:",
    "",
    "cell          group  row  column  measured  published",
    "table_26.1.1  4-5-1  HMM  Home 3  41.83 %   44.45",
    "table_26.2.1  5-5-1  HMM  Home 3  41.83 %",
    "",
    "To explain only one of them, add a label or use its number: placecat explain table_26.1.1",
]


def test_a_few_matching_cells_are_explained_and_listed_at_the_end(project, capsys):
    assert explain_command(["table_26", "HMM", "home_3"]) == 0
    printed = capsys.readouterr().out.splitlines()
    assert printed[-len(LIST) :] == LIST
    assert [line for line in printed if line.startswith("cell   ")][:2] == [
        "cell                    table_26.1.1",
        "cell                    table_26.2.1",
    ]


def test_many_matching_cells_are_only_listed(project, capsys, monkeypatch):
    monkeypatch.setattr(command, "_MOST", 1)
    assert explain_command(["table_26", "HMM", "home_3"]) == 0
    assert capsys.readouterr().out.splitlines() == LIST
    with pytest.raises(PlacecatError, match="--again recomputes at most 1 cells, but 2 cells match"):
        explain_command(["table_26", "HMM"], again=True)


def test_one_matching_cell_is_explained(project, capsys):
    assert explain_command(["table_26", "4-5-1"]) == 0
    printed = capsys.readouterr().out
    assert printed.startswith("cell                    table_26.1.1\n")
    assert "seed-0 42.10" in printed


def test_lines_of_a_cell_are_in_order_and_survive_the_file():
    again = json.loads(lines.to_text(SMALL))
    assert again == SMALL
    assert lines.lines_of(again, "table_26.3.1") == [
        ("table", "Table 26"),
        ("group", "5-5-1"),
        ("row", "Integration"),
        ("column", "Home 3"),
    ]


def test_the_code_of_a_stage_has_one_checksum():
    def text(code):
        deps = [{"path": "src/a.py", "md5": code}, {"path": "data/b", "md5": "0123456789.dir"}]
        return lines.stage_texts({"stages": {"cues": {"deps": deps}}})["cues"]

    assert text("1").endswith(", data/b 01234567")
    assert text("1") != text("2")


def test_rows_are_counted_across_groups_and_the_average_is_last():
    cells = pd.DataFrame(
        [("one", "a", "Average"), ("one", "a", "x"), ("two", "a", "x")], columns=["group", "row", "column"]
    )
    numbers = numbering.numbers(cells, "table_01")
    assert numbers["one", "a", "x"] == "table_01.1.1"
    assert numbers["one", "a", "Average"] == "table_01.1.2"
    assert numbers["two", "a", "x"] == "table_01.2.1"


def test_origins_go_with_the_numbers():
    one = Number(np.array([1.0, 2.0]), True, origins=(Origin("a", ("home_1",)),))
    other = Number(np.array([3.0]), False, origins=(Origin("a", ("home_2",)),))
    assert mean([one, other]).origins == (Origin("a", ("home_1", "home_2")),)
    assert one.minus(nothing("why", origins=(Origin("b"),))).origins == (
        Origin("a", ("home_1",)),
        Origin("b"),
    )


def test_a_measurement_names_its_seeds():
    counts = np.ones((2, 1, 1, 1), np.int64)
    known = Results(
        ("home_1",), ("x",), {"a": Measured(("home_1",), ("seed-0", "seed-7"), ("x",), counts)}, {}
    )
    number = Number(np.array([1.0, 2.0]), True, origins=(Origin("a", ("home_1",)),))
    assert measurement(number, known).seeds == ("seed-0", "seed-7")
    row = {"cell": ["", "r", "c"], "values": [1.0], "seeds": ["no-seed"], "origins": [["a", ["home_1"], ""]]}
    assert from_json([row])["", "r", "c"].origins == (Origin("a", ("home_1",)),)


@cache
def params():
    return read_yaml(ROOT / "params.yaml")


@pytest.mark.parametrize(
    ("result", "stages", "plan"),
    [
        ("cues/gist/5-5-1", "sequences features cues scores tables", "5-5-1"),
        (
            "smoothing/das_451_all",
            "sequences features codebooks cues integration smoothing scores tables",
            "4-5-1",
        ),
        ("filtered/informative/gist", None, "5-5-1"),
        (
            "splits/university/smoothing/three",
            "site_sequences site_features splits scores tables",
            "university",
        ),
        ("toy/0.5/sequential/sign", "toy scores tables", ""),
        ("record/benchmarks", "tables", ""),
    ],
)
def test_how_a_result_was_made(result, stages, plan):
    if result.startswith("filtered"):
        name = next(iter(params()["filters"]["informative"]["cues"]))
        result, stages = f"filtered/informative/{name}", None
    one = made(result, params(), {})
    assert one.plan == plan
    assert stages is None or " ".join(all_stages([one])) == stages


def test_a_trial_shows_its_settings(monkeypatch):
    monkeypatch.chdir(ROOT)
    trials = trials_of(params())
    one = made("trials/table_12/HOG + y-Pos||196", params(), trials)
    assert one.descriptors == ("local hog",)
    assert one.settings["classifier of the trial"]["clusters"] == 196


def test_equal_tables_give_equal_files(tmp_path):
    table = pd.DataFrame({"cell": ["a"], "by_seed": [[1.0, 2.0]], "measured": [1.5]})
    for name in ("one", "two"):
        tidy.write(tmp_path / name, table)
    assert (tmp_path / "one").read_bytes() == (tmp_path / "two").read_bytes()


def test_results_are_loaded_from_a_project(tmp_path, monkeypatch):
    with pytest.raises(PlacecatError, match=f"results.parquet is missing in {tmp_path}: .* or with its path"):
        results.load(tmp_path)
    monkeypatch.chdir(tmp_path)
    with pytest.raises(PlacecatError, match=f"results.parquet is missing in {tmp_path}: "):
        results.load()
    tidy.write(tmp_path / paths.RESULTS, pd.DataFrame({"cell": ["table_01.1.1"], "by_seed": [[1.0, 2.0]]}))
    assert list(results.load(tmp_path).explode("by_seed")["by_seed"]) == [1.0, 2.0]


def test_the_command_imports_no_numpy():
    """That is why an explanation takes less than a second."""
    code = "import placecat.explain.command, sys; sys.exit({'numpy', 'pandas'} & set(sys.modules) or 0)"
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0
