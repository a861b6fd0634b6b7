"""Stage times: which ones count, what they add up to, and where they are stored."""

import json
from pathlib import Path

import pandas as pd
import pytest

from placecat import paths
from placecat.errors import PlacecatError
from placecat.runs import times


@pytest.fixture
def folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.delenv(times.CALL, raising=False)
    return tmp_path


def record(monkeypatch, call, *stages):
    monkeypatch.setenv(times.CALL, call)
    for stage, seconds in stages:
        times.record(stage, seconds)


def test_only_the_stages_of_the_call_count(folder, monkeypatch):
    times.record("scores", 9.0)
    record(monkeypatch, "first", ("features", 5.0), ("tables", 2.0))
    record(monkeypatch, "second", ("features", 6.5))
    assert times.gather("second").values.tolist() == [["features", 1, 6.5]]
    assert times.gather("third").empty


def test_the_longest_stage_is_first(folder, monkeypatch):
    record(monkeypatch, "x", ("tables", 2.0), ("features", 12.04), ("site_features", 20.0))
    by_stage = times.gather("x")
    assert by_stage.values.tolist() == [
        ["site_features", 1, 20.0],
        ["features", 1, 12.04],
        ["tables", 1, 2.0],
    ]
    assert times.text(by_stage, 40.3).splitlines() == [
        "Times of the stages that ran:",
        "  site_features       20.0 s",
        "  features            12.0 s",
        "  tables               2.0 s",
        "  3 stages            34.0 s",
        "  DVC and the rest     6.3 s",
        "  all                 40.3 s",
    ]


def test_a_call_that_ran_no_stage_is_reported():
    nothing = pd.DataFrame(columns=["stage", "runs", "seconds"])
    assert times.text(nothing, 1.52) == "Times: no stage had to run; 1.5 s."


def test_a_partial_run_does_not_replace_a_complete_one(folder, monkeypatch):
    record(monkeypatch, "all", ("features", 5.0), ("tables", 2.0))
    times.write(times.gather("all"), 9.0, "made homes", 2, is_complete=True)
    record(monkeypatch, "some", ("tables", 3.0))
    times.write(times.gather("some"), 4.0, "made homes", 2, is_complete=False)
    assert paths.LAST_TIMES.read_text() == "stage,seconds\ntables,3.0\n"
    times.keep()
    assert paths.KEPT_TIMES.read_text() == "stage,runs,seconds\nfeatures,1,5.0\ntables,1,2.0\n"
    assert json.loads(paths.KEPT_TIMES_FACTS.read_text()) == {
        "cores": 2,
        "data": "made homes",
        "stages": 2,
        "total": 9.0,
    }


def test_without_a_complete_run_nothing_is_kept(folder):
    with pytest.raises(PlacecatError, match="run `placecat repro --force`"):
        times.keep()
    assert not paths.KEPT_TIMES.exists()


def test_times_are_not_part_of_the_project():
    """Times are not in git, and no stage depends on them or outputs them."""
    root = Path(__file__).resolve().parents[2]
    ignored = (root / ".gitignore").read_text().splitlines()
    pipeline = (root / "dvc.yaml").read_text()
    for path in (paths.TIMES, paths.LAST_TIMES, paths.COMPLETE_TIMES):
        assert f"/{path.as_posix()}" in ignored
        assert path.as_posix() not in pipeline
