"""Runs of a small pipeline that are killed, started twice, or run out of disk space."""

import os
import shutil
import subprocess
import sys
import time
from pathlib import Path

import kills
import made_pipeline
from damaged_inputs import MESSAGE, RIGHT, TRACEBACK, WRONG

from project import contents, environment, run

PARTS = ("made", "dvc.lock")
BUSY = {"SECONDS": "0.2", "PLACECAT_WORKERS": "1"}
# Like `placecat repro`, but without composing the settings.
REPRO = (
    "python",
    "-c",
    "import sys\nfrom placecat.runs import repro\nfrom placecat.errors import exiting\n"
    "with exiting():\n    sys.exit(repro.run())",
)
# Range of the free space on a separate disk, and a size that is enough, both in KB.
SIZES, ENOUGH = (4, 110), 64_000
MOUNT = ["unshare", "--map-root-user", "--mount", sys.executable, __file__]


class Kills:
    """Runs killed at any moment. The next run must finish with the same bytes."""

    def __init__(self, folder):
        self.folder = folder

    def attempt(self, rng):
        """Kill one run. Return one of the outcomes and the message."""
        folder = self.folder / "kills"
        shutil.rmtree(folder, ignore_errors=True)
        said = []
        counts = kills.campaign(folder, 1, 600.0, int(rng.integers(2**31)), said.append)
        return (RIGHT if counts == {"clean": 1} else WRONG), "; ".join(said)


class _Runs:
    def __init__(self, folder):
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir(parents=True)
        self.folder, self.template, whole = folder, folder / "template", folder / "whole"
        made_pipeline.make(self.template)
        shutil.copytree(self.template, whole, symlinks=True)
        begin = time.monotonic()
        run(whole, *made_pipeline.REPRO, **BUSY)
        self.seconds = time.monotonic() - begin
        self.whole = contents(whole, *PARTS)


class TwoAtOnce(_Runs):
    """A run that is started during another one."""

    def attempt(self, rng):
        """Start a second run after a while. Return one of the outcomes and the message."""
        folder = self.folder / "one"
        shutil.rmtree(folder, ignore_errors=True)
        shutil.copytree(self.template, folder, symlinks=True)
        logs = [self.folder / f"{number}.log" for number in (1, 2)]
        first = made_pipeline.start(folder, *REPRO, log=logs[0], **BUSY)
        time.sleep(rng.uniform(0, self.seconds))
        second = made_pipeline.start(folder, *REPRO, log=logs[1], **BUSY)
        done = [one.wait(600) for one in (first, second)]
        said = [log.read_text() for log in logs]
        if any("Traceback" in text for text in said):
            return TRACEBACK, "".join(said)
        if min(done) != 0 or contents(folder, *PARTS) != self.whole:
            return WRONG, "".join(said)
        return (MESSAGE if any(done) else RIGHT), ""


class DiskFull(_Runs):
    """A run on a full disk, followed by one with free space."""

    def __init__(self, folder):
        folder.mkdir(parents=True, exist_ok=True)
        test = subprocess.run(
            [*MOUNT, "400", str(folder), ""], env=_environment(), check=False, capture_output=True
        )
        if test.returncode:
            raise RuntimeError("this system lets nobody mount a disk of a given size")
        super().__init__(folder)

    def attempt(self, rng):
        """Run with too little space, then with enough. Return one of the outcomes and the message."""
        place = self.folder / "disk"
        place.mkdir(exist_ok=True)
        size = str(int(rng.integers(*SIZES)))
        done = subprocess.run(
            [*MOUNT, size, str(place), str(self.folder / "result"), str(self.template)],
            env=_environment(),
            capture_output=True,
            text=True,
            check=False,
        )
        said = f"{size} KB: {done.stdout[-2000:]}{done.stderr[-2000:]}"
        if contents(self.folder / "result", *PARTS) != self.whole:
            return WRONG, said
        if "Traceback" in said:
            return TRACEBACK, said
        return (RIGHT if done.returncode == 0 else MESSAGE), said


def _environment():
    """Return an environment in which a new process finds the same modules as this one."""
    return environment(**BUSY, PYTHONPATH=os.pathsep.join(filter(None, sys.path)))


def on_a_small_disk(size, place, result, template=None):
    """Run the pipeline, free disk space, run it again and copy its outputs, all in a mount namespace."""
    mount = ["mount", "-t", "tmpfs", "tmpfs", place, "-o"]
    subprocess.run([*mount, f"size={size}k"], check=True)
    if template is None:
        return 0
    shutil.rmtree(result, ignore_errors=True)
    folder = f"{place}/project"
    subprocess.run(["mount", "-o", f"remount,size={ENOUGH}k", place], check=True)
    shutil.copytree(template, folder, symlinks=True)
    used = sum(one.stat().st_blocks for one in Path(folder).rglob("*")) // 2
    subprocess.run(["mount", "-o", f"remount,size={used + int(size)}k", place], check=True)
    first = subprocess.run(REPRO, cwd=folder, check=False)
    subprocess.run(["mount", "-o", f"remount,size={ENOUGH}k", place], check=True)
    subprocess.run(made_pipeline.REPRO, cwd=folder, check=False, capture_output=True)
    shutil.copytree(folder, result, symlinks=True)
    return 1 if first.returncode else 0


KINDS = {"kills": Kills, "two_at_once": TwoAtOnce, "disk_full": DiskFull}

if __name__ == "__main__":
    sys.exit(on_a_small_disk(*sys.argv[1:]))
