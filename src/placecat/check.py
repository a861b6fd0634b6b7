"""Every check of the settings."""

from collections.abc import Mapping
from typing import Any

from placecat import references, schema, signatures


def check(params: Mapping[str, Any]) -> None:
    """Refuse settings that are unknown, missing, impossible, or name something that does not exist.

    Parameters
    ----------
    params
        All settings, or some of their sections.

    Raises
    ------
    PlacecatError
        Naming the first such setting.
    """
    schema.check(params)
    references.check(params)
    signatures.check(params)
