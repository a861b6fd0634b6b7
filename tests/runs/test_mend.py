"""Truncated versions of dvc.lock, and the files that a killed process leaves."""

import os
import time

import pytest
import yaml

from placecat.__main__ import main
from placecat.runs import mend

DEFINITION = {"stages": {name: {"cmd": f"do {name}"} for name in ("first", "second", "third")}}
RECORD = """  {name}:
    cmd: do {name}
    deps:
    - path: src/{name}.py
      hash: md5
      md5: {version}a2529ad6c4ea9cda8bf4ecdbe59b9{version}
      size: 1{version}
    outs:
    - path: made/{name}
      hash: md5
      md5: {version}99a7c1bf9cb3bee7d8b2e3eb5b2e08.dir
      size: 2{version}
      nfiles: 2
"""
HEAD = "schema: '2.0'\nstages:\n"


def lock_of(*versions):
    """Return the content of dvc.lock after the stages ran in these versions."""
    names = ("first", "second", "third")
    blocks = [RECORD.format(name=name, version=one) for name, one in zip(names, versions, strict=False)]
    return HEAD + "".join(blocks)


@pytest.fixture
def folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / ".dvc/tmp").mkdir(parents=True)
    (tmp_path / "dvc.yaml").write_text(yaml.safe_dump(DEFINITION, sort_keys=False))
    monkeypatch.setattr(mend, "_SHARED", tmp_path / "shm")
    return tmp_path


@pytest.mark.parametrize(("before", "after"), [((1, 1), (1, 1, 1)), ((1, 1, 1), (1, 2, 1))])
def test_a_lock_file_truncated_anywhere_keeps_earlier_records(folder, before, after):
    mend.LOCK.write_text(lock_of(*before))
    mend.keep()
    whole = lock_of(*after)
    for length in range(0, len(whole), 11):
        mend.LOCK.write_text(whole[:length])
        mend.mend()
        stages = yaml.safe_load(mend.LOCK.read_text())["stages"]
        for name, record in yaml.safe_load(lock_of(*before))["stages"].items():
            new = yaml.safe_load(whole)["stages"][name]
            # The record is either the old one or the new one, never half of it.
            assert stages[name] in (record, new), whole[:length]
        assert list(stages) == ["first", "second", "third"][: len(stages)]
        mend.COPY.write_text(lock_of(*before))


def test_a_complete_lock_file_is_not_changed(folder, capsys):
    mend.LOCK.write_text(lock_of(1, 1))
    mend.keep()
    for content in (lock_of(1, 1), lock_of(1, 2), lock_of(2, 2, 2)):
        mend.LOCK.write_text(content)
        main(["mend"])
        assert mend.LOCK.read_text() == content
        assert capsys.readouterr().out == "Nothing needs mending.\n"


def test_restored_records_and_stages_to_run_again_are_listed(folder, capsys):
    mend.LOCK.write_text(lock_of(1, 1))
    mend.keep()
    mend.LOCK.write_text(lock_of(1, 1, 1)[:-40])
    main(["mend"])
    assert mend.LOCK.read_text() == lock_of(1, 1)
    said = capsys.readouterr().out
    assert "dvc.lock was truncated when a run was killed: its records have been restored" in said
    assert "run again: third" in said


def test_a_stage_keeps_earlier_records_of_a_truncated_lock_file(folder):
    mend.LOCK.write_text(lock_of(1, 1, 1))
    mend.keep()
    mend.LOCK.write_text(lock_of(1))
    mend.keep()
    mend.mend()
    assert mend.LOCK.read_text() == lock_of(1, 1, 1)


def test_a_removed_lock_file_is_not_restored(folder):
    mend.LOCK.write_text(lock_of(1, 1, 1))
    mend.keep()
    mend.LOCK.unlink()
    mend.mend()
    assert not mend.LOCK.exists()
    mend.LOCK.write_text(lock_of(2))
    mend.mend()
    assert mend.LOCK.read_text() == lock_of(2)


def test_a_stage_that_is_no_longer_defined_is_not_restored(folder):
    mend.LOCK.write_text(lock_of(1, 1, 1))
    mend.keep()
    del DEFINITION["stages"]["third"]
    try:
        (folder / "dvc.yaml").write_text(yaml.safe_dump(DEFINITION, sort_keys=False))
    finally:
        DEFINITION["stages"]["third"] = {"cmd": "do third"}
    mend.LOCK.write_text(lock_of(1, 1))
    mend.mend()
    assert mend.LOCK.read_text() == lock_of(1, 1)


def test_merge_conflicts_are_left_to_the_user(folder):
    mend.LOCK.write_text(lock_of(1, 1))
    mend.keep()
    conflict = HEAD + "<<<<<<< HEAD\n" + RECORD.format(name="first", version=1) + "=======\n>>>>>>> b\n"
    mend.LOCK.write_text(conflict)
    mend.mend()
    assert mend.LOCK.read_text() == conflict


@pytest.mark.parametrize("content", ["", "{", '{"write": {"/there": {"pid": 4194304, "cmd": "dvc repro"}}}'])
def test_lock_entries_of_dead_processes_are_removed(folder, content):
    note = folder / ".dvc/tmp/rwlock"
    note.write_text(content)
    main(["mend"])
    assert not note.exists()


# Files that a killed process leaves behind, and files that only look similar.
LEFT = (
    ".params.0123abcd.partial.yaml",
    "data/.sequences.0123abcd.partial/Home1/frames.csv",
    "reports/.figures.0123abcd.partial/a.png",
    ".dvc/cache/files/md5/ab/.AAAAAAAAAAAAAAAAAAAAAA.tmp",
    "shm/sem.loky-4194304-abcdefgh",
    "shm/joblib_memmapping_folder_4194304_ab_cd/x",
)
NOT_LEFT = (
    "data/.mine.partial",
    ".dvc/cache/files/md5/ab/cdef",
    f"shm/sem.loky-{os.getpid()}-abcdefgh",
    "shm/another",
)


@pytest.mark.parametrize("age", [mend.OLD - 600, mend.OLD + 600])
def test_temporary_files_older_than_a_day_are_removed(folder, age):
    for name in (*LEFT, *NOT_LEFT):
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text("half")
    then = time.time() - age
    for path in sorted(folder.rglob("*"), reverse=True):
        os.utime(path, (then, then))
    mend.mend()
    assert [name for name in LEFT if (folder / name).exists()] == ([] if age > mend.OLD else list(LEFT))
    assert all((folder / name).exists() for name in NOT_LEFT)
