"""Ctrl-C during feature extraction with real DVC, and resuming afterwards."""

import os
import shutil
import signal
import subprocess
import sys
import time

import pytest
import yaml

from placecat.settings import read_yaml
from project import ROOT, contents, environment, init, repro, run
from sketch import draw_homes

HOMES = ("Home1", "Home2", "Home3")
# Programs react to Ctrl-C as in a terminal, however the tests were started.
HEED = (
    "import os,signal,sys; signal.signal(signal.SIGINT, signal.SIG_DFL); os.execvp(sys.argv[1], sys.argv[1:])"
)
PLACECAT_REPRO = ("python", "-c", "import sys; from placecat.runs import repro; sys.exit(repro.run())")


@pytest.fixture
def project(tmp_path):
    """A project with the stages `sequences` and `features` on drawn homes, before its first run."""
    folder = tmp_path / "project"
    folder.mkdir()
    shutil.copytree(ROOT / "src", folder / "src", ignore=shutil.ignore_patterns("__pycache__", "*.egg-info"))
    stages = read_yaml(ROOT / "dvc.yaml")["stages"]
    chosen = {"stages": {name: stages[name] for name in ("sequences", "features")}}
    (folder / "dvc.yaml").write_text(yaml.safe_dump(chosen, sort_keys=False))
    params = read_yaml(ROOT / "params.yaml")
    own = {name: params[name] for name in ("attention", "regions", "region_variants", "information")}
    own["dataset"] = yaml.safe_load((ROOT / "conf/dataset/my_homes.yaml").read_text())
    own["dataset"] |= {"root": "data/drawn", "homes": list(HOMES), "fps": 5.0}
    descriptors = params["descriptors"]
    own["descriptors"] = {
        "local": {"hog": descriptors["local"]["hog"]},
        "holistic": {"gist": descriptors["holistic"]["gist"]},
    }
    (folder / "params.yaml").write_text(yaml.safe_dump(own))
    # There are more frames than fit into one task, so that both workers are busy.
    draw_homes(folder / "data/drawn", homes=3, frames_per_room=8, width=480, height=270)
    init(folder)
    return folder


def interrupt(folder, home, *command):
    """Run a command and press Ctrl-C once the home before `home` is complete; return status and output."""
    log = folder.parent / f"{home}.log"
    with log.open("w") as output:
        process = subprocess.Popen(
            [sys.executable, "-c", HEED, *command],
            cwd=folder,
            env=environment(PLACECAT_WORKERS="2"),
            stdout=output,
            stderr=subprocess.STDOUT,
            start_new_session=True,
        )
        try:
            before = folder / "data/features" / HOMES[HOMES.index(home) - 1]
            wait_for(lambda: before.exists() or process.poll() is not None)
            assert process.poll() is None, log.read_text()
            # Send the signal to every process of the command, as a terminal does.
            os.killpg(process.pid, signal.SIGINT)
            status = process.wait(60)
            wait_for(lambda: not running(process.pid))
        finally:
            if running(process.pid):
                os.killpg(process.pid, signal.SIGKILL)
                process.wait()
    return status, log.read_text()


def wait_for(condition, seconds=60):
    end = time.monotonic() + seconds
    while not condition():
        assert time.monotonic() < end
        time.sleep(0.02)


def running(group):
    """Return whether any process of a group is alive; zombies do not count."""
    listed = subprocess.run(["ps", "-eo", "pgid=,stat="], capture_output=True, text=True, check=True).stdout
    return any(
        int(of) == group and not state.startswith("Z") for of, state in map(str.split, listed.splitlines())
    )


@pytest.mark.slow
def test_a_run_resumes_after_ctrl_c_and_produces_the_same_bytes(project, tmp_path):
    whole = tmp_path / "whole"
    shutil.copytree(project, whole, symlinks=True)
    ran, _ = repro(whole, PLACECAT_WORKERS="1")
    assert ran == ["sequences", "features"]

    done = []
    for home, command in (("Home2", PLACECAT_REPRO), ("Home3", ("dvc", "repro"))):
        status, said = interrupt(project, home, *command)
        assert status == 255, said
        assert "failed to reproduce 'features'" in said
        assert "Traceback" not in said
        assert "placecat/" not in said
        assert all(f"features of {name}" not in said for name in done)
        done = [name for name in HOMES if name < home]
        assert sorted(path.name for path in (project / "data/features").iterdir()) == done

    # Imitate the leftovers of a stage that had no time to clean up, for example after a power failure.
    left = project / "data/features/.Home3.0123abcd.partial"
    left.mkdir()
    (left / "local_hog.npy").write_bytes(b"half")
    ran, _ = repro(project, PLACECAT_WORKERS="2")
    assert ran == ["features"]
    parts = ("dvc.lock", "data/sequences", "data/features")
    assert contents(project, *parts) == contents(whole, *parts)


def test_ctrl_c_while_a_stage_imports_prints_no_traceback(tmp_path):
    ctrl_c = "import placecat.stages; raise KeyboardInterrupt"
    assert run(tmp_path, "python", "-c", ctrl_c, check=False).stderr == ""
    other = run(tmp_path, "python", "-c", "import placecat.stages; raise OSError('full')", check=False)
    assert "Traceback" in other.stderr
    assert "full" in other.stderr
