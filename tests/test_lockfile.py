import pytest

from placecat.errors import PlacecatError
from placecat.lockfile import data_version

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


def test_the_version_of_the_data_is_the_checksum_of_what_was_listed(tmp_path, monkeypatch):
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
