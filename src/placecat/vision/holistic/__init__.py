"""Holistic frame descriptors (thesis 3.2), one module each.

To add a descriptor, add a module with its name. The module has ``describe(frame, maps, *, settings...)``,
which returns (D,) float32, and ``MAPS``, the fields of `FrameMaps` that it reads. If it needs packages from
an extra, it imports them in ``describe`` and lists them in ``PACKAGES``; tests skip it if they are missing.
"""

from collections.abc import Mapping
from types import ModuleType
from typing import Any

from placecat import lookup
from placecat.vision import discovery


def names() -> list[str]:
    """List the holistic descriptors, sorted."""
    return lookup.names(__name__, "describe")


def load(name: str) -> ModuleType:
    """Import a holistic descriptor by name; if it is unknown, the PlacecatError lists the valid names."""
    return lookup.module(__name__, name, "holistic descriptor", "describe")


def entry(name: str, settings: Mapping[str, Any]) -> tuple[ModuleType, dict[str, Any]]:
    """Find the module for an entry ``name: settings`` and check its settings; see `discovery.entry`."""
    return discovery.entry(__name__, name, settings, "holistic descriptor")
