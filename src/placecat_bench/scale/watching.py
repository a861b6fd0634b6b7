"""Running a command and watching the time and the memory of all its processes."""

import os
import subprocess
import time
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import psutil

from placecat.errors import PlacecatError

GIB = 2**30
# Seconds between two looks.
INTERVAL = 0.25


@dataclass(frozen=True)
class Watched:
    """Time and memory that a command took.

    Attributes
    ----------
    seconds
        From its start to its end.
    cpu_seconds
        Of all its processes together; what else the machine does matters less to them.
    peak_gib
        The most memory that all its processes had together, in GiB. Pages that several of them share count
        once (the proportional set size, where the system tells it).
    """

    seconds: float
    cpu_seconds: float
    peak_gib: float


def watch(command: Sequence[str], folder: Path, log: Path) -> Watched:
    """Run a command in a folder, its output into a file.

    Raises
    ------
    PlacecatError
        If it fails; the message has the last line it wrote.
    """
    log.parent.mkdir(parents=True, exist_ok=True)
    start, peak = time.perf_counter(), 0
    cpu: dict[int, float] = {}
    with log.open("wb") as output:
        # Unbuffered, so that the last line is what it said last.
        environment = os.environ | {"PYTHONUNBUFFERED": "1"}
        process = subprocess.Popen(
            command, cwd=folder, env=environment, stdout=output, stderr=subprocess.STDOUT
        )
        try:
            while True:
                peak = max(peak, _look(process.pid, cpu))
                try:
                    status = process.wait(timeout=INTERVAL)
                    break
                except subprocess.TimeoutExpired:
                    continue
        except BaseException:
            process.terminate()
            process.wait()
            raise
    seconds = time.perf_counter() - start
    if status != 0:
        lines = log.read_text(encoding="utf-8", errors="replace").splitlines()
        said = next((line.strip() for line in reversed(lines) if line.strip()), "nothing")
        raise PlacecatError(f"{' '.join(command[1:])} ended with status {status}: {said} (all of it: {log})")
    return Watched(seconds, sum(cpu.values()), peak / GIB)


def _look(pid: int, cpu: dict[int, float]) -> int:
    """Bytes that a process and its descendants have now; their CPU seconds go to `cpu`."""
    try:
        parent = psutil.Process(pid)
        family = [parent, *parent.children(recursive=True)]
    except psutil.NoSuchProcess:
        return 0
    total = 0
    for one in family:
        try:
            times = one.cpu_times()
            cpu[one.pid] = times.user + times.system
            total += memory(one)
        # It ended meanwhile.
        except (psutil.NoSuchProcess, psutil.AccessDenied):
            continue
    return total


def memory(process: psutil.Process) -> int:
    """Bytes of a process, its part of shared ones with them; all resident ones where no part is told."""
    if psutil.LINUX:
        return int(process.memory_full_info().pss)
    return int(process.memory_info().rss)
