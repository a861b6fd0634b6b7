"""Run the jobs of a sweep, except finished ones, and continue if one is killed."""

import math
import os
from collections.abc import Callable, Sequence
from contextlib import suppress
from pathlib import Path
from typing import Any

from joblib.externals.loky.process_executor import TerminatedWorkerError

from placecat.experiment import job, output
from placecat.experiment.combination import Experiment
from placecat.experiment.running import is_finished, made_from

# A function that runs one job for each list of overrides.
Launch = Callable[[Sequence[Sequence[str]]], Any]


def run(
    folder: Path,
    lines: Sequence[Sequence[str]],
    experiments: Sequence[Experiment | None],
    launch: Launch,
    *,
    first: int = 0,
) -> list[float]:
    """Run the unfinished jobs. Each job folder is named after the number of the job, counting from `first`.

    `lines` contains the overrides of each job. `experiments` contains its resolved experiment, or None if its
    settings are invalid, in which case the job itself reports why. Returns the accuracy of each job in
    percent, in order, or NaN if it has none.
    """
    numbers = range(first, first + len(lines))
    todo = []
    for number, experiment in zip(numbers, experiments, strict=True):
        own = folder / str(number)
        if experiment is None or not is_finished(own, made_from(experiment)):
            # The result is missing, is a failure, or comes from different settings, data or code.
            (own / output.RESULT).unlink(missing_ok=True)
            todo.append(number)
    if len(todo) < len(lines):
        print(f"{len(lines) - len(todo)} of {len(lines)} experiments in {folder} are already finished")
    os.environ[job.WORKERS_OF] = str(os.getpid())

    def start(some: Sequence[int]) -> None:
        # Number the jobs here, since Hydra counts only the jobs in this call.
        launch([[*lines[number - first], f"hydra.sweep.subdir={number}"] for number in some])

    while todo:
        try:
            start(todo)
            break
        except TerminatedWorkerError:
            # A killed job takes all running jobs down with it: rerun each of them on its own.
            found = {number: output.read(folder / str(number)) for number in todo}
            killed = [number for number in todo if found[number].get(output.FAILED) == output.KILLED]
            if not killed:
                raise
            for number in killed:
                with suppress(TerminatedWorkerError):
                    start([number])
            todo = [number for number in todo if not (folder / str(number) / output.RESULT).exists()]
    accuracies = [output.read(folder / str(number))["accuracy"] for number in numbers]
    return [math.nan if accuracy is None else float(accuracy) for accuracy in accuracies]
