"""Run all checks on the settings."""

from collections.abc import Mapping
from typing import Any

from placecat import schema
from placecat.schema import references, signatures


def check(params: Mapping[str, Any]) -> None:
    """Raise a PlacecatError that names the first invalid or unknown setting; sections may be missing."""
    schema.check(params)
    references.check(params)
    signatures.check(params)
