"""The descriptors of whole frames (thesis 3.2), one module each.

A new one is one module with ``describe`` and ``size``; its name is the module name.

Every one has

- ``describe(frame, maps, *, settings...) -> (size,) float32``
- ``size(*, settings...) -> int``
"""

from collections.abc import Mapping
from types import ModuleType
from typing import Any

from placecat.vision import discovery


def names() -> list[str]:
    """List the holistic descriptors, sorted."""
    return discovery.names(__name__, __path__)


def load(name: str) -> ModuleType:
    """Import a holistic descriptor by name.

    Raises
    ------
    PlacecatError
        For an unknown name; lists the valid ones.
    """
    return discovery.load(__name__, __path__, name, "holistic descriptor")


def check_settings(name: str, settings: Mapping[str, Any]) -> None:
    """Refuse settings that a holistic descriptor does not have.

    Raises
    ------
    PlacecatError
        Naming the descriptor, the setting and the valid ones.
    """
    discovery.check_settings(load(name).describe, settings, f"holistic descriptor '{name}'")
