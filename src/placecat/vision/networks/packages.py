"""Import packages that only networks need."""

import importlib
from collections.abc import Sequence
from types import ModuleType

from placecat.errors import PlacecatError

INSTALL = "`pip install -e '.[deep]'` in the environment of placecat installs it"


def import_packages(names: Sequence[str], wanted_by: str) -> list[ModuleType]:
    """Import modules that the extra `deep` installs.

    The PlacecatError names the first package that is missing or cannot be imported, and what needs it,
    `wanted_by`.
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
                f"{wanted_by} needs the package {name}, which does not work ({said})"
            ) from None
    return modules
