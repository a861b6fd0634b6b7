"""Read the results in this folder, another folder or a git revision, and compare them."""

import io
import json
import subprocess
from collections.abc import Callable, Collection, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import pandas as pd
import yaml

from placecat import paths, settings
from placecat.compare import differences
from placecat.errors import PlacecatError
from placecat.thesis import definitions
from placecat.thesis.tables import dataset_of, tables_of

FOLDERS = (paths.TABLES, paths.OPTIONAL_TABLES)
# Settings that no table depends on.
_WITHOUT_EFFECT = ("compute", "reproducibility", "figures")


@dataclass(frozen=True)
class Kept:
    """The parts of a run that are compared.

    `tables` maps names such as ``table_26`` to filled tables, in which every value is a string; ``in_text``
    contains the numbers in the thesis's text. The columns of `findings` include number and verdict.
    `settings` is the content of params.yaml. `findings` and `settings` are None if missing.
    """

    tables: dict[str, pd.DataFrame]
    findings: pd.DataFrame | None
    settings: dict[str, Any] | None


@dataclass(frozen=True)
class Figures:
    """One side's PNGs and captions by figure name. If there are none, `missing` says why and what to do."""

    pictures: dict[str, bytes] = field(default_factory=dict)
    captions: dict[str, str] = field(default_factory=dict)
    missing: str = ""


def compare(old: str, new: str = "") -> tuple[list[str], bool]:
    """Compare the tables of two sides (see :func:`read`).

    Returns the lines of a report, and whether the two sides agree. They disagree if the settings are the same
    but a number has appeared, disappeared or changed by more than ``reproducibility.tolerance``. Numbers from
    different data sets are not compared. Raises PlacecatError if a side has no tables, git is not installed,
    the folder is not in a repository, or the revision does not exist.
    """
    tolerance = float(settings.get(settings.load(), "reproducibility.tolerance"))
    now, kept = read(new), read(old)
    # An optional table that the new run did not produce is a leftover from an earlier run.
    others = set(definitions.optional()) - definitions.tables(now.settings or {}).keys()
    tables_now, tables_kept = (
        {name: table for name, table in _with_data(one, now.settings).items() if name not in others}
        for one in (now, kept)
    )
    comparison = differences.compare(tables_now, tables_kept, now.findings, kept.findings)
    changed = changed_settings(now.settings, kept.settings)
    lines = differences.sentences(comparison, tolerance, name_of(old), list(changed))
    return lines, bool(changed) or not comparison.exceeds(tolerance)


def _with_data(one: Kept, params: dict[str, Any] | None) -> dict[str, pd.DataFrame]:
    """Add a column `data` to each table, with the title of each number's data set, or "" if unknown.

    `params` contains the settings that the table definitions refer to.
    """
    defined = {} if params is None else tables_of(params)
    found = {}
    for name, table in one.tables.items():
        if name == paths.IN_TEXT.stem:
            entries = definitions.in_text()
            titles = [_title(entries.get(entry, {}), one.settings) for entry in table["name"]]
        else:
            titles = [_title(defined.get(name, {}), one.settings)] * len(table)
        found[name] = table.assign(data=titles)
    return found


def _title(definition: Mapping[str, Any], params: dict[str, Any] | None) -> str:
    try:
        return "" if params is None else str(dataset_of(definition, params)["title"])
    except (PlacecatError, KeyError):
        # The table may have another name in an older revision.
        return ""


def is_folder(side: str) -> bool:
    """Return True for "" (this folder) or a folder with ``reports/tables``, and False for a git revision."""
    return not side or (Path(side) / paths.TABLES).is_dir()


def name_of(side: str) -> str:
    """Describe a side: "git HEAD", "the folder ../other", or "this folder" for ""."""
    if not side:
        return "this folder"
    return f"the folder {side}" if is_folder(side) else f"git {side}"


def read(side: str) -> Kept:
    """Read a project folder ("" for this one) or git revision; raise PlacecatError if it has no tables."""
    if not is_folder(side):
        return read_revision(side)
    root = Path(side)
    tables = [path for folder in FOLDERS for path in sorted((root / folder).glob("*.csv"))]
    others = (root / path for path in (paths.IN_TEXT, paths.FINDINGS, paths.PARAMS))
    there = [path for path in (*tables, *others) if path.is_file()]
    content = {path.relative_to(root).as_posix(): path.read_text(encoding="utf-8") for path in there}
    return _parse(content, f"{root / paths.TABLES} has no tables: run `placecat repro` to create them")


