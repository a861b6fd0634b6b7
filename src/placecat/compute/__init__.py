"""Where loops run: on this machine or on a Dask cluster, by the settings `compute`."""

import os
from collections.abc import Iterator
from contextlib import contextmanager
from functools import cached_property
from typing import TYPE_CHECKING

from placecat.errors import PlacecatError

if TYPE_CHECKING:
    from placecat.compute.connection import Cluster

KINDS = ("local", "dask")
# On one machine; more is a typing error.
_MOST_WORKERS = 1024


class _Choice:
    """The choice of params.yaml, read when a loop first asks, since many stages have no loop."""

    @cached_property
    def cluster(self) -> "Cluster | None":
        from placecat import settings

        # Older settings without `compute` mean this machine.
        options = dict(settings.load().get("compute", {"kind": "local"}))
        kind = options.pop("kind", None)
        if kind not in KINDS:
            raise PlacecatError(f"compute.kind must be {' or '.join(KINDS)}, not {kind!r}")
        if kind == "local":
            settings.refuse_unknown(options, [], "compute")
            return None
        from placecat.compute.connection import Cluster

        cluster: Cluster = settings.call(Cluster, settings=options, where="compute")
        return cluster

    def close(self) -> None:
        connected = vars(self).get("cluster")
        if connected is not None:
            connected.close()


_choice: _Choice | None = None


@contextmanager
def as_set() -> Iterator[None]:
    """Run the loops of a block where params.yaml says; the end of the block disconnects from a cluster."""
    global _choice
    before, _choice = _choice, _Choice()
    try:
        yield
    finally:
        _choice.close()
        _choice = before


def local_workers() -> int:
    """Worker processes on this machine: the environment variable PLACECAT_WORKERS, else its cores.

    It is not a setting of params.yaml, since no result depends on it. Raises PlacecatError if it is not a
    positive whole number.
    """
    wanted = wanted_workers()
    if wanted is not None:
        return wanted
    # Late, since it imports NumPy.
    from joblib import cpu_count

    return int(cpu_count())


def wanted_workers() -> int | None:
    """The value of PLACECAT_WORKERS, see :func:`local_workers`; None if unset or empty."""
    value = os.environ.get("PLACECAT_WORKERS", "").strip()
    if not value:
        return None
    if not (value.isascii() and value.isdigit() and 1 <= int(value[:9]) <= _MOST_WORKERS and len(value) < 9):
        raise PlacecatError(
            f"PLACECAT_WORKERS={value} is not a number of processes: give 1 to {_MOST_WORKERS}, or unset it "
            "for as many as there are cores"
        )
    return int(value)


def cluster() -> "Cluster | None":
    """Return the cluster that loops run on, None for this machine; errors as for its `Cluster`."""
    return None if _choice is None else _choice.cluster
