"""Settings of a command in its own file of conf/, outside params.yaml."""

from collections.abc import Sequence
from pathlib import Path
from typing import Any

from placecat import settings


def read(path: Path, names: Sequence[str]) -> dict[str, Any]:
    """Read a file that must have exactly these settings.

    Raises
    ------
    PlacecatError
        If it is missing or no YAML, or has an unknown setting or lacks one.
    """
    content = settings.read_yaml(path, "run this in the project's folder, or restore it from git")
    settings.refuse_unknown(content, list(names), str(path))
    for name in names:
        settings.get(content, name)
    return content
