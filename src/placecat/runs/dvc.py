"""Run DVC for `placecat repro`: ``python -m placecat.runs.dvc repro``.

Plain DVC overwrites dvc.lock in place, and loses its records if it is killed while writing. This module makes
DVC write the file under another name and rename it, print the number of stages and the time left, and hide
messages about frozen stages. On SIGTERM, or once its parent is gone, it stops its stage before it exits.
"""

import logging
import os
import re
import signal
import sys
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from types import FrameType
from typing import Any, TextIO

import psutil

from placecat import files
from placecat.compute import lifeline
from placecat.runs import repro, times

_RUNNING = re.compile(r"Running stage '([^']+)':")
_PASSED = re.compile(r"Stage '([^']+)' didn't change, skipping")
_FROZEN = re.compile(r".* is frozen\. Its dependencies|Verifying outputs in frozen stage")


def main() -> None:
    """Run DVC with the arguments of this process."""
    signal.signal(signal.SIGTERM, _stop)
    lifeline.end_with(os.getppid())
    os.environ[lifeline.DVC] = str(os.getpid())
    from dvc.utils.serialize import _common

    # If a new version of DVC renames this function, a test will fail, but `placecat mend` will still work.
    _common._dump_data = _write_whole
    from dvc.cli import main as dvc

    left = _Left(repro.stages(), times.known())
    for handler in logging.getLogger("dvc").handlers:
        handler.addFilter(left)
    sys.exit(dvc(sys.argv[1:]))


class _Left(logging.Filter):
    """Add the stage number and the estimated time left to lines that announce a stage.

    The estimate is based on `seconds`, the time that each stage took in an earlier run.
    """

    def __init__(self, stages: Sequence[str], seconds: Mapping[str, float]) -> None:
        super().__init__()
        self._left = list(stages)
        self._count = len(stages)
        self._seconds = seconds

    def filter(self, record: logging.LogRecord) -> bool:
        text = record.getMessage()
        if _FROZEN.match(text):
            return False
        running, passed = _RUNNING.fullmatch(text), _PASSED.fullmatch(text)
        if running and running[1] in self._left:
            number = self._count - len(self._left) + 1
            seconds = sum(self._seconds.get(name, 0.0) for name in self._left)
            left = f"{seconds / 60:.0f} min" if seconds >= 90 else f"{seconds:.0f} s"
            record.msg, record.args = f"{text} {number} of {self._count}, at most {left} left", ()
        for found in filter(None, (running, passed)):
            if found[1] in self._left:
                self._left.remove(found[1])
        return True


def _stop(number: int, frame: FrameType | None) -> None:
    signal.signal(number, lambda *_: None)
    stage = psutil.Process().children()
    for process in stage:
        process.terminate()
    # DVC ignores Ctrl-C while it waits for a stage, and exits once the stage has failed.
    if not stage:
        raise KeyboardInterrupt


def _write_whole(
    path: str, data: Any, dumper: Callable[[Any, TextIO], None], fs: Any = None, **options: Any
) -> None:
    with files.replacing(Path(path)) as temporary, temporary.open("w", encoding="utf-8") as file:
        dumper(data, file, **options)


if __name__ == "__main__":
    main()
