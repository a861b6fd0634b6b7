import csv
import hashlib
import json
import re
import subprocess
from pathlib import Path

import pytest
import yaml

from placecat import settings
from placecat.errors import PlacecatError
from placecat.runs import repro
from placecat.runs.lockfile import check_data, data_version
from placecat.settings import read_yaml

ROOT = Path(__file__).resolve().parents[2]
KEPT = read_yaml(ROOT / "dvc.lock")["stages"]
PARAMS = settings.load(ROOT / "params.yaml")
STAGES = read_yaml(ROOT / "dvc.yaml")["stages"]

LOCK = """
schema: '2.0'
stages:
  sequences:
    cmd: python
    outs:
    - path: data/sequences
      md5: 0123.dir
  site_sequences:
    cmd: python
    outs:
    - path: data/site_sequences
      md5: 4567.dir
"""


def test_the_data_version_is_the_checksum_of_the_frame_list(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "dvc.lock").write_text(LOCK)
    assert data_version() == "0123.dir"
    assert data_version("site_sequences") == "4567.dir"


def test_a_stage_that_did_not_run_is_named(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    with pytest.raises(PlacecatError, match=r"dvc\.lock has no stage sequences: run `dvc repro`"):
        data_version()
    (tmp_path / "dvc.lock").write_text(LOCK)
    with pytest.raises(PlacecatError, match="no stage features@home_1"):
        data_version("features@home_1")


def test_features_of_another_data_set_are_rejected(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    dataset = {"name": "homes", "root": "here"}
    lock = yaml.safe_load(LOCK)
    lock["stages"]["sequences"]["params"] = {"params.yaml": {"dataset": dataset}}
    lock["stages"]["features"] = {"deps": [{"path": "data/sequences", "md5": "0123.dir"}]}
    (tmp_path / "dvc.lock").write_text(yaml.safe_dump(lock))
    check_data({"dataset": dataset})
    with pytest.raises(PlacecatError, match="the features come from a different data set"):
        check_data({"dataset": dataset | {"root": "there"}})
    # The stage `sequences` has run again, but `features` has not.
    lock["stages"]["features"]["deps"][0]["md5"] = "89ab.dir"
    (tmp_path / "dvc.lock").write_text(yaml.safe_dump(lock))
    with pytest.raises(PlacecatError, match="a different data set"):
        check_data({"dataset": dataset})
    del lock["stages"]["features"]
    (tmp_path / "dvc.lock").write_text(yaml.safe_dump(lock))
    with pytest.raises(PlacecatError, match="a different data set"):
        check_data({"dataset": dataset})


def test_the_record_in_git_has_the_data_set_and_its_checksum():
    """DVC recorded both. The settings of the data set may have changed since then."""
    assert KEPT["sequences"]["params"]["params.yaml"]["dataset"]["name"] == "homes"
    (listed,) = KEPT["sequences"]["outs"]
    assert {"path": "data/sequences", "md5": listed["md5"]}.items() <= next(
        dep for dep in KEPT["features"]["deps"] if dep["path"] == "data/sequences"
    ).items()


def filled(reference):
    """Return the setting named by a reference in dvc.yaml."""
    return settings.get(PARAMS, reference[1])


def test_the_lock_file_has_every_stage_and_no_other():
    assert set(KEPT) == set(STAGES)
    for name, stage in STAGES.items():
        wanted = {re.sub(r"\$\{([\w.]+)\}", filled, dep) for dep in stage.get("deps", [])}
        assert {dep["path"] for dep in KEPT[name].get("deps", [])} == wanted


def in_git():
    """Yield each stage and output that are in git."""
    for name, stage in STAGES.items():
        for out in stage["outs"]:
            if isinstance(out, dict) and not next(iter(out.values())).get("cache", True):
                yield name, next(iter(out))


def checksum(folder, files):
    """Compute DVC's checksum of a file, or of a folder from its files."""
    sums = {path: hashlib.md5((ROOT / path).read_bytes()).hexdigest() for path in files}
    if list(sums) == [folder]:
        return sums[folder]
    listed = [{"md5": sums[path], "relpath": path.removeprefix(f"{folder}/")} for path in sorted(sums)]
    return hashlib.md5(json.dumps(listed).encode()).hexdigest() + ".dir"


@pytest.mark.parametrize(("stage", "path"), list(in_git()))
def test_the_lock_file_has_the_files_that_git_has(stage, path):
    """Otherwise, a run in a fresh clone changes the lock file, although it makes the same files."""
    listed = subprocess.run(["git", "ls-files", path], cwd=ROOT, capture_output=True, text=True, check=False)
    if listed.returncode:
        pytest.skip("this is no git repository")
    (locked,) = (out for out in KEPT[stage]["outs"] if out["path"] == path)
    assert locked["md5"] == checksum(path, listed.stdout.splitlines())


def test_the_times_in_git_cover_every_stage(monkeypatch):
    monkeypatch.chdir(ROOT)
    with Path("reports/times.csv").open() as file:
        assert {row["stage"] for row in csv.DictReader(file)} >= set(repro.stages())
