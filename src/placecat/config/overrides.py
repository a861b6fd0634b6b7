"""Check overrides against Hydra's grammar. Messages show how to quote unreadable ones."""

import re
import shlex
from collections.abc import Mapping, Sequence
from typing import Any

from placecat.errors import PlacecatError, did_you_mean

# Text that a shell leaves unchanged within double quotes.
_PLAIN_IN_QUOTES = re.compile(r"[^\"$`\\!]*")


def check(overrides: Sequence[str], *, several: bool = False) -> None:
    """Raise PlacecatError if Hydra cannot read an override, or would read it as several values.

    An override looks like ``dataset.root=PATH``. `several` allows several values, as in a sweep. The message
    names the setting and shows how to write the override for a shell and for make.
    """
    for number, override in enumerate(overrides):
        if _is_read(override, several=several):
            continue
        if not override.strip():
            raise PlacecatError("an override is empty: write NAME=VALUE, e.g. dataset.root=PATH")
        if "=" not in override:
            before = overrides[number - 1] if number else ""
            right = _quoted(f"{before} {override}") if "=" in before else None
            hint = f"if it belongs to {before!r}, {_how(right, several)}" if right else "write NAME=VALUE"
            raise PlacecatError(f"the override {override!r} has no value: {hint}")
        name, _, value = override.partition("=")
        right = _quoted(override)
        hint = _how(right, several) if right else "quote it"
        raise PlacecatError(f"Hydra cannot read the value {value!r} of {name} without quotes: {hint}")


def unknown_setting(overrides: Sequence[str], content: Mapping[str, Any], where: str) -> str | None:
    """Name the first overridden setting that `content` lacks, and the valid ones; return None if all exist.

    `where` is the settings file or folder.

    >>> content = {"fps": 5.0, "size": {"width": 1, "height": 2}}
    >>> unknown_setting(["size.widht=3"], content, "conf/a.yaml")
    "size has no setting 'widht'; did you mean 'width'? (valid: width, height)"
    >>> unknown_setting(["fsp=3"], content, "conf/a.yaml")
    "conf/a.yaml has no setting 'fsp'; did you mean 'fps'? (valid: fps, size)"
    >>> unknown_setting(["+size.depth=3"], content, "conf/a.yaml")
    """
    for override in map(_parsed, overrides):
        if override.is_add() or override.is_force_add():
            continue
        section: Any = content
        path = str(override.key_or_group).split(".")
        for depth, name in enumerate(path):
            # The rest of the path is in a reference or a list.
            if not isinstance(section, Mapping):
                break
            if name not in section:
                place = ".".join(path[:depth]) or where
                question = did_you_mean(name, map(str, section))
                if not question and depth == len(path) - 1 and depth:
                    question = f"; to add it, write +{override.input_line}"
                valid = ", ".join(map(str, section))
                return f"{place} has no setting {name!r}{question} (valid: {valid or 'none'})"
            section = section[name]
    return None


def text(value: str) -> str:
    """Quote text for Hydra if Hydra would misread it without quotes.

    >>> text("home_1"), text("Flat A"), text("a,b"), text("12")
    ('home_1', 'Flat A', "'a,b'", "'12'")
    """
    from hydra.errors import HydraException

    try:
        return value if _parsed(f"name=[{value}]").value() == [value] else _text(value)
    except HydraException:
        return _text(value)


def for_shell(argument: str) -> str:
    """Quote an argument for a shell."""
    return f'"{argument}"' if _PLAIN_IN_QUOTES.fullmatch(argument) else shlex.quote(argument)


def for_make(argument: str) -> str:
    """Quote an argument for ``SET=``, which passes through a shell, make, and a shell again."""
    inner = for_shell(argument)
    if inner.startswith('"') and "'" in inner:
        escaped = inner.replace('"', '\\"')
        return f'SET="{escaped}"'
    return f"SET={shlex.quote(inner.replace('$', '$$'))}"


def _how(right: str, several: bool) -> str:
    # Sweeps cannot be run with make.
    return f"write {for_shell(right)}" + ("" if several else f", and with make {for_make(right)}")


def _parsed(override: str) -> Any:
    from hydra.core.override_parser.overrides_parser import OverridesParser

    return OverridesParser.create().parse_override(override)


def _is_read(override: str, *, several: bool = False) -> bool:
    from hydra.errors import HydraException

    try:
        return not _parsed(override).is_sweep_override() or several
    except HydraException:
        return False


def _quoted(override: str) -> str | None:
    """Quote the value of an override or the items of its list; return None if that does not help."""
    name, _, value = override.partition("=")
    if value.startswith("[") and value.endswith("]"):
        items = [item.strip() for item in value[1:-1].split(",")]
        right = [item if _is_read(f"{name}=[{item}]") else _text(item) for item in items]
        result = f"{name}=[{','.join(right)}]"
    else:
        result = f"{name}={_text(value)}"
    return result if _is_read(result) else None


def _text(value: str) -> str:
    """Put a value in quotes for Hydra, doubling backslashes before a quote."""
    mark = '"' if "'" in value and '"' not in value else "'"

    def escape(found: re.Match[str]) -> str:
        return found[1] * 2 + (f"\\{mark}" if found[2] else "")

    return mark + re.sub(rf"(\\*)({mark}|$)", escape, value) + mark
