"""Read the definitions of tables, findings and numbers in the text from data/thesis.

These files can contain two kinds of references. A mapping with `like: PATH` starts with the content of a file
in conf/ or of another table, which its other keys override. `${NAME}` refers to a setting in params.yaml.
"""

import re
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from placecat import paths, settings
from placecat.errors import PlacecatError

LIKE = "like"
_SETTING = re.compile(r"\$\{(\.*)([\w.]+)\}")
# The settings that any table may have. Layouts and trials have additional ones.
_OF_A_TABLE = ("number", "title", "thesis_data", "layout", "caption", "split", "data", "plain", "needs")
_OF_A_LAYOUT = ("rows", "result", "gains")
_OF_TRIALS = ("trial", "homes", "axes")


def tables(params: Mapping[str, Any], root: Path = Path()) -> dict[str, dict[str, Any]]:
    """Read the tables that show the pipeline's results; return them in order, by name, e.g. ``table_26``.

    Each table has ``number`` (None for an addition), ``title``, ``thesis_data``, ``layout`` and the layout's
    settings. A table that names a setting in `needs` is included only if `params`, the run's settings,
    contains that setting. `root` is the project folder.

    Raises PlacecatError, naming the file, for invalid YAML or an unknown key or setting.
    """
    found = _read(sorted((root / paths.TABLE_DEFINITIONS).glob("*.yaml")), params, root)
    for path, table in found.items():
        settings.refuse_unknown(table, [*_OF_A_TABLE, *_OF_A_LAYOUT], str(path))
    return {
        path.stem: table
        for path, table in found.items()
        if "needs" not in table or _is_set(params, table["needs"])
    }


def optional(root: Path = Path()) -> list[str]:
    """List, in order, the names of the tables that need a particular setting.

    A run without this setting leaves the table unchanged.
    """
    files = sorted((root / paths.TABLE_DEFINITIONS).glob("*.yaml"))
    return [path.stem for path in files if "needs" in _yaml(path)]


def studies(params: Mapping[str, Any], root: Path = Path()) -> dict[str, dict[str, dict[str, Any]]]:
    """Like :func:`tables`, but read the tables whose cells are trials, from one folder per study.

    Returns a dict that maps each study to its tables, by name. Each table also has ``trial``, ``homes`` and
    ``axes`` (see :func:`placecat.evaluation.trials.expand`).
    """
    found = _read(sorted((root / paths.TABLE_DEFINITIONS).glob("*/*.yaml")), params, root)
    by_study: dict[str, dict[str, dict[str, Any]]] = {}
    for path, table in found.items():
        settings.refuse_unknown(table, [*_OF_A_TABLE, *_OF_TRIALS], str(path))
        for name in _OF_TRIALS:
            if name not in table:
                raise PlacecatError(f"{path} needs the setting {name!r}, because its cells are trials")
        by_study.setdefault(path.parent.name, {})[path.stem] = table
    return by_study


def findings(root: Path = Path()) -> dict[str, dict[str, Any]]:
    """Read the thesis's claims, by name; :func:`placecat.thesis.claims.read_finding` checks them."""
    return {path.stem: _yaml(path) for path in sorted((root / paths.FINDING_DEFINITIONS).glob("*.yaml"))}


def in_text(root: Path = Path()) -> dict[str, dict[str, Any]]:
    """Read the numbers in the thesis's text, by name; :func:`placecat.thesis.in_text.in_text` checks them."""
    return _yaml(root / paths.IN_TEXT_DEFINITIONS)


def _read(files: list[Path], params: Mapping[str, Any], root: Path) -> dict[Path, dict[str, Any]]:
    """Read files and resolve all references; return the contents by path relative to the project."""
    found = {path.relative_to(root): _load(path, root, ()) for path in files}
    for path, content in found.items():
        try:
            found[path] = _set(content, (), params)
        except PlacecatError as error:
            raise PlacecatError(f"{path}: {error}") from None
    return found


def _set(value: Any, around: tuple[dict[str, Any], ...], params: Mapping[str, Any]) -> Any:
    """Replace each ``${NAME}`` with the value of that setting.

    ``${..NAME}`` refers to a sibling of the mapping in which it appears.
    """
    if isinstance(value, dict):
        return {key: _set(one, (value, *around), params) for key, one in value.items()}
    if isinstance(value, list):
        return [_set(one, around, params) for one in value]
    if not isinstance(value, str) or not (match := _SETTING.fullmatch(value)):
        return value
    dots, name = match.groups()
    return _set(settings.get(around[len(dots) - 1] if dots else params, name), around, params)


def _load(path: Path, root: Path, before: tuple[Path, ...]) -> dict[str, Any]:
    """Read a file and all files it refers to; `before` lists the files whose references led here."""
    if path in before:
        raise PlacecatError(f"{path} refers to itself through {', '.join(map(str, before))}")
    content = _yaml(path)
    # Files in conf/ include others in Hydra's notation: "/scheme@scheme: parallel".
    base = {}
    for default in content.pop("defaults", []):
        if default != "_self_":
            ((group, name),) = default.items()
            folder, _, key = group.removeprefix("/").partition("@")
            base[key] = _load(root / paths.CONF / folder / f"{name}.yaml", root, (*before, path))
    return _filled(content, base, root, (*before, path))


def _filled(value: Any, inherited: Any, root: Path, before: tuple[Path, ...]) -> Any:
    """Override an inherited value: mappings without `like` are merged, other values are replaced."""
    if isinstance(value, list):
        return [_filled(one, None, root, before) for one in value]
    if not isinstance(value, dict):
        return value
    if LIKE in value:
        inherited = _load(root / value[LIKE], root, before)
    filled = dict(inherited) if isinstance(inherited, dict) else {}
    for key, one in value.items():
        if key != LIKE:
            filled[key] = _filled(one, filled.get(key), root, before)
    return filled


def _yaml(path: Path) -> dict[str, Any]:
    return settings.read_yaml(path, f"restore it from git, or correct the `{LIKE}` that refers to it")


def _is_set(params: Mapping[str, Any], name: str) -> bool:
    try:
        settings.get(params, name)
    except PlacecatError:
        return False
    return True
