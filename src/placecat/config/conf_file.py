"""Read the settings of a command from its own file in conf/, not from params.yaml."""

from collections.abc import Sequence
from pathlib import Path
from typing import Any

from placecat import settings
from placecat.config.compose import overridden


def read(path: Path, names: Sequence[str], overrides: Sequence[str] = ()) -> dict[str, Any]:
    """Read a settings file, and apply Hydra overrides such as ``fps=10.0``.

    The file must contain exactly the settings in `names`. Raises PlacecatError if the file is missing or not
    YAML, if a setting is unknown or missing, or if an override is unreadable or names an unknown setting.
    """
    content = settings.read_yaml(path, "run this in the project folder, or restore it from git")
    settings.refuse_unknown(content, list(names), str(path))
    for name in names:
        settings.get(content, name)
    return overridden(content, overrides, str(path)) if overrides else content
