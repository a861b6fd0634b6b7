"""All checks of the settings."""

from collections.abc import Mapping
from typing import Any

from placecat import references, schema, signatures


def check(params: Mapping[str, Any]) -> None:
    """Refuse wrong or unknown settings in all or some sections; the PlacecatError names the first one."""
    schema.check(params)
    references.check(params)
    signatures.check(params)
