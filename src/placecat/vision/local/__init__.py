"""Descriptors of salient regions (thesis 3.1.2), one module each.

To add a descriptor, add a module with its name. The module has ``describe(maps, regions, *, settings...)``,
which returns (n, D) float32; ``MAPS``, the fields of `FrameMaps` that it reads; and ``SPREAD``, its fixed
unit in `concatenate`.

In every module, `maps` are the frame's maps and `regions` is (n, 4) float32: x, y (frame pixels), scale and
strength. `border` is passed to `placecat.vision.patches.cut`, whose errors are also raised.
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
    """Import a local descriptor by name; if it is unknown, the PlacecatError lists the valid names."""
    return lookup.module(__name__, name, "local descriptor", "describe")


def entry(name: str, settings: Mapping[str, Any]) -> tuple[ModuleType, dict[str, Any]]:
    """Find the module for an entry ``name: settings`` and check its settings; see `discovery.entry`."""
    return discovery.entry(__name__, name, settings, "local descriptor")
