"""Settings of a command that are a file of conf/ by themselves, no part of params.yaml."""

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import yaml

from placecat import settings
from placecat.errors import PlacecatError


def read(path: Path, names: Sequence[str]) -> dict[str, Any]:
    """Read a file that has the settings named, and no others.

    Raises
    ------
    PlacecatError
        If it is missing or no YAML, or has an unknown setting or lacks one.
    """
    try:
        content = yaml.safe_load(path.read_text(encoding="utf-8"))
    except FileNotFoundError:
        raise PlacecatError(f"{path} is missing: run this in the project's folder") from None
    except yaml.YAMLError as error:
        raise PlacecatError(f"{path} is no valid YAML: {' '.join(str(error).split())}") from None
    if not isinstance(content, dict):
        raise PlacecatError(f"{path} is empty: restore it from git")
    settings.refuse_unknown(content, list(names), str(path))
    for name in names:
        settings.get(content, name)
    return content
