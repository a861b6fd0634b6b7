"""Split the output of a stage into items, such as cues or homes; rebuild only those with changed inputs.

Each item has a manifest with checksums of its inputs and files, but no times or absolute paths.
"""

import hashlib
import itertools
import json
import shutil
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from placecat import files
from placecat.compute import parallel
from placecat.runs import lockfile, unchanged

MANIFEST = "manifest.json"

# The work for an item: the arguments of each call, and a function that writes the results to a folder.
Work = tuple[Sequence[tuple[Any, ...]], Callable[[Path, list[Any]], None]]


@dataclass(frozen=True)
class Inputs:
    """The inputs of an item: all settings it depends on, in JSON types, and the files and folders it reads.

    If a path is inside another item, its checksums are taken from the manifest of that item.
    """

    settings: Any
    paths: tuple[Path, ...]


def refresh(
    stage: str,
    folder: Path,
    wanted: Mapping[str, Inputs],
    make: Callable[[str, Path], None],
    *,
    begin: Callable[[Sequence[str]], None] | None = None,
) -> None:
    """Rebuild items that are missing, damaged or made from different inputs; remove unwanted ones.

    Each item is written under a temporary name and then renamed, so a killed stage can continue where it
    stopped. The code of `stage` (its src/ dependencies in dvc.yaml) is an input of every item. `wanted` maps
    the name of each item, which is also its folder, to its inputs. `make` is called with the name and the
    folder, which does not exist yet. If given, `begin` is called first, with the names of all items to make.
    """
    outdated = list(_outdated(stage, folder, wanted))
    if outdated and begin is not None:
        begin([name for name, _ in outdated])
    for name, made_from in outdated:
        with _item(folder / name, made_from) as temporary:
            make(name, temporary)


def refresh_together(
    stage: str,
    folder: Path,
    wanted: Mapping[str, Inputs],
    function: Callable[..., Any],
    plan: Callable[[str], Work],
) -> None:
    """Like :func:`refresh`, but the tasks of all items share one pool, which keeps all workers busy.

    `function` is the same for all items; see :func:`placecat.compute.parallel.in_parallel`. `plan` is called
    with the name of an item. An item is written once its tasks are done.
    """
    planned = [(name, made_from, *plan(name)) for name, made_from in _outdated(stage, folder, wanted)]
    if not planned:
        return
    results = parallel.stream(function, [task for _, _, tasks, _ in planned for task in tasks], stage)
    for name, made_from, tasks, write in planned:
        with _item(folder / name, made_from) as temporary:
            write(temporary, list(itertools.islice(results, len(tasks))))
    # The pool and its progress bar close only when another result is requested.
    next(results, None)


def _outdated(stage: str, folder: Path, wanted: Mapping[str, Inputs]) -> Iterator[tuple[str, str]]:
    """Yield each item to make and the checksum of its inputs; remove unwanted items."""
    keep_only(folder, wanted)
    code = _code_of(stage)
    for name, inputs in wanted.items():
        content = [code, json.dumps(inputs.settings, sort_keys=True), *map(checksum, inputs.paths)]
        made_from = hashlib.sha256("\n".join(content).encode()).hexdigest()
        manifest = _manifest(folder / name)
        if (
            manifest is None
            or manifest["made_from"] != made_from
            or manifest["files"] != _files_in(folder / name)
        ):
            yield name, made_from


@contextmanager
def _item(folder: Path, made_from: str) -> Iterator[Path]:
    """Yield a temporary folder for an item's files; then add the manifest and rename the folder."""
    with files.replacing(folder) as temporary:
        yield temporary
        unchanged.check()
        files.write_json(temporary / MANIFEST, {"files": _files_in(temporary), "made_from": made_from})


def keep_only(folder: Path, names: Collection[str]) -> None:
    """Remove everything but `names` from a folder; create the folder if it is missing."""
    folder.mkdir(parents=True, exist_ok=True)
    for path in folder.iterdir():
        if path.name not in names:
            shutil.rmtree(path) if path.is_dir() else path.unlink()


def _manifest(folder: Path) -> dict[str, Any] | None:
    try:
        manifest: dict[str, Any] = files.read_json(folder / MANIFEST)
        return manifest if manifest.keys() == {"files", "made_from"} else None
    except (FileNotFoundError, NotADirectoryError, ValueError, AttributeError):
        return None


def checksum(path: Path) -> str:
    """Return a checksum of a file or of all files in a folder; for items, it is based on their manifests."""
    for folder in (path, *path.parents):
        manifest = _manifest(folder)
        if manifest is not None:
            inner = path.relative_to(folder).as_posix()
            known = {
                name: of_file
                for name, of_file in manifest["files"].items()
                if inner == "." or name == inner or name.startswith(f"{inner}/")
            }
            return _of(known)
    return _of(_files_in(path))


def _files_in(path: Path) -> dict[str, str]:
    """Return the checksums of all files below a path, except manifests and Python caches."""
    found: Iterable[Path] = sorted(path.rglob("*")) if path.is_dir() else [path]
    return {
        one.relative_to(path).as_posix(): files.checksum(one)
        for one in found
        if one.is_file() and one.name != MANIFEST and "__pycache__" not in one.parts
    }


def _of(checksums: Mapping[str, str]) -> str:
    return hashlib.sha256(json.dumps(checksums, sort_keys=True).encode()).hexdigest()


def _code_of(stage: str) -> str:
    """Return a checksum of the code that dvc.yaml lists for a stage; "" in a folder without a pipeline."""
    stages = lockfile.defined_stages()
    code = [Path(dep) for dep in stages.get(stage, {}).get("deps", []) if dep.startswith("src/")]
    return _of({path.as_posix(): _of(_files_in(path)) for path in code}) if stages else ""
