"""Settings inferred from others, which reduce a cue to one module and one file of conf/."""

import inspect
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import yaml

from placecat import settings
from placecat.errors import PlacecatError
from placecat.vision import discovery, holistic, local

_PACKAGES = {"local": local, "holistic": holistic}


def descriptors(conf: Path) -> dict[str, dict[str, dict[str, Any]]]:
    """Find descriptors that cues and codebooks name but no file of conf/descriptor describes.

    Returns a mapping of ``local`` and ``holistic``, if not empty, to descriptor names and the defaults of
    their modules' ``describe``. Raises PlacecatError if a file of a cue or codebook is not YAML, a descriptor
    has no module, a module cannot be imported, or a setting has no default.
    """
    found: dict[str, dict[str, dict[str, Any]]] = {}
    for path, content in _files(conf, "cue", "codebook"):
        descriptor = content["descriptor"]
        kind, name = descriptor.get("kind"), descriptor.get("name")
        described = conf / "descriptor" / str(kind) / f"{name}.yaml"
        if str(kind) not in _PACKAGES or name is None or described.exists():
            continue
        try:
            own = discovery.settings_of(_PACKAGES[kind].load(name).describe)
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
    """Find codebooks of regions that cues name but no file of conf/codebook describes.

    Returns a mapping of names to settings, which refer to the cue's settings, without ``tree`` (the
    clustering). Raises PlacecatError if a file of a cue is not YAML.
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
    """List the descriptors that conf/optional adds, by kind; PlacecatError if a file is not YAML."""
    found: dict[str, list[str]] = {}
    for _, content in _read(conf, "optional"):
        for kind, own in (content.get("descriptors") or {}).items():
            found.setdefault(kind, []).extend(own)
    return found


def _files(conf: Path, *folders: str) -> Iterator[tuple[Path, dict[str, Any]]]:
    """Paths and contents of the files with a ``descriptor``."""
    for folder in folders:
        for path, content in _read(conf, folder):
            if isinstance(content.get("descriptor"), dict):
                yield path, content


def _read(conf: Path, folder: str) -> Iterator[tuple[Path, dict[str, Any]]]:
    """Paths and contents of the files of a folder."""
    for path in sorted((conf / folder).glob("*.yaml")):
        try:
            content = yaml.load(path.read_text(encoding="utf-8"), Loader=settings.Loader)
        except yaml.YAMLError as error:
            raise PlacecatError(f"{path} is not valid YAML: {' '.join(str(error).split())}") from None
        if isinstance(content, dict):
            yield path, content
