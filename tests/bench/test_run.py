import sys

import pandas as pd
import pytest

from placecat import files
from placecat.errors import PlacecatError
from placecat.report.benchmarks import TEXT
from placecat_bench import __main__ as command
from placecat_bench import pieces, run
from placecat_bench.comparison import Comparison, Limit, Peer


@pytest.fixture
def made(monkeypatch):
    """Two pieces with numbers that tests can change."""
    numbers = {"first": 1.0, "second": 2.0}
    threads = []

    def entries_of(name):
        def entries():
            import cv2

            threads.append(cv2.getNumThreads())
            yield Limit(name, "", "of it", lambda: numbers[name], at_most=1.5)
            yield Comparison(name, "", Peer("pip", "pip"), lambda: None, lambda: None, at_most=1e9)

        return entries

    # Skip garbage collection, since earlier tests may have left a lot of garbage.
    monkeypatch.setattr("placecat_bench.timing.gc.collect", lambda: None)
    monkeypatch.setattr(pieces, "names", lambda: ["first", "second"])
    monkeypatch.setattr(pieces, "load", entries_of)
    monkeypatch.setattr(run, "_facts", lambda: {"processor": "one"})
    numbers["threads"] = threads
    return numbers


def test_all_pieces_are_measured_on_one_thread_and_written(made, tmp_path, capsys):
    target = tmp_path / "benchmarks.csv"
    table = run.run([], target)
    written = files.read_table(target, TEXT)
    assert list(written.columns) == list(table.columns)
    assert list(written["module"]) == ["first", "first", "second", "second"]
    assert list(written["met"]) == ["yes", "yes", "no", "yes"]
    assert made["threads"] == [1, 1]
    assert files.read_json(tmp_path / "benchmarks.json") == {"processor": "one"}
    assert "second: of it 2.0 (target: at most 1.5, MISSED)" in capsys.readouterr().out


def test_a_named_piece_replaces_only_its_rows(made, tmp_path):
    target = tmp_path / "benchmarks.csv"
    run.run([], target)
    before = files.read_table(target, TEXT)
    made |= {"first": 1.25, "second": 1.25}
    run.run(["second"], target)
    after = files.read_table(target, TEXT)
    assert list(after["module"]) == ["first", "first", "second", "second"]
    pd.testing.assert_frame_equal(after[:2], before[:2])
    assert after["ours"][2] == 1.25


def test_rows_from_different_machines_are_not_mixed(made, tmp_path, monkeypatch):
    target = tmp_path / "benchmarks.csv"
    run.run([], target)
    monkeypatch.setattr(run, "_facts", lambda: {"processor": "another"})
    with pytest.raises(PlacecatError, match="another machine"):
        run.run(["second"], target)
    assert files.read_json(tmp_path / "benchmarks.json") == {"processor": "one"}
    run.run([], target)
    assert files.read_json(tmp_path / "benchmarks.json") == {"processor": "another"}


def test_measurements_remain_if_a_later_piece_fails(made, tmp_path):
    made.pop("second")
    with pytest.raises(KeyError):
        run.run([], tmp_path / "benchmarks.csv")
    assert set(files.read_table(tmp_path / "benchmarks.csv")["module"]) == {"first"}


def test_an_unknown_piece_ends_with_a_one_line_message(monkeypatch):
    monkeypatch.setattr(sys, "argv", ["benchmarks", "sorting"])
    with pytest.raises(SystemExit) as ended:
        command.main(["sorting"])
    assert str(ended.value).startswith("placecat: the piece 'sorting' does not exist: use one of ")
