"""End a process soon after the one that started it has ended, for whatever reason.

The run, DVC, a stage and its workers are a chain of processes, of which somebody may kill any one. Each
watches its parent. The kernel's own signal (PR_SET_PDEATHSIG) is not used: it is for Linux alone, and comes
too early where a thread started the process, as joblib does.
"""

import os
import signal
import threading
import time
from types import FrameType

import psutil

# Seconds: how often a process looks, and how long it has to tidy up.
INTERVAL, GRACE = 0.5, 10.0
# The process of DVC, in the environment of its stages: a shell may be in between.
DVC = "PLACECAT_DVC"

_watching = False


def end_with(parent: int) -> None:
    """Send this process SIGTERM once `parent` is gone, and kill it if it goes on. Later calls do nothing."""
    global _watching
    if not _watching:
        _watching = True
        threading.Thread(target=_watch, args=(parent, os.getppid()), daemon=True).start()


def end_stage_with_dvc() -> None:
    """Tidy up on SIGTERM as on Ctrl-C, whichever comes first, and do both if DVC is gone."""
    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, _stop)
    if "DVC_STAGE" in os.environ:
        end_with(int(os.environ.get(DVC, os.getppid())))


def _stop(number: int, frame: FrameType | None) -> None:
    # Once: the terminal and the run that it belongs to may both ask, and tidying up is not to be broken off.
    # Functions, not SIG_IGN, which processes started now would inherit.
    for each in (signal.SIGINT, signal.SIGTERM):
        signal.signal(each, lambda *_: None)
    raise KeyboardInterrupt


def _watch(parent: int, direct_parent: int) -> None:
    while os.getppid() == direct_parent and psutil.pid_exists(parent):
        time.sleep(INTERVAL)
    os.kill(os.getpid(), signal.SIGTERM)
    time.sleep(GRACE)
    os._exit(1)
