"""Running `dvc repro`."""

import os
import signal
import subprocess
import sys
from pathlib import Path

import yaml

DEFINITION = Path("dvc.yaml")


def run(*, force: bool = False, **environment: str) -> int:
    """Run `dvc repro`, whose output goes to the terminal.

    Ctrl-C reaches DVC and its stage as well. They tidy up and end by themselves, and so does this call then.

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
    """
    command = [sys.executable, "-m", "dvc", "repro", *(["--force"] if force else [])]
    # The Python that runs this first on the path, since the stages call `python`.
    path = os.pathsep.join([str(Path(sys.executable).parent), os.environ.get("PATH", "")])
    # On Ctrl-C subprocess.run would kill DVC after 0.25 s, amid its tidying up, which spoils its lock file.
    # A function, not SIG_IGN, since DVC would inherit that.
    before = signal.signal(signal.SIGINT, lambda *_: None)
    try:
        with subprocess.Popen(command, env=os.environ | {"PATH": path} | environment) as dvc:
            return dvc.wait()
    finally:
        signal.signal(signal.SIGINT, before)


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
