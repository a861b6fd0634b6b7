"""Import packages that only networks need."""

import importlib
from collections.abc import Sequence
from types import ModuleType

from placecat.errors import PlacecatError

INSTALL = "run `pip install -e '.[deep]'` in placecat's environment"


def import_packages(names: Sequence[str], wanted_by: str) -> list[ModuleType]:
    """Import modules that the `deep` extra installs.

    Raises a PlacecatError that names `wanted_by` and the first package that is missing or cannot be imported.
    """
    modules = []
    for name in names:
        try:
            modules.append(importlib.import_module(name))
        except ModuleNotFoundError as error:
            raise PlacecatError(
                f"{wanted_by} needs the package {error.name or name}, which is missing: {INSTALL}"
            ) from None
        except ImportError as error:
            said = " ".join(str(error).split())
            raise PlacecatError(
                f"{wanted_by} needs the package {name}, which cannot be imported ({said})"
            ) from None
    return modules
