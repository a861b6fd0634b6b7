"""Look up descriptor modules by name, and check their settings."""

import inspect
from collections.abc import Callable, Mapping
from functools import lru_cache
from types import ModuleType
from typing import Any, TypeVar

from placecat import lookup
from placecat.settings import refuse_unknown

_Function = TypeVar("_Function", bound=Callable[..., Any])


def settings_of(function: Callable[..., Any]) -> dict[str, Any]:
    """Return a function's settings (its keyword-only parameters) with their defaults, in order.

    A required setting has the default `inspect.Parameter.empty`.
    """
    return dict(_keywords(function))


def passing_on(*functions: Callable[..., Any]) -> Callable[[_Function], _Function]:
    """Decorate a function that passes its ``**settings`` to other functions.

    `settings_of` then also returns the other functions' settings, so each default is written only once.
    """

    def decorate(function: _Function) -> _Function:
        signature = inspect.signature(function)
        parameters = dict(signature.parameters)
        parameters.popitem()
        for other in functions:
            for name, parameter in inspect.signature(other).parameters.items():
                if parameter.kind is inspect.Parameter.KEYWORD_ONLY:
                    parameters.setdefault(name, parameter)
        # The signature that `inspect` reports.
        function.__signature__ = signature.replace(parameters=list(parameters.values()))  # type: ignore
        return function

    return decorate


def parts_of(
    settings: Mapping[str, Any], owner: Callable[..., Any], *functions: Callable[..., Any]
) -> list[dict[str, Any]]:
    """Split the settings of a function decorated with `passing_on` among the functions that it calls.

    Raises TypeError if a setting is unknown.
    """
    unknown = settings.keys() - _keywords(owner)
    if unknown:
        raise TypeError(f"{owner.__name__} has no setting {min(unknown)!r}")
    return [{name: settings[name] for name in _keywords(one) if name in settings} for one in functions]


@lru_cache(maxsize=256)
def _keywords(function: Callable[..., Any]) -> dict[str, Any]:
    parameters = inspect.signature(function).parameters.values()
    return {p.name: p.default for p in parameters if p.kind is inspect.Parameter.KEYWORD_ONLY}


def check_settings(function: Callable[..., Any], settings: Mapping[str, Any], owner: str) -> None:
    """Reject settings that a function does not accept.

    Parameters
    ----------
    function
        The function; `settings_of` returns its settings.
    settings
        Maps each setting to its value.
    owner
        What the message calls the settings' owner, e.g. "local descriptor 'hog'". The PlacecatError names
        the first unknown setting and the valid ones.
    """
    refuse_unknown(settings, list(settings_of(function)), f"The {owner}")


def entry(
    package: str, name: str, settings: Mapping[str, Any], kind: str
) -> tuple[ModuleType, dict[str, Any]]:
    """Find the descriptor module for an entry ``name: settings``, and check the settings.

    The entry has the module's name. A variant may have any name; ``descriptor`` then names the module:
    ``centrist_laplacian: {descriptor: centrist, image: laplacian}``.

    Parameters
    ----------
    package
        The package's full name.
    name
        The entry's name.
    settings
        Settings for the module's ``describe``; a variant also has ``descriptor``.
    kind
        What messages call the entry, e.g. "local descriptor".

    Returns
    -------
    module, settings
        The descriptor's module, and the settings without ``descriptor``.

    Raises
    ------
    PlacecatError
        If the module or a setting is unknown; the message names the entry and the valid choices.
    """
    own = dict(settings)
    wanted = own.pop("descriptor", name)
    what = kind if wanted == name else f"entry '{name}': {kind}"
    module = lookup.module(package, wanted, what, "describe")
    check_settings(module.describe, own, f"{kind} '{name}'")
    return module, own
