"""The folder of results: what may be replaced, and what may not."""

import json
from pathlib import Path
from typing import Any

from placecat import files
from placecat.errors import PlacecatError

SUMMARY = "summary.json"
_CHECKED = "sha256"


def choose(output: Path | None, name: str, *, is_live: bool) -> Path:
    """The folder to write: `output`, or predictions/NAME; of a camera one that does not exist yet."""
    if output is not None:
        return output
    # A file may be called `...mp4`.
    name = name if name.strip(". ") else "footage"
    folder = Path("predictions") / name
    number = 1
    while is_live and folder.exists():
        number += 1
        folder = Path("predictions") / f"{name}_{number}"
    return folder


def check(folder: Path, source: str, read: list[Path], *, force: bool) -> None:
    """Refuse to replace what cannot be made again.

    Parameters
    ----------
    folder
        Where results will stand.
    source
        What is predicted, as the user gave it.
    read
        Files and folders that are read: they may not be in there.
    force
        Replace a prediction of another source or one that was edited. What is no prediction is never
        replaced.

    Raises
    ------
    PlacecatError
        Naming what is in the way.
    """
    files.check_target(folder)
    for path in read:
        if path.resolve().is_relative_to(folder.resolve()):
            raise PlacecatError(
                f"{path} is in {folder}, which would be replaced: move it, or give another --output"
            )
    if not folder.exists() and not folder.is_symlink():
        return
    if not folder.is_dir():
        raise PlacecatError(f"{folder} is a file: give another --output")
    if not any(folder.iterdir()):
        return
    summary = _summary(folder)
    if summary is None:
        raise PlacecatError(f"{folder} holds something else than a prediction: give another --output")
    if force:
        return
    if summary.get("source") != source or summary.get("camera"):
        raise PlacecatError(
            f"{folder} holds the prediction of {summary.get('source')}: give another --output, or --force to "
            "replace it"
        )
    changed = _changed(folder, summary)
    if changed:
        raise PlacecatError(
            f"{folder / changed} was added or edited: move it away, or give --force to lose it"
        )


def checksums(folder: Path, names: list[str]) -> dict[str, Any]:
    """What the summary has to hold for edited tables to be noticed later."""
    return {_CHECKED: {name: files.checksum(folder / name) for name in names}}


def _summary(folder: Path) -> dict[str, Any] | None:
    try:
        found = json.loads((folder / SUMMARY).read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return None
    is_ours = isinstance(found, dict) and isinstance(found.get(_CHECKED), dict) and "files" in found
    return found if is_ours else None


def _changed(folder: Path, summary: dict[str, Any]) -> str | None:
    """The first file that was added, or edited since, if any."""
    for path in sorted(folder.iterdir()):
        digest = summary[_CHECKED].get(path.name)
        if path.name not in summary["files"] or (digest is not None and files.checksum(path) != digest):
            return path.name
    return None
