"""Measure the time and memory of a command and all its processes while it runs."""

import os
import subprocess
import time
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import psutil

from placecat.errors import PlacecatError

GIB = 2**30
# Seconds between samples.
INTERVAL = 0.25


@dataclass(frozen=True)
class Watched:
    """The wall time of a command in seconds, and the CPU seconds and peak memory (GiB) of all its processes.

    CPU seconds depend less on machine load. On Linux, which reports the proportional set size, memory shared
    by processes is counted only once.
    """

    seconds: float
    cpu_seconds: float
    peak_gib: float


def watch(command: Sequence[str], folder: Path, log: Path) -> Watched:
    """Run a command in a folder and write its output to `log`.

    Raises PlacecatError with the last line of output if the command fails.
    """
    log.parent.mkdir(parents=True, exist_ok=True)
    start, peak = time.perf_counter(), 0
    cpu: dict[int, float] = {}
    with log.open("wb") as output:
        # Unbuffered, so that the file ends with the last line of output.
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
        raise PlacecatError(f"{' '.join(command[1:])} ended with status {status}: {said} (output: {log})")
    return Watched(seconds, sum(cpu.values()), peak / GIB)


def _look(pid: int, cpu: dict[int, float]) -> int:
    """Return the memory of a process and its descendants in bytes, and store their CPU seconds in `cpu`."""
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
            memory = one.memory_full_info().pss if psutil.LINUX else one.memory_info().rss
            total += int(memory)
        # The process has ended.
        except (psutil.NoSuchProcess, psutil.AccessDenied):
            continue
    return total
