"""The pieces, one module each, whose generator ``entries()`` yields the measurements one by one."""

from collections.abc import Callable, Iterator

from placecat import lookup
from placecat_bench.comparison import Entry

Entries = Callable[..., Iterator[Entry]]


def names() -> list[str]:
    """Names of the pieces, sorted."""
    return lookup.names(__name__, "entries")


def load(name: str) -> Entries:
    """Give the function ``entries`` of a piece; raises PlacecatError if there is no such piece."""
    entries: Entries = lookup.module(__name__, name, "the piece", "entries").entries
    return entries
