"""Run all checks on the settings."""

from collections.abc import Mapping
from typing import Any

from placecat import schema
from placecat.schema import references, signatures


def check(params: Mapping[str, Any]) -> None:
    """Refuse wrong or unknown settings; the PlacecatError names the first. `params` may lack sections."""
    schema.check(params)
    references.check(params)
    signatures.check(params)
