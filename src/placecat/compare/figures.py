"""Read a run's figures from a folder or, for a git revision, from DVC."""

import json
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path

from placecat import paths
from placecat.compare import kept_in_git

_LIST = (paths.FIGURES / "figures.json").as_posix()


@dataclass(frozen=True)
class Figures:
    """One side's PNGs and captions by figure name; without figures, `missing` is a reason and a remedy."""

    pictures: dict[str, bytes] = field(default_factory=dict)
    captions: dict[str, str] = field(default_factory=dict)
    missing: str = ""


def read_figures(side: str) -> Figures:
    """Read one side's figures (see :func:`placecat.compare.kept_in_git.read`)."""
    if not side or kept_in_git.is_folder(side):
        remedy = f"there are no figures in {Path(side) / paths.FIGURES}: run `dvc repro figures` there"
        return _read(lambda name: (Path(side) / name).read_bytes(), remedy, (OSError,))
    # Imported only here, since the import takes a second.
    from dvc.api import DVCFileSystem
    from dvc.exceptions import DvcException

    commit = kept_in_git.commit_of(side)
    remedy = (
        f"DVC has no figures of git {side}: run `dvc fetch --all-commits {paths.FIGURES}` if a "
        f"remote has them, or else `placecat repro` on {side} in a clone, and compare with that folder"
    )
    refused = (OSError, DvcException)
    try:
        system = DVCFileSystem(".", rev=commit)
    except refused:
        return Figures(missing=remedy)
    return _read(system.read_bytes, remedy, refused)


def _read(read: Callable[[str], bytes], remedy: str, refused: tuple[type[Exception], ...]) -> Figures:
    try:
        drawn = [one for one in json.loads(read(_LIST)) if one["file"] is not None]
        pictures = {one["name"]: read((paths.FIGURES / one["file"]).as_posix()) for one in drawn}
    except refused:
        return Figures(missing=remedy)
    return Figures(pictures, {one["name"]: one["title"] for one in drawn})
