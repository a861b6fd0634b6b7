"""A connection to a Dask cluster all of whose workers give the same bits as this machine."""

import asyncio
import contextlib
import logging
import pickle
import uuid
from collections.abc import Callable, Iterable, Iterator, Sequence
from pathlib import Path
from typing import Any

from placecat import files, paths
from placecat.compute.fingerprint import fingerprint
from placecat.compute.worker import Expected, objection, perform
from placecat.errors import PlacecatError


class Cluster:
    """Runs tasks on a Dask cluster, through joblib's backend.

    Parameters
    ----------
    scheduler
        Its address, e.g. ``tcp://10.0.0.1:8786``.
    wait
        Seconds to wait for the scheduler, for a first worker, and for another one when all have gone.
    may_differ
        Items of :func:`placecat.compute.fingerprint.fingerprint` that need not be as in this process.

    Raises
    ------
    PlacecatError
        Dask is not installed, no scheduler answers, there is no worker, or one that must not compute.
    """

    def __init__(self, *, scheduler: str, wait: float = 30, may_differ: Sequence[str] = ()) -> None:
        client = _distributed()
        own = fingerprint()
        for item in may_differ:
            if item not in own:
                raise PlacecatError(
                    f"compute.may_differ has {item!r}, which is nothing that is compared (valid: "
                    f"{', '.join(own)})"
                )
        if not isinstance(wait, int | float) or wait <= 0:
            raise PlacecatError(f"compute.wait must be a number of seconds above 0, not {wait!r}")
        self._wait = float(wait)
        self._client = _connect(client, scheduler, self._wait)
        mark = paths.COMPUTE / uuid.uuid4().hex
        self._mark = mark.absolute()
        self._expected = Expected(
            scheduler, str(Path.cwd()), mark.as_posix(), items=own, may_differ=tuple(may_differ)
        )
        try:
            files.write_text(self._mark, "")
            self._check_workers()
        except BaseException:
            self.close()
            raise

    def _check_workers(self) -> None:
        """Refuse a cluster before it computes anything; who joins later is checked by each task."""
        scheduler = self._expected.scheduler
        try:
            self._client.wait_for_workers(1, timeout=self._wait)
        except TimeoutError:
            raise PlacecatError(
                f"the cluster of {scheduler} has no worker: start some (`placecat worker {scheduler}`)"
            ) from None
        from placecat.compute.backend import LOST

        try:
            found = self._client.run(objection, self._expected, on_error="return")
        except OSError:
            raise PlacecatError(LOST) from None
        for address, said in sorted(found.items()):
            if isinstance(said, Exception):
                raise PlacecatError(
                    f"worker {address} cannot run placecat ({type(said).__name__}: {said}): start it with "
                    f"`placecat worker {scheduler}`, from an environment as this one"
                )
            if said is not None:
                raise PlacecatError(said)

    def workers(self) -> int:
        """Number of worker processes; each does one task at a time."""
        return max(1, len(self._client.ncores()))

    def run(self, function: Callable[..., Any], tasks: Iterable[tuple[Any, ...]]) -> Iterator[Any]:
        """Call ``function(*task)`` on the cluster for every task.

        If a worker dies, others do what it had to do. Closing the iterator cancels what is left.

        Returns
        -------
        iterator
            The results in the order of `tasks`.

        Raises
        ------
        PlacecatError
            A task's own; or the scheduler or all workers are gone, or several workers died of a task.
        """
        import cloudpickle
        from joblib import Parallel, delayed

        from placecat.compute.backend import ClusterBackend

        calls = (delayed(perform)(self._expected, cloudpickle.dumps((function, task))) for task in tasks)
        # All at once, so that workers that join later find some; one by one, so that a task that kills its
        # worker takes no other along.
        backend = ClusterBackend(self._client, self._wait)
        results = Parallel(backend=backend, return_as="generator", pre_dispatch="all", batch_size=1)(calls)
        for result in results:
            yield pickle.loads(result)

    def close(self) -> None:
        """Disconnect: the scheduler forgets what it still has to do for this process."""
        self._mark.unlink(missing_ok=True)
        with contextlib.suppress(OSError):
            # Another stage may be running.
            self._mark.parent.rmdir()
        self._client.close()


def _distributed() -> Any:
    """Give distributed's client, made to say nothing itself."""
    try:
        import dask
        from distributed import Client
    except ImportError as error:
        raise PlacecatError(
            f"compute=dask needs the optional extra ({error.name} is missing): pip install -e '.[dask]'"
        ) from None
    # What goes wrong is said once, by a PlacecatError.
    for name in ("distributed", "distributed.client"):
        logging.getLogger(name).setLevel(logging.CRITICAL)
    # Arguments of tasks are few enough to go through the scheduler.
    dask.config.set({"distributed.admin.large-graph-warning-threshold": "1 GiB"})
    return Client


def _connect(client: Any, scheduler: str, wait: float) -> Any:
    try:
        # Asked first, since the client would wait for ever for an answer from a server of another kind.
        kind = asyncio.run(_kind(scheduler, wait))
        if kind != "Scheduler":
            raise ValueError(f"there is a {kind}")
        return client(scheduler, timeout=wait, set_as_default=False)
    except (OSError, ValueError, TypeError) as error:
        reason = " ".join(str(error).split()) or f"no answer for {wait:g} s"
        raise PlacecatError(
            f"no scheduler answers at compute.scheduler={scheduler} ({reason}): start one (`dask "
            "scheduler`), or use compute=local"
        ) from None


async def _kind(address: str, wait: float) -> str:
    """What of Dask's is at an address, e.g. ``Scheduler``."""
    from distributed import Security, rpc

    # Certificates of tls:// addresses are those of Dask's own configuration.
    secured = Security().get_connection_args("client")
    async with asyncio.timeout(wait), rpc(address, timeout=wait, connection_args=secured) as server:
        return str((await server.identity())["type"])
