"""DVC as `placecat repro` runs it: ``python -m placecat.runs.dvc repro``.

It writes dvc.lock under another name and renames it, where plain DVC writes in place, so that a run killed
just then does not lose its records. On SIGTERM it ends its stage first, and does so when the run that started
it is gone.
"""

import os
import signal
import sys
from collections.abc import Callable
from pathlib import Path
from types import FrameType
from typing import Any, TextIO

import psutil

from placecat import files
from placecat.runs import lifeline


def main() -> None:
    """Run DVC with the arguments of this process."""
    signal.signal(signal.SIGTERM, _stop)
    lifeline.end_with(os.getppid())
    os.environ[lifeline.DVC] = str(os.getpid())
    from dvc.utils.serialize import _common

    # What a later DVC calls otherwise, `placecat mend` still mends; a test tells of it.
    _common._dump_data = _write_whole
    from dvc.cli import main as dvc

    sys.exit(dvc(sys.argv[1:]))


def _stop(number: int, frame: FrameType | None) -> None:
    signal.signal(number, lambda *_: None)
    stage = psutil.Process().children()
    for process in stage:
        process.terminate()
    # DVC waits for its stage and ends since that failed; it does not heed Ctrl-C meanwhile.
    if not stage:
        raise KeyboardInterrupt


def _write_whole(
    path: str, data: Any, dumper: Callable[[Any, TextIO], None], fs: Any = None, **options: Any
) -> None:
    with files.replacing(Path(path)) as temporary, temporary.open("w", encoding="utf-8") as file:
        dumper(data, file, **options)


if __name__ == "__main__":
    main()
