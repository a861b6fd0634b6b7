"""The descriptors of salient regions (thesis 3.1.2), one module each.

A new one is one module with ``describe``, ``size`` and ``SPREAD``, the fixed unit in which `concatenate`
measures it; its name is the module name.

Every one has

- ``describe(maps, regions, *, settings...) -> (n, size) float32``
- ``size(*, settings...) -> int``
"""

from collections.abc import Mapping
from types import ModuleType
from typing import Any

from placecat.vision import discovery


def names() -> list[str]:
    """List the local descriptors, sorted."""
    return discovery.names(__name__, __path__)


def load(name: str) -> ModuleType:
    """Import a local descriptor by name.

    Raises
    ------
    PlacecatError
        For an unknown name; lists the valid ones.
    """
    return discovery.load(__name__, __path__, name, "local descriptor")


def check_settings(name: str, settings: Mapping[str, Any]) -> None:
    """Refuse settings that a local descriptor does not have.

    Raises
    ------
    PlacecatError
        Naming the descriptor, the setting and the valid ones.
    """
    discovery.check_settings(load(name).describe, settings, f"local descriptor '{name}'")
