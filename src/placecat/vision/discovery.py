"""The modules of descriptors that settings name, and their settings checked."""

import inspect
from collections.abc import Callable, Mapping
from functools import lru_cache
from types import ModuleType
from typing import Any

from placecat import lookup
from placecat.settings import refuse_unknown


def settings_of(function: Callable[..., Any]) -> dict[str, Any]:
    """List the settings of a function, its keyword-only parameters, with their defaults.

    Parameters
    ----------
    function
        Any function.

    Returns
    -------
    dict
        Setting to default (`inspect.Parameter.empty` without one), in the order written.
    """
    return dict(_keywords(function))


@lru_cache(maxsize=256)
def _keywords(function: Callable[..., Any]) -> dict[str, Any]:
    parameters = inspect.signature(function).parameters.values()
    return {p.name: p.default for p in parameters if p.kind is inspect.Parameter.KEYWORD_ONLY}


def check_settings(function: Callable[..., Any], settings: Mapping[str, Any], owner: str) -> None:
    """Refuse settings that a function does not have.

    Parameters
    ----------
    function
        The function that will take the settings as keywords.
    settings
        Setting to value.
    owner
        What a message calls their owner, e.g. "local descriptor 'hog'".

    Raises
    ------
    PlacecatError
        Naming the owner, the first unknown setting and the valid ones.
    """
    refuse_unknown(settings, list(settings_of(function)), f"The {owner}")


def entry(
    package: str, name: str, settings: Mapping[str, Any], kind: str
) -> tuple[ModuleType, dict[str, Any]]:
    """Find the module of a descriptor that the settings name, and check its own settings.

    An entry ``name: settings`` means the module of this name. A variant has a name of its own and says of
    which module it is: ``centrist_laplacian: {descriptor: centrist, image: laplacian}``.

    Parameters
    ----------
    package
        The package's full name.
    name
        Name of the entry.
    settings
        Settings of the module's ``describe``, and ``descriptor`` for a variant.
    kind
        What a message calls it, e.g. "local descriptor".

    Returns
    -------
    module, settings
        The settings without ``descriptor``.

    Raises
    ------
    PlacecatError
        Naming the entry, the unknown module or setting, and the valid ones.
    """
    own = dict(settings)
    wanted = own.pop("descriptor", name)
    what = kind if wanted == name else f"entry '{name}': {kind}"
    module = lookup.module(package, wanted, what, "describe")
    check_settings(module.describe, own, f"{kind} '{name}'")
    return module, own
