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
    """Wall seconds of a command, and CPU seconds and peak memory of all its processes together, in GiB.

    The load of the machine matters less to CPU seconds. Memory shared by several processes counts once (the
    proportional set size, where the system has it).
    """

    seconds: float
    cpu_seconds: float
    peak_gib: float


def watch(command: Sequence[str], folder: Path, log: Path) -> Watched:
    """Run a command in a folder, its output into a file; if it fails, the PlacecatError has its last line."""
    log.parent.mkdir(parents=True, exist_ok=True)
    start, peak = time.perf_counter(), 0
    cpu: dict[int, float] = {}
    with log.open("wb") as output:
        # Unbuffered, so that the last line is its last output.
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
    """Bytes of a process, with its part of shared ones; all resident ones where no part is known."""
    if psutil.LINUX:
        return int(process.memory_full_info().pss)
    return int(process.memory_info().rss)
