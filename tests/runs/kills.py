"""Kill runs at random moments for a given time, and check that they recover. A seed makes this repeatable.

``python tests/runs/kills.py FOLDER KILLS SECONDS [SEED]`` prints the counts (with PYTHONPATH=tests).
"""

import collections
import random
import shutil
import signal
import sys
import time
from pathlib import Path

import made_pipeline
import psutil
from made_pipeline import REPRO

from project import contents, run

SIGNALS = (signal.SIGKILL, signal.SIGTERM, signal.SIGINT)
MEND = "import sys; from placecat.__main__ import main; main(['mend'])"
# Seconds after which a surviving process of a killed run counts as an orphan.
GRACE = 20.0
# Number of records of removed stages, which make writing dvc.lock take longer.
RECORDS = 100
# A stage with workers, a stage that keeps its files, and an ordinary one.
NAMES = ("second", "middle", "last")
# Makes stages slow, and gives one of them workers.
SLOW = {"SECONDS": "0.2", "PLACECAT_WORKERS": "2"}


class Failure(AssertionError):
    """A killed run did not resume correctly."""


def campaign(folder, kills, seconds, seed=0, say=lambda line: None):
    """Kill runs of the small pipeline, and resume each of them.

    Parameters
    ----------
    kills, seconds
        Maximum number of kills and time limit. One kill in three happens while dvc.lock is written.
    say
        Called with a line for each kill.

    Returns
    -------
    dict
        The number of runs for "clean" and for each kind of failure.
    """
    chance, end = random.Random(seed), time.monotonic() + seconds
    template, whole = folder / "template", folder / "whole"
    template.mkdir(parents=True)
    made_pipeline.make(template, NAMES)
    run(template, *REPRO)
    made_pipeline.add_records(template, RECORDS)
    (template / "params.yaml").write_text("reproducibility: {tolerance: 44.0}\n")
    (template / "ran.txt").write_text("")
    shutil.copytree(template, whole, symlinks=True)
    begin = time.monotonic()
    run(whole, *REPRO, **SLOW)
    duration = time.monotonic() - begin
    counts = collections.Counter()
    for number in range(kills):
        if time.monotonic() > end:
            break
        by = ("dvc", "repro") if chance.random() < 0.3 else REPRO
        how = (
            chance.choice(SIGNALS),
            chance.random() < 0.5,
            None if number % 3 == 2 else chance.uniform(0, duration),
            chance.randint(1, 4),
        )
        one = folder / "one"
        shutil.rmtree(one, ignore_errors=True)
        shutil.copytree(template, one, symlinks=True)
        try:
            _kill_and_go_on(one, whole, by, *how)
            result = "clean"
        except Failure as failure:
            result = str(failure)
        counts[result.partition(":")[0]] += 1
        where = "in the write" if how[2] is None else f"after {how[2]:.1f} s"
        say(f"{number} {by[0]} {how[0].name} {'group' if how[1] else 'leader'} {where}: {result}")
    return dict(counts)


def _kill_and_go_on(folder, whole, by, number, to_group, delay, write):
    process = made_pipeline.start(
        folder, *by, log=folder.with_suffix(".log"), SECONDS="0.2", PLACECAT_WORKERS="2"
    )
    if delay is None:
        _wait_for_write(folder, process, write)
    else:
        time.sleep(delay)
    if process.poll() is None:
        if to_group:
            # Signal the group, as a terminal or a service manager does.
            made_pipeline.send_to_group(process.pid, number)
        else:
            process.send_signal(number)
        if by[0] == "dvc" and not to_group and number == signal.SIGINT:
            # Plain DVC ignores Ctrl-C while a stage runs.
            process.send_signal(signal.SIGTERM)
    deadline = time.monotonic() + GRACE
    while (left := living(folder)) and time.monotonic() < deadline:
        time.sleep(0.1)
    for one in left:
        one.kill()
    if left:
        raise Failure(f"orphans: {[' '.join(one.cmdline())[:80] for one in left]}")
    process.wait(GRACE)
    seen = [line for line in run(folder, "git", "status", "--short").stdout.splitlines() if "partial" in line]
    if seen:
        raise Failure(f"temporary files in git status: {seen}")
    ran = (folder / "ran.txt").read_text().split()
    if by[0] == "dvc":
        mended = run(folder, "python", "-c", MEND, check=False)
        if mended.returncode:
            raise Failure(f"mend fails: {mended.stderr}")
    result = run(folder, *by, check=False)
    if result.returncode:
        raise Failure(f"does not go on: {result.stdout[-500:]}{result.stderr[-500:]}")
    again = (folder / "ran.txt").read_text().split()[len(ran) :]
    twice = set(ran[:-1]) & set(again)
    if twice:
        raise Failure(f"computed twice: {ran} {again}")
    parts = ("made", "dvc.lock")
    if contents(folder, *parts) != contents(whole, *parts):
        raise Failure(f"other bytes: {ran} {again}")


def _wait_for_write(folder, process, write):
    """Wait for write number `write` of dvc.lock. Plain DVC empties the file; ours uses another name."""
    size = (folder / "dvc.lock").stat().st_size
    end = time.monotonic() + 60
    before = False
    while process.poll() is None and time.monotonic() < end:
        try:
            is_now = (
                any(folder.glob(".dvc.*.partial.lock")) or (folder / "dvc.lock").stat().st_size < size / 2
            )
        except FileNotFoundError:
            is_now = False
        if is_now and not before:
            write -= 1
            if write == 0:
                return
        before = is_now
        time.sleep(0.001)


def living(folder):
    """Return the processes whose working directory is the folder."""
    found = []
    for one in psutil.process_iter(["cwd", "status"]):
        if one.info["cwd"] and Path(one.info["cwd"]) == folder and one.info["status"] != psutil.STATUS_ZOMBIE:
            found.append(one)
    return found


if __name__ == "__main__":
    place, kills, seconds, *seed = sys.argv[1:]
    print(
        campaign(
            Path(place).resolve(),
            int(kills),
            float(seconds),
            *map(int, seed),
            say=lambda line: print(line, flush=True),
        )
    )
