"""Find the modules of descriptors and the settings of functions."""

import inspect
from collections.abc import Callable, Mapping
from functools import lru_cache
from types import ModuleType
from typing import Any

from placecat import lookup
from placecat.schema import signatures


@lru_cache(maxsize=256)
def settings_of(function: Callable[..., Any]) -> Mapping[str, Any]:
    """Return the settings of a function and their defaults, in order.

    The settings are its keyword-only parameters. A required setting has the default
    `inspect.Parameter.empty`.
    """
    parameters = inspect.signature(function).parameters.values()
    return {one.name: one.default for one in parameters if one.kind is one.KEYWORD_ONLY}


def parts_of(
    section: str, settings: Mapping[str, Any], *functions: Callable[..., Any]
) -> list[dict[str, Any]]:
    """Check the settings of a section, and return those that each function takes.

    Raises PlacecatError if a setting is unknown or invalid.
    """
    signatures.check_vision(section, settings, section)
    return [{name: settings[name] for name in settings_of(one) if name in settings} for one in functions]


def load(kind: str, name: str) -> ModuleType:
    """Import a descriptor, whose `kind` is ``local`` or ``holistic``.

    If the descriptor is unknown, this raises PlacecatError, which lists the valid names.
    """
    return lookup.module(f"placecat.vision.{kind}", name, f"{kind} descriptor", "describe")


def entry(kind: str, name: str, settings: Mapping[str, Any]) -> tuple[ModuleType, dict[str, Any]]:
    """Return the module and the settings of ``describe`` for an entry ``name: settings``.

    The entry has the name of the module. A variant may have any name. Then ``descriptor`` names the module,
    as in ``centrist_laplacian: {descriptor: centrist, image: laplacian}``.
    """
    own = dict(settings)
    return load(kind, own.pop("descriptor", name)), own
