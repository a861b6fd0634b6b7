"""Read and look up the settings in params.yaml, and reject unknown ones."""

import copy
import inspect
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import yaml

from placecat import paths
from placecat.errors import PlacecatError, SettingError, did_you_mean

# libyaml's loader is ten times faster, but not every build of PyYAML includes it.
Loader = getattr(yaml, "CSafeLoader", yaml.SafeLoader)


def load(path: Path = paths.PARAMS) -> dict[str, Any]:
    """Read the composed settings. Raises the same errors as :func:`read_yaml`."""
    return read_yaml(path, "run `placecat params` in the project folder to write it")


def read_yaml(path: Path, remedy: str = "restore it from git") -> dict[str, Any]:
    """Read a YAML file that contains a mapping; if it is missing or empty, the error suggests `remedy`."""
    try:
        content = yaml.load(path.read_text(encoding="utf-8"), Loader=Loader)
    except FileNotFoundError:
        raise PlacecatError(f"{path} is missing: {remedy}") from None
    except (yaml.YAMLError, UnicodeDecodeError) as error:
        raise PlacecatError(f"{path} is not valid YAML: {' '.join(str(error).split())}") from None
    if not isinstance(content, dict):
        raise PlacecatError(f"{path} is empty or not a mapping: {remedy}")
    return content


def get(params: Mapping[str, Any], name: str) -> Any:
    """Look up a setting by its dotted name; raise a PlacecatError with the valid names if it is missing."""
    value: Any = params
    walked: list[str] = []
    for part in name.split("."):
        if not isinstance(value, Mapping) or part not in value:
            valid = ", ".join(map(str, value)) if isinstance(value, Mapping) else "nothing"
            where = ".".join(walked) or str(paths.PARAMS)
            raise PlacecatError(f"setting {name!r} does not exist: {where} has {valid}")
        value = value[part]
        walked.append(part)
    return value


def check(function: Callable[..., Any], settings: Mapping[str, Any], where: str) -> None:
    """Raise a SettingError that lists the valid settings if one is not a parameter of `function`."""
    refuse_unknown(settings, list(inspect.signature(function).parameters), where)


def refuse_unknown(settings: Mapping[str, Any], valid: list[str], where: str) -> None:
    """Raise SettingError for the first setting that is not in `valid`."""
    for name in settings:
        if name not in valid:
            question = did_you_mean(name, valid)
            raise SettingError(
                f"{where} has no setting {name!r}{question} (valid: {', '.join(valid) or 'none'})"
            )


def call(function: Callable[..., Any], *args: Any, settings: Mapping[str, Any], where: str) -> Any:
    """Call `function` with positional arguments and checked settings; required settings must be present."""
    check(function, settings, where)
    try:
        inspect.signature(function).bind(*args, **settings)
    except TypeError as error:
        raise SettingError(f"{where}: {error}") from None
    return function(*args, **settings)


def changed(content: Mapping[str, Any], overrides: Mapping[str, Any], who: str, where: str) -> dict[str, Any]:
    """Return a copy of nested settings, with new values for the given dotted names.

    For an unknown setting, the PlacecatError begins with `who`, such as ``table_12 changes``, and says that
    `where` has no such setting.
    """
    result = copy.deepcopy(dict(content))
    for name, value in overrides.items():
        *parents, last = name.split(".")
        place: Any = result
        for part in parents:
            place = place.get(part) if isinstance(place, dict) else None
        if not isinstance(place, dict) or last not in place:
            raise PlacecatError(f"{who} {name}, but {where} has no such setting")
        # Copy the value, since a later override may change part of it.
        place[last] = copy.deepcopy(value)
    return result


def flatten(settings: Mapping[str, Any], prefix: str = "") -> dict[str, str]:
    """Map dotted names of settings to their values as text: ``cues.gist.classifier.base.nu`` to ``0.2``."""
    flat: dict[str, str] = {}
    for name, value in settings.items():
        if isinstance(value, Mapping):
            flat |= flatten(value, f"{prefix}{name}.")
        else:
            flat[f"{prefix}{name}"] = str(value)
    return flat
