"""Only one run at a time is allowed in a folder."""

import subprocess
import sys

import made_pipeline
import pytest

from placecat.__main__ import main
from placecat.errors import PlacecatError
from placecat.runs import lock
from project import light_conf

HOLD = """
import sys
from placecat.runs import lock
with lock.{}:
    print("held", flush=True)
    sys.stdin.read()
"""


@pytest.fixture
def folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / ".dvc").mkdir()
    return tmp_path


@pytest.fixture
def hold():
    """Start another process that holds a lock until the test ends."""
    processes = []

    def start(which):
        command = [sys.executable, "-c", HOLD.format(which)]
        process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        assert process.stdout.readline() == "held\n"
        processes.append(process)
        return process

    yield start
    for process in processes:
        process.kill()
        process.communicate()


@pytest.mark.parametrize("command", [["params"], ["repro"], ["mend"]])
def test_a_run_prevents_other_runs_and_new_settings(folder, hold, command):
    light_conf(folder / "conf")
    hold("alone()")
    with pytest.raises(SystemExit, match="a run is in progress in this folder") as caught:
        main(command)
    assert str(caught.value).startswith("placecat: ")
    assert not (folder / "params.yaml").exists()


def test_the_lock_may_be_nested_and_ends_with_its_process(folder, hold):
    process = hold("alone()")
    process.kill()
    process.wait()
    with lock.alone(), lock.alone():
        pass
    hold("alone()")


@pytest.mark.slow
def test_a_stage_waits_for_another_process_that_runs_it(folder, hold, capsys):
    holder = hold("one_at_a_time('features')")
    with lock.one_at_a_time("cues"):
        pass
    waiting = subprocess.Popen(
        [sys.executable, "-c", HOLD.format("one_at_a_time('features')")],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
    assert "Another process is running the stage features here: waiting" in waiting.stderr.readline()
    holder.kill()
    assert waiting.stdout.readline() == "held\n"
    waiting.communicate("")


def test_outside_a_project_there_is_nothing_to_lock(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    with lock.alone(), lock.one_at_a_time("features"):
        assert list(tmp_path.iterdir()) == []


@pytest.mark.slow
def test_new_settings_are_rejected_while_plain_dvc_runs_a_stage(tmp_path, monkeypatch):
    folder = made_pipeline.make(tmp_path / "project", names=("first",))
    process = made_pipeline.start(folder, "dvc", "repro", SECONDS="30")
    try:
        made_pipeline.wait_for(lambda: (folder / "ran.txt").exists() or process.poll() is not None)
        monkeypatch.chdir(folder)
        message = rf"a run is in progress .*process {process.pid}: .*dvc repro"
        with pytest.raises(PlacecatError, match=message), lock.alone():
            pass
    finally:
        process.terminate()
        process.wait()
