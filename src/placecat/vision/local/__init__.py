"""The descriptors of salient regions (thesis 3.1.2), one module each.

A new one is one module with ``describe``, ``size``, ``MAPS``, the fields of `FrameMaps` that it reads, and
``SPREAD``, the fixed unit in which `concatenate` measures it; its name is the module name.

Every one has

- ``describe(maps, regions, *, settings...) -> (n, size) float32``
- ``size(*, settings...) -> int``
"""

from collections.abc import Mapping
from types import ModuleType
from typing import Any

from placecat import lookup
from placecat.vision import discovery


def names() -> list[str]:
    """List the local descriptors, sorted."""
    return lookup.names(__name__, "describe")


def load(name: str) -> ModuleType:
    """Import a local descriptor by name.

    Raises
    ------
    PlacecatError
        For an unknown name; lists the valid ones.
    """
    return lookup.module(__name__, name, "local descriptor", "describe")


def entry(name: str, settings: Mapping[str, Any]) -> tuple[ModuleType, dict[str, Any]]:
    """Find the module of an entry ``name: settings`` and check its settings, see `discovery.entry`.

    Raises
    ------
    PlacecatError
        Naming the entry, what is unknown and what is valid.
    """
    return discovery.entry(__name__, name, settings, "local descriptor")
