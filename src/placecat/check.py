"""All that is checked of the settings, whoever wrote params.yaml."""

from collections.abc import Mapping
from typing import Any

from placecat import references, schema, signatures


def check(params: Mapping[str, Any]) -> None:
    """Refuse settings that nothing reads, that are missing, impossible, or name what is not there.

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
