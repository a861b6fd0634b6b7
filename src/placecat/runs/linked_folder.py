"""Run stages on other data, in a folder with its own settings and links to the other inputs."""

import os
import sys
from collections.abc import Iterable, Sequence
from pathlib import Path

from placecat.errors import PlacecatError
from placecat.runs.lockfile import defined_stages


def link(folder: Path, paths: Iterable[Path]) -> None:
    """Link project paths into a folder at the same relative paths, replacing existing links.

    `paths` are relative to the current folder, which must be the project folder. Raises PlacecatError if a
    path does not exist.
    """
    for path in paths:
        if not path.exists():
            raise PlacecatError(f"{path} is missing: run `make repro` first")
        there = folder / path
        there.parent.mkdir(parents=True, exist_ok=True)
        there.unlink(missing_ok=True)
        there.symlink_to(os.path.relpath(path, there.parent))


def commands(stages: Sequence[str]) -> dict[str, list[str]]:
    """Return the command of each stage in dvc.yaml; raise PlacecatError if a stage is missing there."""
    defined = defined_stages()
    for stage in stages:
        if stage not in defined:
            raise PlacecatError(f"dvc.yaml has no stage {stage!r}: use one of {', '.join(defined)}")
    return {stage: [sys.executable, *defined[stage]["cmd"].split()[1:]] for stage in stages}
