"""Choose the results folder, and protect files that must not be replaced."""

import json
import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from itertools import count
from pathlib import Path
from typing import Any

from filelock import FileLock, Timeout

from placecat import files
from placecat.errors import PlacecatError, refusal
from placecat.predict.tables import TABLES

SUMMARY = "summary.json"
CHECKED = "sha256"
"""The summary lists the checksums of the tables under this key. They show whether a table has been edited
since."""


@contextmanager
def reserved(
    output: Path | None, name: str, source: str, read: list[Path], *, is_live: bool, force: bool
) -> Iterator[Path]:
    """Reserve the results folder for this prediction alone.

    The folder is `output` or, by default, predictions/NAME. For a camera, the default is the first of NAME,
    NAME_2, ... that does not exist and is not being written by another prediction. See :func:`check` for the
    other parameters. Raises PlacecatError in the same cases as :func:`check`, and if the folder is in use.
    """
    # Without its suffix, a file name such as `...mp4` consists only of dots.
    name = name if name.strip(". ") else "footage"
    is_numbered = is_live and output is None
    for number in count(1):
        folder = output or Path("predictions") / (name if number == 1 else f"{name}_{number}")
        # Keep a symbolic link and write to its target.
        folder = folder.resolve() if folder.is_symlink() else folder
        if is_numbered and folder.exists():
            continue
        check(folder, source, read, force=force)
        is_new = not folder.parent.exists()
        # The operating system releases the lock if this process is killed.
        lock = FileLock(folder.with_name(f".{folder.name}.lock"))
        try:
            folder.parent.mkdir(parents=True, exist_ok=True)
            # FileLock would mistake an unwritable file for a held lock.
            Path(lock.lock_file).touch()
            lock.acquire(timeout=0)
        except Timeout:
            if is_numbered:
                continue
            raise PlacecatError(
                f"{folder} is being written by another prediction: wait for it, or choose another --output"
            ) from None
        except OSError as error:
            raise PlacecatError(f"cannot write {refusal(error, folder)}") from None
        try:
            # Another prediction may have finished in the meantime.
            if is_numbered and folder.exists():
                continue
            check(folder, source, read, force=force)
            yield folder
            return
        finally:
            Path(lock.lock_file).unlink(missing_ok=True)
            lock.release()
            if is_new and not any(folder.parent.iterdir()):
                folder.parent.rmdir()


def check(folder: Path, source: str, read: list[Path], *, force: bool) -> None:
    """Check that replacing the results folder would not lose files that cannot be recreated.

    Only a prediction is ever replaced. Without `force`, it must be unedited and come from the same `source`,
    and the source must not be a camera. With `force`, any prediction is replaced, and :func:`keep` saves what
    a user added or edited. `source` is the footage as the user typed it, but without any password. None of
    the input files in `read` may be in `folder`. Raises a PlacecatError that explains why the folder cannot
    be replaced.
    """
    files.check_target(folder)
    for path in read:
        if path.resolve().is_relative_to(folder.resolve()):
            raise PlacecatError(
                f"{path} is in {folder}, which would be replaced: move it, or choose another --output"
            )
    if not folder.exists() and not folder.is_symlink():
        return
    if not folder.is_dir():
        raise PlacecatError(f"{folder} is a file: choose another --output")
    if not any(folder.iterdir()):
        return
    summary = _summary(folder)
    if summary is None:
        raise PlacecatError(f"{folder} contains something other than a prediction: choose another --output")
    if force:
        return
    if summary.get("source") != source or summary.get("camera"):
        raise PlacecatError(
            f"{folder} contains the prediction for {summary.get('source')}: choose another "
            "--output, or use --force to replace it"
        )
    changed = _changed(folder, summary)
    if changed:
        raise PlacecatError(
            f"{folder / changed[0]} was added or edited: move it elsewhere, or use --force, which keeps a "
            "copy of it"
        )


def keep(folder: Path, new: Path) -> dict[str, str]:
    """Carry a user's added or edited files over from an old prediction to its replacement.

    `folder` is the old prediction, and `new` is its replacement. Returns a dictionary that maps the name of
    each copied file or folder to the name of its copy. A copy has the same name as the original unless the
    new prediction uses that name. In that case, it is called ``NAME.edited.csv``, ``NAME.edited_2.csv``, ...
    The summary does not list copies, so the next prediction keeps them too.
    """
    summary = _summary(folder)
    kept: dict[str, str] = {}
    changed = [] if summary is None else _changed(folder, summary)
    # Names without a conflict come first, so that earlier copies keep their names.
    for name in sorted(changed, key=lambda one: (new / one).exists()):
        old, copy = folder / name, new / name
        for number in count(1):
            if not copy.exists() and not copy.is_symlink():
                break
            copy = new / f"{old.stem}.edited{'' if number == 1 else f'_{number}'}{old.suffix}"
        if old.is_dir() and not old.is_symlink():
            shutil.copytree(old, copy, symlinks=True)
        else:
            shutil.copy2(old, copy, follow_symlinks=False)
        kept[name] = copy.name
    return kept


def _summary(folder: Path) -> dict[str, Any] | None:
    try:
        found = json.loads((folder / SUMMARY).read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return None
    if not isinstance(found, dict) or not isinstance(found.get("files"), list):
        return None
    checked = found.get(CHECKED)
    return found if isinstance(checked, dict) and set(checked) == set(TABLES) else None


def _changed(folder: Path, summary: dict[str, Any]) -> list[str]:
    """List the files added or edited since the prediction was written."""
    digests = summary[CHECKED]
    return [
        path.name
        for path in sorted(folder.iterdir())
        if path.name not in summary["files"]
        or (path.name in digests and files.checksum(path) != digests[path.name])
    ]
