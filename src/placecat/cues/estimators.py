"""Find an estimator of `placecat.learning` by the name of its module."""

from collections.abc import Mapping
from typing import Any

from placecat import learning, lookup, signatures


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
    class_name = signatures.check_estimator(options, where)
    parameters = dict(options)
    module = lookup.module(learning.__name__, parameters.pop("name"), f"{where}.name")
    return getattr(module, class_name)(**parameters, **fixed)
