"""The pieces of the benchmark. Each module has a function ``entries`` that yields the entries to measure."""

from collections.abc import Callable, Iterator

from placecat import lookup
from placecat_bench.comparison import Entry

Entries = Callable[..., Iterator[Entry]]


def names() -> list[str]:
    """Names of the pieces, sorted."""
    return lookup.names(__name__, "entries")


def load(name: str) -> Entries:
    """Return the function ``entries`` of a piece. Raises PlacecatError if the piece does not exist."""
    entries: Entries = lookup.module(__name__, name, "the piece", "entries").entries
    return entries
