"""Find descriptor modules and function settings."""

import inspect
from collections.abc import Callable, Mapping
from functools import lru_cache
from types import ModuleType
from typing import Any

from placecat import lookup
from placecat.schema import signatures


@lru_cache(maxsize=256)
def settings_of(function: Callable[..., Any]) -> Mapping[str, Any]:
    """Return a function's settings and their defaults, in order.

    The settings are its keyword-only parameters. A required setting has the default
    `inspect.Parameter.empty`.
    """
    parameters = inspect.signature(function).parameters.values()
    return {one.name: one.default for one in parameters if one.kind is one.KEYWORD_ONLY}


def parts_of(
    section: str, settings: Mapping[str, Any], *functions: Callable[..., Any]
) -> list[dict[str, Any]]:
    """Check a section's settings, and return the ones that each function takes.

    Raises PlacecatError if a setting is unknown or invalid.
    """
    signatures.check_vision(section, settings, section)
    return [{name: settings[name] for name in settings_of(one) if name in settings} for one in functions]


def load(kind: str, name: str) -> ModuleType:
    """Import a descriptor's module; `kind` is ``local`` or ``holistic``.

    Raises a PlacecatError that lists the valid names if the descriptor is unknown.
    """
    return lookup.module(f"placecat.vision.{kind}", name, f"{kind} descriptor", "describe")


def entry(kind: str, name: str, settings: Mapping[str, Any]) -> tuple[ModuleType, dict[str, Any]]:
    """Return the module and the settings of ``describe`` for an entry ``name: settings``.

    The name is usually that of the module. A variant may have any name, and its ``descriptor`` setting names
    the module, as in ``centrist_laplacian: {descriptor: centrist, image: laplacian}``.
    """
    own = dict(settings)
    return load(kind, own.pop("descriptor", name)), own
