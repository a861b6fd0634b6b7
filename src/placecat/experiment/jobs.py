"""Run the jobs of a sweep: skip finished jobs, and continue after a killed one."""

import math
import os
import sys
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any

from joblib.externals.loky.process_executor import TerminatedWorkerError

from placecat.errors import PlacecatError
from placecat.experiment import job, output
from placecat.experiment.combination import Experiment
from placecat.experiment.made_from import is_finished, made_from
from placecat.runs import lock

_NO_RESULT = "no result"
# Runs jobs with these overrides.
Launch = Callable[[Sequence[Sequence[str]]], Any]


@contextmanager
def alone(folder: Path) -> Iterator[None]:
    """Make and lock the folder of a sweep, after any other process; if stopped, print how to continue."""
    folder.mkdir(parents=True, exist_ok=True)
    with lock.waiting(folder / ".lock", f"Another process is running this sweep ({folder}): waiting for it."):
        try:
            yield
        except KeyboardInterrupt:
            print(f"placecat: stopped; the same command continues {folder}", file=sys.stderr, flush=True)
            raise


def run(
    folder: Path,
    lines: Sequence[Sequence[str]],
    experiments: Sequence[Experiment | None],
    launch: Launch,
    *,
    first: int = 0,
) -> list[float]:
    """Run the unfinished jobs; each has a folder named by its number, starting with `first`.

    `lines` are the overrides of each job. `experiments` are the resolved experiments, None if only the job
    itself can refuse its overrides. Returns the accuracies in percent, in the order of the jobs; NaN if a job
    has none.
    """
    numbers = range(first, first + len(lines))
    todo = []
    for number, experiment in zip(numbers, experiments, strict=True):
        own = folder / str(number)
        if experiment is None or not is_finished(own, made_from(experiment)):
            # The existing result has other settings, data or code, or its job failed.
            (own / output.RESULT).unlink(missing_ok=True)
            todo.append(number)
    if len(todo) < len(lines):
        print(f"{len(lines) - len(todo)} of {len(lines)} experiments are finished in {folder}: not run again")
    os.environ[job.WORKERS_OF] = str(os.getpid())

    def start(some: Sequence[int]) -> None:
        # Set the number here, since Hydra counts only the jobs of this call.
        launch([[*lines[number - first], f"hydra.sweep.subdir={number}"] for number in some])

    def failed(number: int) -> str | None:
        return _result(folder, number).get(output.FAILED)

    while todo:
        try:
            start(todo)
            break
        except TerminatedWorkerError:
            # A killed job ends all jobs beside it: run each again alone.
            killed = [number for number in todo if failed(number) == output.KILLED]
            if not killed:
                raise
            for number in killed:
                with suppress(TerminatedWorkerError):
                    start([number])
            todo = [number for number in todo if failed(number) == _NO_RESULT]
    accuracies = [_result(folder, number)["accuracy"] for number in numbers]
    return [math.nan if accuracy is None else float(accuracy) for accuracy in accuracies]


def _result(folder: Path, number: int) -> dict[str, Any]:
    try:
        return output.read(folder / str(number))
    except PlacecatError:
        return output.failure(_NO_RESULT)
