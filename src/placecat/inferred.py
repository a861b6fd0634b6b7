"""Settings inferred from others: with them a cue is one module and one file of conf/."""

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
    """Find the descriptors that cues and codebooks name and no file of conf/descriptor describes.

    Returns ``local`` and ``holistic``, if not empty, to name to the defaults of its module's ``describe``.
    Raises PlacecatError for a file of a cue or codebook that is not YAML or names a descriptor without a
    module, or a module that cannot be imported or has a setting without a default.
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
                    f"it one, or write all its settings to {described}"
                )
        found.setdefault(kind, {})[name] = own
    return found


def codebooks(conf: Path) -> dict[str, dict[str, Any]]:
    """Find the codebooks of regions that cues name and no file of conf/codebook describes.

    Returns name to settings that refer to those of the cue, without ``tree``, the clustering. Raises
    PlacecatError for a file of a cue that is not YAML.
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
    """List the descriptors that files of conf/optional add, by kind; PlacecatError if one is not YAML."""
    found: dict[str, list[str]] = {}
    for _, content in _read(conf, "optional"):
        for kind, own in (content.get("descriptors") or {}).items():
            found.setdefault(kind, []).extend(own)
    return found


def _files(conf: Path, *folders: str) -> Iterator[tuple[Path, dict[str, Any]]]:
    """Paths and contents of the files that have a ``descriptor``."""
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
