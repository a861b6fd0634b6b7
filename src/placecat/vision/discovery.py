"""The modules of descriptors that settings name, and their settings checked."""

import inspect
from collections.abc import Callable, Mapping
from functools import lru_cache
from types import ModuleType
from typing import Any, TypeVar

from placecat import lookup
from placecat.settings import refuse_unknown

_Function = TypeVar("_Function", bound=Callable[..., Any])


def settings_of(function: Callable[..., Any]) -> dict[str, Any]:
    """List the settings of a function, its keyword-only parameters, with their defaults.

    Parameters
    ----------
    function
        Any function.

    Returns
    -------
    Setting to default (`inspect.Parameter.empty` without one), in the order written.
    """
    return dict(_keywords(function))


def passing_on(*functions: Callable[..., Any]) -> Callable[[_Function], _Function]:
    """Decorate a function with ``**settings``: those are the settings of other functions that it calls.

    So a default is written once, at the function that uses it; `settings_of` gives them all.
    """

    def decorate(function: _Function) -> _Function:
        signature = inspect.signature(function)
        parameters = dict(signature.parameters)
        parameters.popitem()
        for other in functions:
            for name, parameter in inspect.signature(other).parameters.items():
                if parameter.kind is inspect.Parameter.KEYWORD_ONLY:
                    parameters.setdefault(name, parameter)
        # What `inspect` then tells of the function.
        function.__signature__ = signature.replace(parameters=list(parameters.values()))  # type: ignore
        return function

    return decorate


def parts_of(
    settings: Mapping[str, Any], owner: Callable[..., Any], *functions: Callable[..., Any]
) -> list[dict[str, Any]]:
    """Divide what `passing_on` lets an owner take: the settings that each of the functions has.

    Raises
    ------
    TypeError
        If one of them is no setting of the owner.
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
