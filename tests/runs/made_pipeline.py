"""A small project with four stages, run by the real stage runner and real DVC."""

import contextlib
import os
import shutil
import subprocess
import time
from collections.abc import Callable
from pathlib import Path

import yaml

from project import ROOT, environment, run

# Each stage reads the output of the previous one. `second` has workers, and `middle` keeps its files, like a
# stage with items.
STAGE = '''
"""Add a line."""

import json
import os
import time
from pathlib import Path

from placecat.compute import parallel
from placecat.stages import run

NAME = Path(__file__).stem


def main() -> None:
    """Add a line."""
    with Path("ran.txt").open("a") as ran:
        ran.write(NAME + "\\n")
    seconds = float(os.environ.get("SECONDS", "0"))
    if NAME == "second" and seconds:
        parallel.in_parallel(time.sleep, [(seconds,)] * 4, NAME)
    time.sleep(seconds)
    before = Path("params.yaml").read_text()
    for source in Path("made").glob("*/*.json"):
        before += source.read_text()
    target = Path("made") / NAME
    target.mkdir(parents=True, exist_ok=True)
    (target / "one.json").write_text(json.dumps(len(before)))


if __name__ == "__main__":
    run(main)
'''
NAMES = ("first", "second", "middle", "last")


def make(folder: Path, names: tuple[str, ...] = NAMES) -> Path:
    """Write the project; none of its stages has run."""
    stages = {}
    for number, name in enumerate(names):
        (folder / "src").mkdir(parents=True, exist_ok=True)
        (folder / f"src/{name}.py").write_text(STAGE)
        before = [f"made/{names[number - 1]}"] if number else []
        stages[name] = {
            "cmd": f"python src/{name}.py",
            "deps": [f"src/{name}.py", *before],
            "params": ["reproducibility"],
            "outs": [{f"made/{name}": {"persist": name == "middle"}}],
        }
    (folder / "dvc.yaml").write_text(yaml.safe_dump({"stages": stages}, sort_keys=False))
    (folder / "params.yaml").write_text("reproducibility: {tolerance: 3.0}\n")
    (folder / ".gitignore").write_text((ROOT / ".gitignore").read_text() + "/made\n/ran.txt\n")
    run(folder, "git", "init", "-q")
    run(folder, "dvc", "init", "-q")
    shutil.copy(ROOT / ".dvc/config", folder / ".dvc/config")
    return folder


def add_records(folder: Path, number: int) -> None:
    """Add records of removed stages to dvc.lock, so that it is as large as a real one."""
    records = yaml.safe_load((folder / "dvc.lock").read_text())
    one = records["stages"]["last"]
    records["stages"] = {f"former_{each}": one for each in range(number)} | records["stages"]
    (folder / "dvc.lock").write_text(yaml.dump(records, Dumper=_Plain, sort_keys=False))


class _Plain(yaml.SafeDumper):
    """Write YAML without aliases, as DVC does."""

    def ignore_aliases(self, data: object) -> bool:
        return True


REPRO = ("python", "-c", "import sys; from placecat.runs import repro; sys.exit(repro.run())")


def start(folder: Path, *command: str, log: Path | None = None, **extra: str) -> "subprocess.Popen[bytes]":
    """Start a command as the leader of a new process group; by default, `repro.run`."""
    with (log or Path(os.devnull)).open("w") as output:
        return subprocess.Popen(
            command or REPRO,
            cwd=folder,
            env=environment(**extra),
            stdout=output,
            stderr=subprocess.STDOUT,
            start_new_session=True,
        )


def send_to_group(leader: int, number: int) -> None:
    """Send a signal to every process of a group, if the group exists."""
    with contextlib.suppress(ProcessLookupError):
        os.killpg(leader, number)


def wait_for(condition: Callable[[], bool], seconds: float = 60) -> None:
    """Wait until a condition is true."""
    end = time.monotonic() + seconds
    while not condition():
        assert time.monotonic() < end
        time.sleep(0.02)
