"""The descriptors of salient regions (thesis 3.1.2), one module each.

A new descriptor is one module of its name. It has ``describe(maps, regions, *, settings...)``, which returns
(n, D) float32; ``MAPS``, the fields of `FrameMaps` that it reads; and ``SPREAD``, its fixed unit in
`concatenate`.

In all of them `maps` are those of the frame, `regions` (n, 4) float32 with x, y (pixels of the frame), scale
and strength, and `border` is that of `placecat.vision.patches.cut`, whose errors they raise too.
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
