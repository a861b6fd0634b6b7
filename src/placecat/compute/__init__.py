"""Run loops on this machine or on a Dask cluster, depending on the `compute` settings."""

import os
import re
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager
from functools import cache
from typing import TYPE_CHECKING

from placecat.errors import PlacecatError

if TYPE_CHECKING:
    from placecat.compute.connection import Cluster

# Largest number of workers on one machine; a larger number is probably a typo.
_MOST_WORKERS = 1024

# Connects to the chosen cluster only when the first loop runs, because many stages have no loop.
_connect: Callable[[], "Cluster | None"] | None = None


@contextmanager
def as_set() -> Iterator[None]:
    """Apply the `compute` settings in params.yaml within a block, then disconnect from any cluster."""
    global _connect
    before = _connect
    with ExitStack() as connected:
        _connect = cache(lambda: _as_set(connected))
        try:
            yield
        finally:
            _connect = before


def _as_set(connected: ExitStack) -> "Cluster | None":
    from placecat import schema, settings

    # An older params.yaml lacks `compute`; its loops run on this machine.
    options = dict(settings.load().get("compute", {"kind": "local"}))
    schema.check({"compute": options})
    if options.pop("kind") == "local":
        return None
    from placecat.compute.connection import Cluster

    cluster = Cluster(**options)
    connected.callback(cluster.close)
    return cluster


def local_workers() -> int:
    """Return the number of local worker processes: PLACECAT_WORKERS if set, else the number of cores.

    PLACECAT_WORKERS is an environment variable, not a setting, because results do not depend on it. Raises
    PlacecatError if its value is not an integer from 1 to 1024.
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
    if not (re.fullmatch("[0-9]{1,9}", value) and 1 <= int(value) <= _MOST_WORKERS):
        raise PlacecatError(
            f"PLACECAT_WORKERS={value} is not a number of processes: use 1 to {_MOST_WORKERS}, or unset it "
            "to use all cores"
        )
    return int(value)


def cluster() -> "Cluster | None":
    """Return the cluster that runs loops, or None for this machine. Raises the same errors as `Cluster`."""
    return None if _connect is None else _connect()
