"""Run `dvc repro`."""

import os
import signal
import subprocess
import sys
from pathlib import Path

import psutil

from placecat import files, paths
from placecat.compute import lifeline
from placecat.errors import PlacecatError
from placecat.runs import lock, mend
from placecat.runs.lockfile import LOCK, defined_stages

# Seconds that DVC and its stage may take to exit after Ctrl-C, which the terminal also sends to them.
_CTRL_C = 3.0


def run(*, force: bool = False, **environment: str) -> int:
    """Clean up after a killed run, then run `dvc repro` in the terminal; return its exit status.

    On Ctrl-C or SIGTERM, the stage cleans up, DVC exits, and then this function returns. With `force`,
    stages run even if no dependency has changed. `environment` contains additional environment variables for
    the stages. Raises PlacecatError if another run is in progress here, or if this folder is not a git
    repository.
    """
    # DVC waits while another process reads the project; otherwise, it would lose a stage that has just
    # finished.
    command = [sys.executable, "-m", "placecat.runs.dvc", "--wait-for-lock", "repro"]
    # Stages call `python`, so this Python must be first on the path.
    path = os.pathsep.join([str(Path(sys.executable).parent), os.environ.get("PATH", "")])
    with lock.alone():
        _check_git()
        for line in mend.mend():
            print(line, file=sys.stderr, flush=True)
        before = {each: signal.getsignal(each) for each in (signal.SIGINT, signal.SIGTERM)}
        lifeline.stop_on_signals()
        dvc = None
        try:
            dvc = subprocess.Popen(
                [*command, *(["--force"] if force else [])], env=os.environ | {"PATH": path} | environment
            )
            return dvc.wait()
        except lifeline.Stopped as stopped:
            return 1 if dvc is None else _end(dvc, stopped.args[0])
        finally:
            mend.keep()
            for each, handler in before.items():
                signal.signal(each, handler)


class Before:
    """A copy of the old params.yaml, which can be restored if the run is rejected."""

    def __init__(self) -> None:
        self._params, self._lock = _content(paths.PARAMS), _content(LOCK)

    def restore(self) -> None:
        """Restore params.yaml, unless a stage has finished and the next run needs the new settings."""
        if _content(LOCK) != self._lock or _content(paths.PARAMS) == self._params:
            return
        if self._params is None:
            paths.PARAMS.unlink()
        else:
            with files.replacing(paths.PARAMS) as temporary:
                temporary.write_bytes(self._params)
        print(f"No stage has finished, so {paths.PARAMS} was restored.", file=sys.stderr)


def _content(path: Path) -> bytes | None:
    return path.read_bytes() if path.is_file() else None


def _check_git() -> None:
    """Raise a PlacecatError with a remedy if there is no git repository, for example after a ZIP download."""
    configurations = [path for path in (Path(".dvc/config"), Path(".dvc/config.local")) if path.is_file()]
    if not Path(".git").exists() and not any("no_scm" in path.read_text() for path in configurations):
        raise PlacecatError(
            "this folder is not a git repository, but DVC needs one: run `git init`, or, without git, "
            "`dvc config --local core.no_scm true`"
        )


def _end(dvc: subprocess.Popen[bytes], number: int) -> int:
    """Stop the stage, then DVC; return DVC's exit status."""
    try:
        processes = psutil.Process(dvc.pid).children(recursive=True)
    except psutil.NoSuchProcess:
        processes = []
    try:
        try:
            return dvc.wait(_CTRL_C if number == signal.SIGINT else 0)
        except subprocess.TimeoutExpired:
            dvc.terminate()
            return dvc.wait(lifeline.GRACE)
    except subprocess.TimeoutExpired:
        dvc.kill()
        return dvc.wait()
    finally:
        _, alive = psutil.wait_procs(processes, timeout=2)
        for process in alive:
            process.kill()


def stages() -> list[str]:
    """List the stages that `dvc repro` runs in a fresh clone: unfrozen stages with outputs outside git."""

    def is_cached(out: str | dict[str, dict[str, bool]]) -> bool:
        return isinstance(out, str) or any(options.get("cache", True) for options in out.values())

    return [
        name
        for name, stage in defined_stages().items()
        if not stage.get("frozen", False) and any(map(is_cached, stage["outs"]))
    ]
