"""joblib's backend for Dask, made to end when the cluster does not."""

import asyncio
from dataclasses import dataclass
from typing import Any

from distributed import Client, KilledWorker
from joblib._dask import DaskDistributedBackend

from placecat.errors import PlacecatError

LOST = "the connection to the cluster's scheduler was lost: see that it runs, then run this again"
_SECONDS_BETWEEN_LOOKS = 1.0


@dataclass(frozen=True)
class _Lost:
    """Stands for the result of a task that will have none."""

    error: PlacecatError


class ClusterBackend(DaskDistributedBackend):
    """joblib's own backend, but for tasks that end without a result.

    joblib (1.6) leaves its caller waiting for ever if Dask gives a task up because it was on several workers
    that died, and if all workers have gone; and it computes in the caller's process where the cluster has a
    single worker.

    Parameters
    ----------
    client
        Connected.
    wait
        Seconds without any worker after which tasks are given up.
    """

    def __init__(self, client: Client, wait: float) -> None:
        super().__init__(client=client)
        self._wait = wait

    def effective_n_jobs(self, n_jobs: int) -> int:
        """More than one, whatever the cluster has: all tasks are sent at once."""
        return 2

    def start_call(self) -> None:
        """Begin to collect results, and to look whether there are workers."""
        super().start_call()
        self.client.loop.add_callback(self._look_after_workers)

    def retrieve_result_callback(self, out: Any) -> Any:
        """Give a task's result, or raise what it raised."""
        if isinstance(out, _Lost):
            raise out.error
        return super().retrieve_result_callback(out)

    def abort_everything(self, ensure_ready: bool = True) -> None:
        """Cancel all tasks on the cluster; those that run there end, but nobody gets what they give."""
        left = list(self._results)
        super().abort_everything(ensure_ready)
        if self.client.status == "running":
            self.client.cancel(left)

    async def _collect(self) -> None:
        while self._continue:
            async for future, result in self.waiting_futures:
                if future.status == "finished":
                    self._end(future, result)
                else:
                    self._end(future, _Lost(_reason(future.status, result)))
            await asyncio.sleep(0.01)

    async def _look_after_workers(self) -> None:
        left = self._wait
        while self._continue:
            await asyncio.sleep(_SECONDS_BETWEEN_LOOKS)
            try:
                workers = await self.client.scheduler.ncores()
            except Exception:
                # The client sees by itself that the scheduler has gone, and cancels all tasks.
                continue
            left = self._wait if workers else left - _SECONDS_BETWEEN_LOOKS
            if left <= 0:
                error = PlacecatError(
                    f"the cluster has had no worker for {self._wait:g} s: start some (`placecat worker "
                    f"{self.client.scheduler.address}`), then run this again, or raise compute.wait"
                )
                for future in list(self._results):
                    self._end(future, _Lost(error))

    def _end(self, future: Any, result: Any) -> None:
        promise = self._results.pop(future, None)
        if promise is not None:
            promise.set_result(result)
            self._callbacks.pop(future)(result)


def _reason(status: str, result: Any) -> PlacecatError:
    """Why a task has no result: what it raised itself would be one."""
    if status != "error":
        return PlacecatError(LOST)
    error = result[1]
    if isinstance(error, KilledWorker):
        last = getattr(error.last_worker, "address", error.last_worker)
        return PlacecatError(
            f"{error.allowed_failures + 1} workers died of the same task, the last one {last}: their logs "
            "say why; if for want of memory, start fewer on a machine (--nworkers N of `placecat worker`)"
        )
    return PlacecatError(f"a task failed on the cluster ({type(error).__name__}: {error})")
