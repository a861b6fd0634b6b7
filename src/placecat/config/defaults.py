"""Merge the files in conf/ by following their defaults lists, as Hydra does.

Hydra takes seconds to compose the hundred files in conf/, since its running time is quadratic in their
number. This module handles the common cases, and leaves all other cases and all errors to Hydra
(:class:`Unusual`).
"""

from collections.abc import Sequence
from pathlib import Path
from typing import Any, NamedTuple

import yaml
from omegaconf._utils import get_yaml_loader

_OVERRIDE = "override "
_MISSING = "???"
# First line of a file whose contents go to the root, unless the defaults list names another place.
_OF_ROOT = "# @package _global_\n"
# This loader follows OmegaConf's rules for numbers, dates and duplicate keys, and uses libyaml if available.
_Loader = get_yaml_loader()
if yaml.__with_libyaml__:
    _Loader = type("_Loader", (yaml.CSafeLoader, _Loader), {})


class Unusual(Exception):
    """A case that this module leaves to Hydra."""


class _Entry(NamedTuple):
    """An entry of a defaults list: choice ("" if none), group, file, package, and whether it overrides.

    `fixed` says whether the entry names the package; if so, the file's header is ignored.
    """

    choice: str
    group: str
    file: str
    package: str
    overrides: bool
    fixed: bool


def merge(conf: Path, choices: Sequence[tuple[str, str]] = ()) -> dict[str, Any]:
    """Merge conf/config.yaml with all files it names, directly or indirectly.

    `choices` are pairs of a choice, as Hydra names it, and a file, such as ``("dataset", "my_homes")`` or
    ``("classifier@cues.gist.classifier", "knn")``. Returns plain containers with unresolved references
    (``${...}``). Raises Unusual in cases such as a missing file, invalid YAML, an empty choice, a header with
    a package other than the root, or a list of files.
    """
    if len(dict(choices)) < len(choices) or not all(file for _, file in choices):
        raise Unusual(str(choices))
    tree = _Tree(conf, dict(choices))
    tree.walk("config", "", ())
    if not tree.choices.keys() <= tree.seen:
        raise Unusual(", ".join(tree.choices.keys() - tree.seen))
    merged: dict[str, Any] = {}
    for package, content in reversed(tree.parts):
        for name in reversed(package.split(".") if package else []):
            content = {name: content}
        merged = _over(merged, content)
    return merged


class _Tree:
    """The files in the order in which Hydra visits them, the last file of each defaults list first.

    `parts` contains the package (a dotted name, "" for the root) and the contents of each file. `choices`
    come from the command line or from an ``override`` in a defaults list. `seen` contains the names of all
    choices so far.
    """

    def __init__(self, conf: Path, choices: dict[str, str]) -> None:
        self.parts: list[tuple[str, dict[str, Any]]] = []
        self.choices = choices
        self.seen: set[str] = set()
        self._conf = conf
        self._contents: dict[str, tuple[dict[str, Any], bool]] = {}

    def walk(self, name: str, package: str, before: tuple[str, ...], fixed: bool = True) -> None:
        """Add a file and all files it names; `before` is the chain of files that leads to it."""
        found, of_root = self._read(name)
        content = dict(found)
        if of_root and not fixed:
            package = ""
        defaults = content.pop("defaults", ["_self_"])
        if name in before or not isinstance(defaults, list) or (content and "_self_" not in defaults):
            raise Unusual(name)
        folder = name.rpartition("/")[0]
        entries = [_entry(default, folder, package) for default in defaults]
        for entry in entries:
            if entry.overrides:
                # Outer choices take precedence.
                self.choices.setdefault(entry.choice, entry.file)
        for entry in reversed(entries):
            if entry.file == "_self_":
                self.parts.append((package, content))
            elif not entry.overrides:
                if entry.choice in self.seen:
                    raise Unusual(entry.choice)
                if entry.choice:
                    self.seen.add(entry.choice)
                if file := self.choices.get(entry.choice, entry.file):
                    path = f"{entry.group}/{file}".lstrip("/")
                    self.walk(path, entry.package, (*before, name), entry.fixed)

    def _read(self, name: str) -> tuple[dict[str, Any], bool]:
        """Return the contents of a file, and whether its header names the root as its package."""
        if name not in self._contents:
            try:
                text = (self._conf / f"{name}.yaml").read_text(encoding="utf-8")
                content = yaml.load(text, Loader=_Loader)
            except (OSError, UnicodeDecodeError, yaml.YAMLError) as error:
                raise Unusual(name) from error
            if not isinstance(content, dict | None) or "@package" in text.removeprefix(_OF_ROOT):
                raise Unusual(name)
            self._contents[name] = content or {}, text.startswith(_OF_ROOT)
        return self._contents[name]


def _entry(default: Any, folder: str, package: str) -> _Entry:
    """Parse an entry in the defaults list of a file in `folder` whose contents go to `package`."""
    if isinstance(default, str):
        path, at, own = default.partition("@")
        group, slash, file = path.rpartition("/")
        group = group or slash
    elif isinstance(default, dict) and len(default) == 1 and all(isinstance(key, str) for key in default):
        ((path, file),) = default.items()
        group, at, own = path.removeprefix(_OVERRIDE).partition("@")
        # An empty list is not a file.
        file = file or ""
    else:
        raise Unusual(str(default))
    if not isinstance(file, str) or "$" in path + file or " " in group:
        raise Unusual(str(default))
    if own.startswith("_") and own != "_here_":
        raise Unusual(str(default))
    whole = group.strip("/") if group.startswith("/") else f"{folder}/{group}".strip("/")
    inner = own if at else group.strip("/").replace("/", ".")
    target = package if own == "_here_" else f"{package}.{inner}".strip(".")
    choice = whole if target == whole.replace("/", ".") else f"{whole}@{target}"
    return _Entry(
        "" if isinstance(default, str) else choice, whole, file, target, path.startswith(_OVERRIDE), bool(at)
    )


def _over(below: Any, above: Any) -> Any:
    """Override one value with another: mappings are merged, and other values are replaced."""
    if isinstance(above, dict):
        if isinstance(below, list) or (isinstance(below, str) and "$" in below):
            raise Unusual(below)
        merged = dict(below) if isinstance(below, dict) else {}
        for key, value in above.items():
            merged[key] = _over(merged.get(key), value)
        return merged
    if isinstance(above, list) and isinstance(below, dict):
        raise Unusual(above)
    return below if above == _MISSING and below is not None else above