def read_revision(revision: str) -> Kept:
    """Read the results in a git revision such as ``HEAD~1`` or a tag.

    Raises PlacecatError if the revision has no results.
    """
    commit = commit_of(revision)
    wanted = [path.as_posix() for path in (*FOLDERS, paths.IN_TEXT, paths.FINDINGS, paths.PARAMS)]
    listed = _git("ls-tree", "-r", "-z", "--name-only", commit, "--", *wanted)
    names = [name for name in listed.split("\0") if Path(name).suffix in (".csv", ".yaml")]
    content = {name: _git("show", f"{commit}:./{name}") for name in names}
    return _parse(content, f"git {revision} has no tables in {paths.TABLES}: use a revision that has them")


def commit_of(revision: str) -> str:
    """Return the commit hash of a revision.

    Raises PlacecatError if git, the repository or the revision is missing.
    """
    _git("rev-parse", "--git-dir", message="this folder is not in a git repository")
    unknown = f"git has no revision {revision!r}: `git log --oneline` lists the existing ones"
    # The suffix makes git look for a commit, so that it never mistakes a revision for an option.
    return _git("rev-parse", "--verify", "--quiet", f"{revision}^{{commit}}", message=unknown).strip()


def about(revision: str) -> str:
    """Describe a revision in one line: short hash, date and subject."""
    return _git("log", "-1", "--format=%h, %cs: %s", commit_of(revision)).strip()


def _git(*arguments: str, message: str = "git failed") -> str:
    """Return the output of a git command; if it fails, raise PlacecatError with `message` and git's error."""
    try:
        done = subprocess.run(["git", *arguments], capture_output=True, check=False)
    except FileNotFoundError:
        raise PlacecatError("git is not installed: install it to compare tables") from None
    if done.returncode != 0:
        said = " ".join(done.stderr.decode("utf-8", errors="replace").split())
        raise PlacecatError(f"{message} ({said})" if said else message)
    return done.stdout.decode("utf-8")


def read_figures(side: str) -> Figures:
    """Read one side's figures (see :func:`read`). Those of a git revision come from DVC."""
    if is_folder(side):
        remedy = f"{Path(side) / paths.FIGURES} has no figures: run `dvc repro figures` in that project"
        return _read_figures(lambda name: (Path(side) / name).read_bytes(), remedy, (OSError,))
    # Imported here because the import takes a second.
    from dvc.api import DVCFileSystem
    from dvc.exceptions import DvcException

    commit = commit_of(side)
    remedy = (
        f"DVC has no figures for git {side}: if a remote has them, run `dvc fetch --all-commits "
        f"{paths.FIGURES}`; otherwise run `placecat repro` on {side} in a clone, and compare with that folder"
    )
    refused = (OSError, DvcException)
    try:
        system = DVCFileSystem(".", rev=commit)
    except refused:
        return Figures(missing=remedy)
    return _read_figures(system.read_bytes, remedy, refused)


def _read_figures(read: Callable[[str], bytes], remedy: str, refused: tuple[type[Exception], ...]) -> Figures:
    try:
        listed = json.loads(read((paths.FIGURES / "figures.json").as_posix()))
        drawn = [one for one in listed if one["file"] is not None]
        pictures = {one["name"]: read((paths.FIGURES / one["file"]).as_posix()) for one in drawn}
    except refused:
        return Figures(missing=remedy)
    return Figures(pictures, {one["name"]: one["title"] for one in drawn})


def _parse(content: dict[str, str], if_empty: str) -> Kept:
    """Parse the files of a side; `content` maps each path to the file's text."""
    tables = {
        Path(name).stem: _table(text)
        for name, text in content.items()
        if Path(name).parent in FOLDERS and name.endswith(".csv")
    }
    if not tables:
        raise PlacecatError(if_empty)
    if paths.IN_TEXT.as_posix() in content:
        tables[paths.IN_TEXT.stem] = _table(content[paths.IN_TEXT.as_posix()])
    findings, params = (content.get(path.as_posix()) for path in (paths.FINDINGS, paths.PARAMS))
    return Kept(
        tables,
        None if findings is None else _table(findings),
        None if params is None else yaml.load(params, Loader=settings.Loader),
    )


def _table(text: str) -> pd.DataFrame:
    return pd.read_csv(io.StringIO(text), dtype=str, keep_default_na=False)


def changed_settings(
    now: dict[str, Any] | None, kept: dict[str, Any] | None, without: Collection[str] = _WITHOUT_EFFECT
) -> dict[str, tuple[str, str]]:
    """Map the dotted name of each setting that differs to its old and new values ("" if missing).

    `without` lists the sections to leave out, by default those that no table depends on.
    """
    new, old = (
        settings.flatten({name: value for name, value in (one or {}).items() if name not in without})
        for one in (now, kept)
    )
    names = (name for name in dict.fromkeys([*new, *old]) if new.get(name) != old.get(name))
    return {name: (old.get(name, ""), new.get(name, "")) for name in names}
