"""Find an estimator of `placecat.learning` by the name of its module."""

import importlib
import inspect
import pkgutil
from collections.abc import Mapping
from typing import Any

from sklearn.base import BaseEstimator

from placecat import learning, settings
from placecat.errors import PlacecatError


def build(options: Mapping[str, Any], where: str, **fixed: Any) -> Any:
    """Make the estimator that ``options["name"]`` names, with the other options as its parameters.

    Parameters
    ----------
    options
        ``name`` is a module of `placecat.learning` that defines one estimator.
    where
        What the message calls the options.
    **fixed
        Parameters that are no settings, e.g. a seed.

    Raises
    ------
    PlacecatError
        Unknown estimator or unknown parameter; the message names the valid ones.
    """
    name = str(settings.get(options, "name"))
    known = [module.name for module in pkgutil.iter_modules(learning.__path__)]
    if name not in known:
        raise PlacecatError(f"{where}.name {name!r} does not exist: use one of {', '.join(known)}")
    module = importlib.import_module(f"{learning.__name__}.{name}")
    estimators = [
        member
        for _, member in inspect.getmembers(module, inspect.isclass)
        if issubclass(member, BaseEstimator) and member.__module__ == module.__name__
    ]
    if len(estimators) != 1:
        raise PlacecatError(
            f"{where}.name {name!r} is no estimator: placecat.learning.{name} must define one"
        )
    parameters = {key: value for key, value in options.items() if key != "name"}
    settings.check(estimators[0], parameters, where)
    return estimators[0](**parameters, **fixed)
