"""The jobs of a sweep: finished ones are not run again, and a killed one does not end the others."""

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
# Runs some jobs, given by their overrides.
Launch = Callable[[Sequence[Sequence[str]]], Any]


@contextmanager
def alone(folder: Path) -> Iterator[None]:
    """Make the folder of a sweep and wait while another process runs it; if stopped, say how to continue."""
    folder.mkdir(parents=True, exist_ok=True)
    with lock.waiting(
        folder / ".lock", f"Another process runs this sweep ({folder}): this one waits for it."
    ):
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
    """Run the unfinished jobs; each has a folder named by its number, from `first` on.

    `lines` and `experiments` are for each job its overrides and its resolved experiment, None if only the job
    itself can refuse them. Returns the accuracies in percent, in the order of the jobs; NaN for none.
    """
    numbers = range(first, first + len(lines))
    todo = []
    for number, experiment in zip(numbers, experiments, strict=True):
        own = folder / str(number)
        if experiment is None or not is_finished(own, made_from(experiment)):
            # The existing result is of other settings, data or code, or of a failed job.
            (own / output.RESULT).unlink(missing_ok=True)
            todo.append(number)
    if len(todo) < len(lines):
        print(f"{len(lines) - len(todo)} of {len(lines)} experiments are finished in {folder}: not run again")
    os.environ[job.WORKERS_OF] = str(os.getpid())

    def start(some: Sequence[int]) -> None:
        # The number is set here, since Hydra counts only the jobs of this call.
        launch([[*lines[number - first], f"hydra.sweep.subdir={number}"] for number in some])

    def failed(number: int) -> str | None:
        return _result(folder, number).get(output.FAILED)

    while todo:
        try:
            start(todo)
            break
        except TerminatedWorkerError:
            # One job ended all that ran beside it: run each again alone.
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
