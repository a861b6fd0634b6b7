"""All checks of the settings."""

from collections.abc import Mapping
from typing import Any

from placecat import references, schema, signatures


def check(params: Mapping[str, Any]) -> None:
    """Refuse settings that are unknown, missing or impossible, or that name something that does not exist.

    `params` are all settings, or some of their sections. The PlacecatError names the first such setting.
    """
    schema.check(params)
    references.check(params)
    signatures.check(params)
