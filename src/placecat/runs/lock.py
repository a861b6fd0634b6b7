"""Locks that allow one run at a time in a folder."""

import json
import sys
import time
from collections.abc import Iterator
from contextlib import AbstractContextManager, contextmanager, nullcontext
from pathlib import Path
from typing import Any

from placecat.errors import PlacecatError

# DVC's folder for temporary files; git ignores it.
TEMPORARY = Path(".dvc/tmp")
# DVC's record of the paths that each process reads and writes.
DVC_IN_USE = TEMPORARY / "rwlock"
# Seconds that DVC and its stage may take to exit after their run is killed.
_ENDING = 12.0
_FOREVER = -1.0


@contextmanager
def alone() -> Iterator[None]:
    """Prevent other runs and changes to params.yaml; raise PlacecatError if another run holds the lock.

    Calls may be nested.
    """
    if not TEMPORARY.parent.is_dir():
        yield
        return
    TEMPORARY.mkdir(exist_ok=True)
    held = _acquired(TEMPORARY.resolve() / "placecat.lock", 1, is_singleton=True)
    if held is None:
        raise PlacecatError(_goes_on("placecat"))
    with held as lock:
        if lock.lock_counter == 1:
            _wait_for_dvc()
        yield


def one_at_a_time(stage: str) -> AbstractContextManager[object]:
    """Wait while another process runs the same stage; it may be cleaning up because its DVC was killed."""
    if not TEMPORARY.parent.is_dir():
        return nullcontext()
    TEMPORARY.mkdir(exist_ok=True)
    said = f"Another process is running the stage {stage} here: waiting for it."
    return waiting(TEMPORARY / f"placecat.{stage}.lock", said)


def waiting(path: Path, said: str) -> AbstractContextManager[object]:
    """Hold a lock during a block; print `said` if this process must wait for it."""
    held = _acquired(path, 2)
    if held is None:
        print(said, file=sys.stderr, flush=True)
        held = _acquired(path, _FOREVER)
    return held


def of_folder(folder: Path, work: str) -> AbstractContextManager[object]:
    """Lock a folder during a block; create the folder if it is missing.

    Raises PlacecatError if another process holds the lock. In its message, `work` describes what that process
    does with the folder, such as "runs in".
    """
    folder.mkdir(parents=True, exist_ok=True)
    held = _acquired(folder / ".lock", 2)
    if held is None:
        raise PlacecatError(f"another process {work} {folder}: wait until it ends, or stop it")
    return held


def _acquired(path: Path, seconds: float, *, is_singleton: bool = False) -> Any:
    """Acquire a lock for a block; return None if another process still holds it after `seconds`."""
    # Imported late: the import takes longer than the rest of a short command.
    from filelock import FileLock, Timeout

    try:
        return FileLock(path, is_singleton=is_singleton).acquire(timeout=seconds)
    except Timeout:
        return None


def _goes_on(who: str) -> str:
    return f"a run is in progress in this folder ({who}): wait until it ends, or stop it"


def _wait_for_dvc() -> None:
    end, is_said = time.monotonic() + _ENDING, False
    while user := _dvc_in_use():
        if not is_said:
            print(f"Process {user[0]} ({user[1]}) is running a stage here.", file=sys.stderr, flush=True)
            is_said = True
        if time.monotonic() > end:
            raise PlacecatError(_goes_on(f"process {user[0]}: {user[1]}"))
        time.sleep(0.2)


def _dvc_in_use() -> tuple[int, str] | None:
    """Return the process ID and command of a DVC process that is running a stage in this folder, or None."""
    import psutil

    try:
        content = json.loads(DVC_IN_USE.read_text(encoding="utf-8"))
        writers = list(content["write"].values())
        users = [(int(user["pid"]), str(user["cmd"])) for user in writers]
    except (OSError, ValueError, KeyError, TypeError, AttributeError):
        # The record is incomplete: DVC was killed while writing it.
        return None
    for process, command in users:
        try:
            # Another program may have this process ID by now.
            if any("dvc" in part for part in psutil.Process(process).cmdline()):
                return process, command
        except psutil.Error:
            continue
    return None
