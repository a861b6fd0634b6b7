"""Terminate a process soon after its parent exits, for whatever reason.

The run, DVC, a stage and its workers form a chain of processes. Any of them may be killed, so each watches
its parent. The kernel signal PR_SET_PDEATHSIG does not help: it exists only on Linux, and it is sent too
early if a thread started the process, as in joblib.
"""

import os
import signal
import threading
import time
from types import FrameType

import psutil

# Seconds between checks, and seconds allowed for cleaning up.
INTERVAL, GRACE = 0.5, 10.0
# Environment variable that holds DVC's process ID for the stages, since their parent may be a shell.
DVC = "PLACECAT_DVC"
_SIGNALS = signal.SIGINT, signal.SIGTERM

_watching = False


class Stopped(KeyboardInterrupt):
    """A request to clean up and exit; the argument is the signal number."""


def end_with(parent: int) -> None:
    """Send SIGTERM to this process once `parent` is gone; kill it if necessary. Later calls do nothing."""
    global _watching
    if not _watching:
        _watching = True
        threading.Thread(target=_watch, args=(parent, os.getppid()), daemon=True).start()


def end_stage_with_dvc() -> None:
    """Make this stage clean up on SIGTERM, on Ctrl-C, and once DVC is gone."""
    stop_on_signals()
    if "DVC_STAGE" in os.environ:
        end_with(int(os.environ.get(DVC, os.getppid())))


def stop_on_signals() -> None:
    """Raise `Stopped` on the first Ctrl-C or SIGTERM only, as the terminal and the run may both send one."""
    for number in _SIGNALS:
        signal.signal(number, _stop)


def _stop(number: int, frame: FrameType | None) -> None:
    for each in _SIGNALS:
        signal.signal(each, lambda *_: None)
    raise Stopped(number)


def _watch(parent: int, direct_parent: int) -> None:
    while os.getppid() == direct_parent and psutil.pid_exists(parent):
        time.sleep(INTERVAL)
    os.kill(os.getpid(), signal.SIGTERM)
    time.sleep(GRACE)
    os._exit(1)
