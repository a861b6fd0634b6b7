"""Check that the settings, code and data of a stage do not change while it runs.

DVC records settings and dependencies once a stage has ended. Without this check, DVC would record changes
made while the stage ran, although the results do not reflect them.
"""

import contextlib
from collections.abc import Iterator
from pathlib import Path

from placecat import files, paths, settings
from placecat.errors import PlacecatError
from placecat.runs import lockfile

_at_start: tuple[str, dict[str, str]] | None = None


def start(stage: str) -> None:
    """Record the state of all dependencies of a stage before it reads them. Later calls do nothing."""
    global _at_start
    if _at_start is None:
        _at_start = (stage, state(stage))


def check() -> None:
    """Raise PlacecatError if anything has changed since :func:`start`; the message names the first path."""
    if _at_start is None:
        return
    stage, before = _at_start
    now = state(stage)
    for path in sorted(before.keys() | now.keys()):
        if before.get(path) != now.get(path):
            raise PlacecatError(
                f"{path} was changed while the stage {stage} ran, so its results are not recorded: "
                "run the stage again"
            )


def state(stage: str) -> dict[str, str]:
    """Return the states of params.yaml and of every file that dvc.yaml lists for a stage, by path.

    For settings and code, the state is a checksum; for other files, which may be large, it is the size and
    modification time.
    """
    found = {}
    for dep in [str(paths.PARAMS), *_dependencies(stage)]:
        by_content = dep == str(paths.PARAMS) or dep.startswith("src/")
        for file in (Path(dep), *Path(dep).rglob("*")):
            if not file.is_file() or "__pycache__" in file.parts:
                continue
            # Another process may have just removed the file.
            with contextlib.suppress(FileNotFoundError):
                stat = file.stat()
                content = files.checksum(file) if by_content else f"{stat.st_size} {stat.st_mtime_ns}"
                found[str(file)] = content
    return found


def _dependencies(stage: str) -> Iterator[str]:
    for dep in lockfile.defined_stages().get(stage, {}).get("deps", []):
        # The path of the data set is a setting: ${dataset.root}.
        yield str(settings.get(settings.load(), dep[2:-1])) if dep.startswith("${") else dep
