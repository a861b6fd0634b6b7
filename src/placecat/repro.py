"""Running `dvc repro`."""

import os
import subprocess
import sys
from pathlib import Path

import yaml

DEFINITION = Path("dvc.yaml")


def run(*, force: bool = False, **environment: str) -> int:
    """Run `dvc repro`, whose output goes to the terminal.

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
    arguments = ["repro", *(["--force"] if force else [])]
    return subprocess.run(_dvc(*arguments), env=_environment() | environment, check=False).returncode


def stages() -> list[str]:
    """Names of the stages that `dvc repro` runs from nothing, e.g. ``features@home_1``: no frozen ones."""
    listed = subprocess.run(
        _dvc("stage", "list", "--name-only"), env=_environment(), check=True, capture_output=True, text=True
    ).stdout.split()
    definition = yaml.safe_load(DEFINITION.read_text(encoding="utf-8"))["stages"]
    return [name for name in listed if not definition[name.partition("@")[0]].get("frozen", False)]


def _dvc(*arguments: str) -> list[str]:
    return [sys.executable, "-m", "dvc", *arguments]


def _environment() -> dict[str, str]:
    """This environment with the Python that runs this first on the path, since the stages call `python`."""
    here = str(Path(sys.executable).parent)
    return os.environ | {"PATH": os.pathsep.join([here, os.environ.get("PATH", "")])}
