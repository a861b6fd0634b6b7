"""Times of stages: which count, their sum, and what is kept."""

import json
from pathlib import Path

import pandas as pd
import pytest

from placecat import paths, times
from placecat.errors import PlacecatError


@pytest.fixture
def folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.delenv(times.CALL, raising=False)
    return tmp_path


def record(monkeypatch, call, *stages):
    monkeypatch.setenv(times.CALL, call)
    for stage, item, seconds in stages:
        times.record(stage, item, seconds)


def test_only_the_stages_of_the_call_count(folder, monkeypatch):
    times.record("scores", None, 9.0)
    record(
        monkeypatch, "first", ("features", "home_1", 5.0), ("features", "home_2", 7.0), ("tables", None, 2.0)
    )
    record(monkeypatch, "second", ("features", "home_2", 6.5))
    run = times.gather("second", 8.0)
    assert run.stages.values.tolist() == [["features", "home_2", 6.5]]
    assert run.seconds == 8.0
    assert times.gather("third", 1.0).stages.empty


def test_stages_of_a_loop_are_one_line_and_the_longest_is_first(folder, monkeypatch):
    record(
        monkeypatch,
        "x",
        ("tables", None, 2.0),
        ("features", "home_1", 5.04),
        ("site_features", "university/north", 20.0),
        ("features", "home_2", 7.0),
    )
    run = times.gather("x", 40.3)
    assert run.by_stage().values.tolist() == [
        ["site_features", 1, 20.0],
        ["features", 2, 12.04],
        ["tables", 1, 2.0],
    ]
    assert times.text(run.by_stage(), run.seconds).splitlines() == [
        "Times of the stages that ran:",
        "  site_features          20.0 s",
        "  features          2 x  12.0 s",
        "  tables                  2.0 s",
        "  4 stages               34.0 s",
        "  DVC and the rest        6.3 s",
        "  all                    40.3 s",
    ]


def test_a_call_that_ran_nothing_says_so():
    nothing = pd.DataFrame(columns=["stage", "runs", "seconds"])
    assert times.text(nothing, 1.52) == "Times: no stage had to run; 1.5 s."


def test_an_item_with_a_slash_stays_one_file(folder):
    times.record("site_features", "university/north", 1.0)
    assert [path.name for path in paths.TIMES.iterdir()] == ["site_features@university+north.json"]


def test_a_partial_run_does_not_replace_a_complete_one(folder, monkeypatch):
    record(monkeypatch, "all", ("features", "home_1", 5.0), ("tables", None, 2.0))
    times.write(times.gather("all", 9.0), "made homes", 2, is_complete=True)
    record(monkeypatch, "some", ("tables", None, 3.0))
    times.write(times.gather("some", 4.0), "made homes", 2, is_complete=False)
    assert paths.LAST_TIMES.read_text() == "stage,item,seconds\ntables,,3.0\n"
    times.keep()
    assert paths.KEPT_TIMES.read_text() == "stage,runs,seconds\nfeatures,1,5.0\ntables,1,2.0\n"
    assert json.loads(paths.KEPT_TIMES_FACTS.read_text()) == {
        "cores": 2,
        "data": "made homes",
        "stages": 2,
        "total": 9.0,
    }


def test_without_a_complete_run_nothing_is_kept(folder):
    with pytest.raises(PlacecatError, match="`placecat repro --force` is one"):
        times.keep()
    assert not paths.KEPT_TIMES.exists()


def test_times_are_no_part_of_the_project():
    """Neither in git nor what a stage depends on or makes."""
    root = Path(__file__).resolve().parents[1]
    ignored = (root / ".gitignore").read_text().splitlines()
    pipeline = (root / "dvc.yaml").read_text()
    for path in (paths.TIMES, paths.LAST_TIMES, paths.COMPLETE_TIMES):
        assert f"/{path.as_posix()}" in ignored
        assert path.as_posix() not in pipeline
