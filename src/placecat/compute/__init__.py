"""Choose where loops run: on this machine or on a Dask cluster, as the `compute` settings say."""

import os
from collections.abc import Iterator
from contextlib import contextmanager
from functools import cached_property
from typing import TYPE_CHECKING

from placecat.errors import PlacecatError

if TYPE_CHECKING:
    from placecat.compute.connection import Cluster

KINDS = ("local", "dask")
# Largest number of workers on one machine; a larger number is probably a typo.
_MOST_WORKERS = 1024


class _Choice:
    """The choice in params.yaml, read at the first loop because many stages have no loop."""

    @cached_property
    def cluster(self) -> "Cluster | None":
        from placecat import settings

        # An older params.yaml lacks `compute`; its loops run on this machine.
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
    """Run the loops of a block as set in params.yaml; disconnect from a cluster at its end."""
    global _choice
    before, _choice = _choice, _Choice()
    try:
        yield
    finally:
        _choice.close()
        _choice = before


def local_workers() -> int:
    """Return the number of worker processes on this machine: PLACECAT_WORKERS, or else the number of cores.

    PLACECAT_WORKERS is an environment variable, not a setting, because results do not depend on it. Raises
    PlacecatError unless its value is a whole number from 1 to 1024.
    """
    wanted = wanted_workers()
    if wanted is not None:
        return wanted
    # Imported late: it imports NumPy.
    from joblib import cpu_count

    return int(cpu_count())


def wanted_workers() -> int | None:
    """Return the value of PLACECAT_WORKERS (see :func:`local_workers`); None if unset or empty."""
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
    """Return the cluster that runs loops, or None for this machine; errors as for `Cluster`."""
    return None if _choice is None else _choice.cluster
