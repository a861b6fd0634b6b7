"""The connection to a Dask cluster whose results are bit-identical to those of this machine."""

import asyncio
import contextlib
import logging
import pickle
import queue
import uuid
from collections.abc import Callable, Iterable, Iterator, Sequence
from pathlib import Path
from typing import Any

from placecat import files, paths
from placecat.compute.fingerprint import fingerprint
from placecat.compute.worker import Expected, objection, perform
from placecat.errors import PlacecatError

LOST = "the connection to the cluster's scheduler was lost: check that it is running, then run this again"
_SECONDS_BETWEEN_LOOKS = 1.0


class Cluster:
    """A Dask cluster that runs tasks.

    `scheduler` is an address, such as ``tcp://10.0.0.1:8786``. `wait` is how many seconds to wait for the
    scheduler, for the first worker, and for a new worker if all are gone. `may_differ` lists the items of
    :func:`placecat.compute.fingerprint.fingerprint` that may differ from those of this process. Raises
    PlacecatError if Dask is not installed, if no scheduler responds, or if workers are missing or unfit.
    """

    def __init__(self, *, scheduler: str, wait: float = 30, may_differ: Sequence[str] = ()) -> None:
        client = _distributed()
        here = fingerprint()
        for item in may_differ:
            if item not in here:
                raise PlacecatError(
                    f"compute.may_differ contains {item!r}, which is not compared: "
                    f"choose from {', '.join(here)}"
                )
        self._wait = float(wait)
        self._client = _connect(client, scheduler, self._wait)
        mark = paths.COMPUTE / uuid.uuid4().hex
        self._mark = mark.absolute()
        self._expected = Expected(
            scheduler, str(Path.cwd()), mark.as_posix(), items=here, may_differ=tuple(may_differ)
        )
        try:
            files.write_text(self._mark, "")
            self._check_workers()
        except BaseException:
            self.close()
            raise

    def _check_workers(self) -> None:
        """Raise PlacecatError if a worker is unfit. Workers that join later are checked by their tasks."""
        scheduler = self._expected.scheduler
        try:
            self._client.wait_for_workers(1, timeout=self._wait)
        except TimeoutError:
            raise PlacecatError(
                f"the cluster at {scheduler} has no workers: start some (`placecat worker {scheduler}`)"
            ) from None
        try:
            objections = self._client.run(objection, self._expected, on_error="return")
        except OSError:
            raise PlacecatError(LOST) from None
        for address, said in sorted(objections.items()):
            if isinstance(said, Exception):
                raise PlacecatError(
                    f"worker {address} cannot run placecat ({type(said).__name__}: {said}): start it with "
                    f"`placecat worker {scheduler}`, in an environment like this one"
                )
            if said is not None:
                raise PlacecatError(said)

    def workers(self) -> int:
        """Return the number of worker processes; each runs one task at a time."""
        return max(1, len(self._client.ncores()))

    def run(self, function: Callable[..., Any], tasks: Iterable[tuple[Any, ...]]) -> Iterator[Any]:
        """Call ``function(*task)`` on the cluster for every task; yield the results in the order of `tasks`.

        If a worker dies, others take over its tasks. Closing the iterator cancels the remaining tasks. Raises
        PlacecatError if a task raises one, if the scheduler or all workers are gone, or if a task killed
        several workers.
        """
        import cloudpickle

        calls = [cloudpickle.dumps((function, task)) for task in tasks]
        # Send all tasks at once, so that workers that join later get some. Dask would merge identical pure
        # calls.
        sent = self._client.map(perform, [self._expected] * len(calls), calls, pure=False)
        # Workers free a result once its future is deleted here.
        left = {future.key: future for future in sent}
        del sent
        ended: queue.SimpleQueue[Any] = queue.SimpleQueue()
        for key in left:
            left[key].add_done_callback(ended.put)
        results: dict[Any, bytes] = {}
        try:
            for key in list(left):
                while key not in results:
                    done = self._next(ended)
                    results[done.key] = _result(done)
                    del left[done.key], done
                yield pickle.loads(results.pop(key))
        finally:
            if left and self._client.status == "running":
                self._client.cancel(list(left.values()))

    def _next(self, ended: "queue.SimpleQueue[Any]") -> Any:
        """Wait for a task to end; give up after `wait` seconds without a worker."""
        patience = self._wait
        while True:
            with contextlib.suppress(queue.Empty):
                return ended.get(timeout=_SECONDS_BETWEEN_LOOKS)
            # If the scheduler is gone, the client notices and cancels all tasks.
            with contextlib.suppress(OSError):
                patience = self._wait if self._client.ncores() else patience - _SECONDS_BETWEEN_LOOKS
            if patience <= 0:
                raise PlacecatError(
                    f"the cluster has had no workers for {self._wait:g} s: start some (`placecat worker "
                    f"{self._client.scheduler.address}`), then run this again, or raise compute.wait"
                )

    def close(self) -> None:
        """Disconnect; the scheduler then drops the remaining tasks of this process."""
        self._mark.unlink(missing_ok=True)
        with contextlib.suppress(OSError):
            # Another stage may still be using the folder; rmdir then fails.
            self._mark.parent.rmdir()
        self._client.close()


def _result(future: Any) -> bytes:
    """Return the result of a task; raise its exception, or a PlacecatError that says why there is none."""
    from distributed import KilledWorker

    if future.status not in ("finished", "error"):
        raise PlacecatError(LOST)
    try:
        return bytes(future.result())
    except KilledWorker as error:
        last = getattr(error.last_worker, "address", error.last_worker)
        raise PlacecatError(
            f"{error.allowed_failures + 1} workers died while running the same task, the last one {last}: "
            "see their logs; if memory ran out, start fewer per machine (--nworkers N of `placecat worker`)"
        ) from None


def _distributed() -> Any:
    """Import the Dask distributed client and silence its own messages."""
    try:
        import dask
        from distributed import Client
    except ImportError as error:
        raise PlacecatError(
            f"compute=dask needs the optional extra ({error.name} is missing): pip install -e '.[dask]'"
        ) from None
    # Each problem is reported only once, as a PlacecatError.
    for name in ("distributed", "distributed.client"):
        logging.getLogger(name).setLevel(logging.CRITICAL)
    # Do not warn about large arguments: the scheduler can handle them.
    dask.config.set({"distributed.admin.large-graph-warning-threshold": "1 GiB"})
    return Client


def _connect(client: Any, scheduler: str, wait: float) -> Any:
    try:
        # Check first: the client would wait forever if a different kind of server responded.
        kind = asyncio.run(_kind(scheduler, wait))
        if kind != "Scheduler":
            raise ValueError(f"found a {kind}")
        return client(scheduler, timeout=wait, set_as_default=False)
    except (OSError, ValueError, TypeError) as error:
        reason = " ".join(str(error).split()) or f"no response for {wait:g} s"
        raise PlacecatError(
            f"no scheduler is responding at compute.scheduler={scheduler} ({reason}): start one (`dask "
            "scheduler`), or use compute=local"
        ) from None


async def _kind(address: str, wait: float) -> str:
    """Return the kind of Dask server at an address, such as ``Scheduler``."""
    from distributed import Security, rpc

    # Certificates for tls:// addresses come from the Dask configuration.
    secured = Security().get_connection_args("client")
    async with asyncio.timeout(wait), rpc(address, timeout=wait, connection_args=secured) as server:
        return str((await server.identity())["type"])
