"""Estimators of `placecat.learning`, looked up by module name."""

from collections.abc import Mapping
from typing import Any

from placecat import learning, lookup
from placecat.schema import signatures


def build(options: Mapping[str, Any], where: str, **fixed: Any) -> Any:
    """Build the estimator named by ``options["name"]``. The other options are its parameters.

    ``name`` is a module of `placecat.learning` that defines one estimator. An unknown estimator or parameter
    raises a PlacecatError that names `where` and the valid choices. `fixed` contains parameters that are not
    settings, such as a seed.
    """
    class_name = signatures.check_estimator(options, where)
    parameters = dict(options)
    module = lookup.module(learning.__name__, parameters.pop("name"), f"{where}.name")
    return getattr(module, class_name)(**parameters, **fixed)
