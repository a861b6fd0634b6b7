"""Repair the damage done by a killed run: a truncated dvc.lock, DVC's locks and temporary files."""

import os
import re
import shutil
import time
from collections.abc import Iterator
from pathlib import Path

import psutil
import yaml

from placecat import files, settings
from placecat.runs import lock
from placecat.runs.lockfile import LOCK, defined_stages

# A backup of all complete records, needed because DVC overwrites dvc.lock in place after each stage.
COPY = lock.TEMPORARY / "dvc.lock.whole"
# Age in seconds above which temporary files count as abandoned.
OLD = 24 * 3600.0
# Temporary names used by placecat.files and placecat.runs.dvc, and the folders that may contain such files.
_PARTIAL = re.compile(r"\..+\.[0-9a-f]{8}\.partial(\.\w+)?")
_PARTIAL_IN = (".", "conf", "data", "data/*", "reports", "reports/*", "predictions")
# Temporary names in the DVC cache.
_CACHED = re.compile(r"\.[\w-]{22}\.tmp")
_CACHE = Path(".dvc/cache")
# Shared memory and semaphores used by joblib.
_SHARED = Path("/dev/shm")
_OF_PROCESS = re.compile(r"(?:joblib_memmapping_folder_|sem\.loky-)(\d+)[_-].*")


def mend() -> list[str]:
    """Repair the damage done by a killed run; return one line per repair. Call this inside `lock.alone`."""
    said = []
    if LOCK.exists():
        text = LOCK.read_text(encoding="utf-8", errors="replace")
        mended, lost = _mended(text)
        if mended != text:
            files.write_text(LOCK, mended)
            again = f"; these stages will run again: {', '.join(lost)}" if lost else ""
            said.append(f"{LOCK} was truncated when a run was killed: its records have been restored{again}.")
    keep()
    # All entries belong to killed processes.
    lock.DVC_IN_USE.unlink(missing_ok=True)
    for path in _leftovers():
        shutil.rmtree(path, ignore_errors=True) if path.is_dir() else path.unlink(missing_ok=True)
    return said


def keep() -> None:
    """Back up the complete records in dvc.lock; if a record is incomplete or missing, keep its earlier copy.

    Without a dvc.lock, the backup is deleted.
    """
    if not lock.TEMPORARY.is_dir():
        return
    if not LOCK.exists():
        COPY.unlink(missing_ok=True)
        return
    mended, _ = _mended(LOCK.read_text(encoding="utf-8", errors="replace"))
    if not COPY.exists() or COPY.read_text(encoding="utf-8") != mended:
        files.write_text(COPY, mended)


def _mended(text: str) -> tuple[str, list[str]]:
    """Return the contents of dvc.lock, completed from the backup, and the stages whose records are lost."""
    # Leave merge conflicts to the user.
    stages = defined_stages()
    if "\n<<<<<<< " in text or not stages:
        return text, []
    head, blocks = _blocks(text)
    kept_head, kept = _blocks(COPY.read_text(encoding="utf-8")) if COPY.exists() else ("", {})
    last = next(reversed(blocks), None)
    # Only the end of the file can be missing, so only the last record can be incomplete.
    whole = {
        name: block
        for name, block in blocks.items()
        if name != last or block == kept.get(name) or _is_whole(block)
    }
    missing = [name for name in kept if name not in whole]
    is_cut = not head or len(whole) < len(blocks)
    # Records of stages that no longer exist may have been removed on purpose.
    if not is_cut and not any(name.split("@")[0] in stages for name in missing):
        return text, []
    merged = {name: whole.get(name, block) for name, block in kept.items()}
    merged |= whole
    lost = [name for name in blocks if name not in merged]
    if not merged:
        return "schema: '2.0'\nstages: {}\n", lost
    return (head or kept_head or "schema: '2.0'\nstages:\n") + "".join(merged.values()), lost


def _blocks(text: str) -> tuple[str, dict[str, str]]:
    """Split a dvc.lock written by DVC into its head, or "" if the head is truncated, and its stages."""
    head, *rest = re.split(r"^(?=  [^\s#])", text, flags=re.MULTILINE)
    is_head = head.endswith("stages:\n") or (not rest and head.endswith("stages: {}\n"))
    return head if is_head else "", {block.split(":\n", 1)[0].strip(" '\"\n"): block for block in rest}


def _is_whole(block: str) -> bool:
    """Return whether the record of a stage is complete."""
    try:
        (record,) = yaml.load(block, Loader=settings.Loader).values()
        return block.endswith("\n") and all(
            {"path", "size"} <= one.keys() and ("nfiles" in one or not one.get("md5", "").endswith(".dir"))
            for one in [*record.get("deps", []), *record["outs"]]
        )
    except (yaml.YAMLError, AttributeError, KeyError, TypeError, ValueError):
        return False


def _leftovers() -> Iterator[Path]:
    """Yield temporary files that a killed process left behind more than a day ago."""
    for folder in _PARTIAL_IN:
        yield from (path for path in Path().glob(f"{folder}/.*.partial*") if _is_left(path, _PARTIAL))
    yield from (path for path in _CACHE.glob("**/.*.tmp") if _is_left(path, _CACHED))
    for path in _SHARED.glob("*") if _SHARED.is_dir() else ():
        of = _OF_PROCESS.fullmatch(path.name)
        if of and not psutil.pid_exists(int(of[1])) and _is_left(path, _OF_PROCESS):
            yield path


def _is_left(path: Path, name: re.Pattern[str]) -> bool:
    try:
        inner = path.rglob("*") if path.is_dir() and not path.is_symlink() else ()
        newest = max(one.lstat().st_mtime for one in (path, *inner))
        is_own = not hasattr(os, "getuid") or path.lstat().st_uid == os.getuid()
    except FileNotFoundError:
        return False
    return name.fullmatch(path.name) is not None and is_own and time.time() - newest > OLD
