"""Settings inferred from other settings, so that a cue needs only one module and one file in conf/."""

import inspect
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from placecat import settings
from placecat.errors import PlacecatError
from placecat.vision import discovery


def descriptors(conf: Path) -> dict[str, dict[str, dict[str, Any]]]:
    """Find descriptors that cues or codebooks use but that have no file in conf/descriptor.

    Maps each kind that has such descriptors (``local`` or ``holistic``) to their names, and each name to the
    default settings of ``describe`` in its module. Raises PlacecatError if a cue or codebook file is not
    YAML, a descriptor has no module, a module cannot be imported, or a setting has no default.
    """
    found: dict[str, dict[str, dict[str, Any]]] = {}
    for path, content in _files(conf, "cue", "codebook"):
        descriptor = content["descriptor"]
        kind, name = descriptor.get("kind"), descriptor.get("name")
        described = conf / "descriptor" / str(kind) / f"{name}.yaml"
        if kind not in ("local", "holistic") or name is None or described.exists():
            continue
        try:
            own = dict(discovery.settings_of(discovery.load(kind, name).describe))
        except (PlacecatError, ImportError) as error:
            raise PlacecatError(f"{path}: {error}") from None
        for setting, value in own.items():
            if value is inspect.Parameter.empty:
                raise PlacecatError(
                    f"{path}: the setting {setting!r} of the {kind} descriptor {name!r} has no default: give "
                    f"it one, or write all settings to {described}"
                )
        found.setdefault(kind, {})[name] = own
    return found


def codebooks(conf: Path) -> dict[str, dict[str, Any]]:
    """Find codebooks of regions that cues use but that have no file in conf/codebook.

    Maps each name to settings that refer to the cue's; ``tree`` (the clustering) is left out. Raises
    PlacecatError if a cue file is not YAML.
    """
    found = {}
    for path, cue in _files(conf, "cue"):
        name = cue.get("codebook")
        is_local = cue["descriptor"].get("kind") == "local"
        if name is not None and is_local and not (conf / "codebook" / f"{name}.yaml").exists():
            found[name] = {
                "descriptor": f"${{cues.{path.stem}.descriptor}}",
                "schemes": f"${{cues.{path.stem}.schemes}}",
                "cells": 1,
            }
    return found


def optional_descriptors(conf: Path) -> dict[str, list[str]]:
    """Map each kind to the descriptors that conf/optional adds; raise PlacecatError for invalid YAML."""
    found: dict[str, list[str]] = {}
    for _, content in _read(conf, "optional"):
        for kind, own in (content.get("descriptors") or {}).items():
            found.setdefault(kind, []).extend(own)
    return found


def _files(conf: Path, *folders: str) -> Iterator[tuple[Path, dict[str, Any]]]:
    """Yield the path and contents of each file that has a ``descriptor``."""
    for folder in folders:
        for path, content in _read(conf, folder):
            if isinstance(content.get("descriptor"), dict):
                yield path, content


def _read(conf: Path, folder: str) -> Iterator[tuple[Path, dict[str, Any]]]:
    """Yield the path and contents of each YAML file in a folder."""
    for path in sorted((conf / folder).glob("*.yaml")):
        yield path, settings.read_yaml(path, "write its settings, or remove it")
