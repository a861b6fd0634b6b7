"""Running `dvc repro`."""

import os
import signal
import subprocess
import sys
from pathlib import Path
from types import FrameType

import psutil
import yaml

from placecat import files, paths
from placecat.errors import PlacecatError
from placecat.lockfile import LOCK
from placecat.runs import lifeline, lock, mend
from placecat.runs.unchanged import DEFINITION

# Seconds that Ctrl-C of a terminal, which reaches DVC and its stage as well, has to end them.
_CTRL_C = 3.0


class _Stopped(BaseException):
    """This process was asked to end, by the signal that is its argument."""


def run(*, force: bool = False, **environment: str) -> int:
    """Run `dvc repro`, whose output goes to the terminal, after mending what a killed run left.

    On Ctrl-C and SIGTERM the stage tidies up, DVC ends, and so does this call then.

    Parameters
    ----------
    force
        Whether stages run even if nothing they depend on has changed.
    **environment
        Further environment variables, which the stages see.

    Returns
    -------
    int
        Its exit status.

    Raises
    ------
    PlacecatError
        If another run goes on in this folder, or it is none of git.
    """
    # DVC waits for one that looks at the project meanwhile, instead of losing a stage that has just finished.
    command = [sys.executable, "-m", "placecat.runs.dvc", "--wait-for-lock", "repro"]
    # The Python that runs this first on the path, since the stages call `python`.
    path = os.pathsep.join([str(Path(sys.executable).parent), os.environ.get("PATH", "")])
    with lock.alone():
        _check_git()
        for line in mend.mend():
            print(line, file=sys.stderr, flush=True)
        before = {each: signal.signal(each, _stop) for each in (signal.SIGINT, signal.SIGTERM)}
        dvc = None
        try:
            dvc = subprocess.Popen(
                [*command, *(["--force"] if force else [])], env=os.environ | {"PATH": path} | environment
            )
            return dvc.wait()
        except _Stopped as stopped:
            return 1 if dvc is None else _end(dvc, stopped.args[0])
        finally:
            mend.keep()
            for each, handler in before.items():
                signal.signal(each, handler)


class Before:
    """params.yaml before it is written for a run, which may be refused."""

    def __init__(self) -> None:
        self._params, self._lock = _content(paths.PARAMS), _content(LOCK)

    def restore(self) -> None:
        """Put it back if no stage has ended since, as none has where the settings or the data were refused.

        Once one has, the run goes on with the new settings.
        """
        if _content(LOCK) != self._lock or _content(paths.PARAMS) == self._params:
            return
        if self._params is None:
            paths.PARAMS.unlink()
        else:
            with files.replacing(paths.PARAMS) as temporary:
                temporary.write_bytes(self._params)
        print(f"No stage has ended: {paths.PARAMS} is as it was before.", file=sys.stderr)


def _content(path: Path) -> bytes | None:
    return path.read_bytes() if path.is_file() else None


def _check_git() -> None:
    """Refuse a folder without git, e.g. from a ZIP file, which DVC refuses without a remedy."""
    configurations = [path for path in (Path(".dvc/config"), Path(".dvc/config.local")) if path.is_file()]
    if not Path(".git").exists() and not any("no_scm" in path.read_text() for path in configurations):
        raise PlacecatError(
            "this folder is no git repository, which DVC expects: run `git init`, or, without git, "
            "`dvc config --local core.no_scm true`"
        )


def _stop(number: int, frame: FrameType | None) -> None:
    for each in (signal.SIGINT, signal.SIGTERM):
        signal.signal(each, lambda *_: None)
    raise _Stopped(number)


def _end(dvc: subprocess.Popen[bytes], number: int) -> int:
    """End DVC, which ends its stage first; gives its exit status."""
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
    """Names of the stages that `dvc repro` has to run in a fresh clone.

    No frozen ones, and none all of whose outputs git keeps: these are there, and may be as they should.
    """
    definition = yaml.safe_load(DEFINITION.read_text(encoding="utf-8"))["stages"]
    return [
        name
        for name, stage in definition.items()
        if not stage.get("frozen", False) and any(map(_is_cached, stage["outs"]))
    ]


def _is_cached(out: str | dict[str, dict[str, bool]]) -> bool:
    """Whether DVC keeps an output, not git."""
    return isinstance(out, str) or any(options.get("cache", True) for options in out.values())
