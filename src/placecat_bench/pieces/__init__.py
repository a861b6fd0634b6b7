"""One module a piece: ``entries()`` gives what to measure.

It is a generator, so that the inputs of pieces are not held together.
"""

import importlib
import pkgutil
from collections.abc import Callable, Iterator

from placecat.errors import PlacecatError
from placecat_bench.comparison import Comparison, Limit

Entries = Callable[..., Iterator[Comparison | Limit]]


def names() -> list[str]:
    """Names of the pieces, sorted."""
    return sorted(module.name for module in pkgutil.iter_modules(__path__))


def load(name: str) -> Entries:
    """Give the function ``entries`` of a piece.

    Raises
    ------
    PlacecatError
        If there is no such piece.
    """
    if name not in names():
        raise PlacecatError(f"there is no piece {name!r} to measure: choose from {', '.join(names())}")
    entries: Entries = importlib.import_module(f"{__name__}.{name}").entries
    return entries
