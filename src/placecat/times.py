"""How long stages took: measured by each stage, gathered by `placecat repro`, kept in git if asked to.

Nothing here is an output or a dependency of a stage that computes, so that no result depends on it.
"""

import os
import uuid
from dataclasses import dataclass
from typing import Any

import pandas as pd

from placecat import files, paths
from placecat.errors import PlacecatError

# Names the call of `placecat repro` that a stage runs in, in the environment.
CALL = "PLACECAT_CALL"
COLUMNS = ["stage", "item", "seconds"]


@dataclass(frozen=True)
class Run:
    """Times of one call of `placecat repro`.

    Attributes
    ----------
    stages
        A row a stage that ran in the call: stage, item ("" for none) and seconds of wall time.
    seconds
        Wall time of the whole call, with DVC's own.
    """

    stages: pd.DataFrame
    seconds: float

    def by_stage(self) -> pd.DataFrame:
        """Columns stage, runs and seconds (sum over items), the longest first."""
        summed = self.stages.groupby("stage", as_index=False).agg(
            runs=("seconds", "size"), seconds=("seconds", "sum")
        )
        summed["seconds"] = summed["seconds"].round(2)
        return summed.sort_values(["seconds", "stage"], ascending=[False, True], ignore_index=True)


def new_call() -> str:
    """A name that no other call has."""
    return uuid.uuid4().hex


def record(stage: str, item: str | None, seconds: float) -> None:
    """Write how long a stage took to data/times/STAGE@ITEM.json, in place of its last time.

    Parameters
    ----------
    seconds
        Wall time.
    """
    name = stage if item is None else f"{stage}@{item.replace('/', '+')}"
    content = {
        "call": os.environ.get(CALL, ""),
        "item": item or "",
        "seconds": round(seconds, 2),
        "stage": stage,
    }
    files.write_json(paths.TIMES / f"{name}.json", content)


def gather(call: str, seconds: float) -> Run:
    """Read the times of the stages that ran in a call; others have an older record or none.

    Parameters
    ----------
    call
        From :func:`new_call`.
    seconds
        Wall time of the call.
    """
    # Names that start with a dot are unfinished.
    records = [files.read_json(path) for path in sorted(paths.TIMES.glob("[!.]*.json"))]
    rows = [[one[column] for column in COLUMNS] for one in records if one["call"] == call]
    return Run(pd.DataFrame(rows, columns=COLUMNS), round(seconds, 2))


def write(run: Run, data: str, cores: int, *, is_complete: bool) -> None:
    """Write data/times.csv, and data/times.json if every stage ran.

    Parameters
    ----------
    data
        Title of the data set.
    cores
        Number of worker processes.
    is_complete
        Whether every stage of the pipeline ran, so that the times are those of a run from nothing.
    """
    files.write_csv(paths.LAST_TIMES, run.stages)
    if is_complete:
        by_stage = run.by_stage().to_dict("records")
        facts = {"cores": cores, "data": data, "stages": len(run.stages), "total": run.seconds}
        files.write_json(paths.COMPLETE_TIMES, {"by_stage": by_stage, "facts": facts})


def read_complete() -> tuple[pd.DataFrame, dict[str, Any]]:
    """Times of the last run in which every stage ran: `Run.by_stage`; cores, data, stages and total.

    Raises
    ------
    PlacecatError
        If there was none.
    """
    try:
        content = files.read_json(paths.COMPLETE_TIMES)
    except FileNotFoundError:
        raise PlacecatError(
            "no run in which every stage ran has been measured here: `placecat repro --force` is one"
        ) from None
    return pd.DataFrame(content["by_stage"], columns=["stage", "runs", "seconds"]), content["facts"]


def keep() -> None:
    """Copy the times of the last complete run to reports/times.csv and times.json, which git keeps."""
    by_stage, facts = read_complete()
    files.write_csv(paths.KEPT_TIMES, by_stage)
    files.write_json(paths.KEPT_TIMES_FACTS, facts)


def text(by_stage: pd.DataFrame, seconds: float) -> str:
    """Times as lines for the terminal, the longest stage first.

    Parameters
    ----------
    by_stage
        From :meth:`Run.by_stage`.
    seconds
        Wall time of the whole call.
    """
    if by_stage.empty:
        return f"Times: no stage had to run; {seconds:.1f} s."
    spent = float(by_stage["seconds"].sum())
    rows = [
        (stage, "" if runs == 1 else f"{runs} x", took)
        for stage, runs, took in by_stage[["stage", "runs", "seconds"]].itertuples(index=False)
    ]
    total = int(by_stage["runs"].sum())
    rows += [
        (f"{total} stage{'' if total == 1 else 's'}", "", spent),
        ("DVC and the rest", "", max(0.0, seconds - spent)),
        ("all", "", seconds),
    ]
    columns = [[name, runs, f"{took:.1f} s"] for name, runs, took in rows]
    wide = [max(map(len, column)) for column in zip(*columns, strict=True)]
    lines = [f"  {name:{wide[0]}}  {runs:>{wide[1]}}  {took:>{wide[2]}}" for name, runs, took in columns]
    return "\n".join(["Times of the stages that ran:", *lines])
