"""Descriptors of salient regions (thesis 3.1.2), one module each.

To add a descriptor, add a module with its name. It has ``describe(maps, regions, *, settings...)``, which
returns (n, D) float32; ``MAPS``, the fields of `FrameMaps` that it reads; and ``SPREAD``, its fixed unit in
`concatenate`.

In every module, `maps` are the maps of the frame and `regions` is (n, 4) float32: x, y (pixels of the frame),
scale and strength. `border` is passed to `placecat.vision.patches.cut`, whose errors are raised too.
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
    """Import a local descriptor by name; the PlacecatError for an unknown name lists the valid ones."""
    return lookup.module(__name__, name, "local descriptor", "describe")


def entry(name: str, settings: Mapping[str, Any]) -> tuple[ModuleType, dict[str, Any]]:
    """Find the module of an entry ``name: settings`` and check its settings, see `discovery.entry`."""
    return discovery.entry(__name__, name, settings, "local descriptor")
