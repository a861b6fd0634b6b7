"""Items of a stage's output, e.g. one per cue or home, which are made again only if their inputs change.

Each item has a manifest: checksums of its inputs and of its files, without times or absolute paths.
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

from placecat import files, lockfile, parallel
from placecat.runs import unchanged

MANIFEST = "manifest.json"

# The work for an item: the arguments of each call, and a function that writes the results to a folder.
Work = tuple[Sequence[tuple[Any, ...]], Callable[[Path, list[Any]], None]]


@dataclass(frozen=True)
class Inputs:
    """The inputs of an item: all settings that it depends on, in JSON types, and files and folders.

    A path in another item is represented by the checksums in that item's manifest.
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
    """Make the items that are missing, damaged or made from other inputs; remove unwanted ones.

    Each item is written under a temporary name and renamed, so a killed stage continues where it stopped.
    The code of `stage` (its dependencies in src/ that dvc.yaml lists) is an input of every item. `wanted`
    maps the names of items, which are also their folders, to their inputs. `make` gets a name and the folder
    to write, which does not exist yet. `begin`, if given, gets the names of all items to make, before the
    first is made.
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

    `function` is as for :func:`placecat.parallel.in_parallel`, the same for all items. `plan` gets the name
    of an item; the item is written when its tasks are done.
    """
    planned = [(name, made_from, *plan(name)) for name, made_from in _outdated(stage, folder, wanted)]
    if not planned:
        return
    results = parallel.stream(function, [task for _, _, tasks, _ in planned for task in tasks], stage)
    for name, made_from, tasks, write in planned:
        with _item(folder / name, made_from) as temporary:
            write(temporary, list(itertools.islice(results, len(tasks))))
    # The pool and its progress bar end only at the next request.
    next(results, None)


def _outdated(stage: str, folder: Path, wanted: Mapping[str, Inputs]) -> Iterator[tuple[str, str]]:
    """Items to make, each with the checksum of its inputs; remove unwanted ones."""
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
    """Yield a temporary folder for the files of an item; add the manifest and rename it at the end."""
    with files.replacing(folder) as temporary:
        yield temporary
        unchanged.check()
        files.write_json(temporary / MANIFEST, {"files": _files_in(temporary), "made_from": made_from})


def keep_only(folder: Path, names: Collection[str]) -> None:
    """Remove everything else in a folder, e.g. items of other settings; make the folder if missing."""
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
    """Checksum of a file or of all files in a folder; an item's checksums come from its manifest."""
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
    """Checksums of all files below a path, except manifests and caches of Python."""
    found: Iterable[Path] = sorted(path.rglob("*")) if path.is_dir() else [path]
    return {
        one.relative_to(path).as_posix(): files.checksum(one)
        for one in found
        if one.is_file() and one.name != MANIFEST and "__pycache__" not in one.parts
    }


def _of(checksums: Mapping[str, str]) -> str:
    return hashlib.sha256(json.dumps(checksums, sort_keys=True).encode()).hexdigest()


def _code_of(stage: str) -> str:
    """Checksum of the code that dvc.yaml lists for a stage; "" in a folder without a pipeline."""
    stages = lockfile.defined_stages()
    code = [Path(dep) for dep in stages.get(stage, {}).get("deps", []) if dep.startswith("src/")]
    return _of({path.as_posix(): _of(_files_in(path)) for path in code}) if stages else ""
