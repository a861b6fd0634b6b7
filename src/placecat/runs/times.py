"""Record how long stages take, for `placecat repro` and for git. No result depends on these times."""

import os
import uuid
from typing import Any

import pandas as pd

from placecat import files, paths
from placecat.errors import PlacecatError

# Environment variable that names the `placecat repro` call in which a stage runs.
CALL = "PLACECAT_CALL"
# `runs` is always 1. The column dates from when some stages ran once per home.
COLUMNS = ["stage", "runs", "seconds"]


def new_call() -> str:
    """Create a unique name for this call of `placecat repro`."""
    return uuid.uuid4().hex


def record(stage: str, seconds: float) -> None:
    """Write the wall time of a stage, in seconds, to data/times/STAGE.json; replace the previous time."""
    content = {"call": os.environ.get(CALL, ""), "runs": 1, "seconds": round(seconds, 2), "stage": stage}
    files.write_json(paths.TIMES / f"{stage}.json", content)


def gather(call: str) -> pd.DataFrame:
    """Read the wall times of all stages in a call, in seconds, longest first; the columns are `COLUMNS`."""
    # Files whose names begin with a dot are unfinished.
    records = [files.read_json(path) for path in paths.TIMES.glob("[!.]*.json")]
    table = pd.DataFrame([one for one in records if one["call"] == call], columns=COLUMNS)
    return table.sort_values(["seconds", "stage"], ascending=[False, True], ignore_index=True)


def write(by_stage: pd.DataFrame, seconds: float, data: str, cores: int, *, is_complete: bool) -> None:
    """Write data/times.csv, and data/times.json if every stage of the pipeline ran (`is_complete`).

    `by_stage` comes from :func:`gather`. `seconds` is the wall time of the call, including DVC; `data` is
    the title of the data set; `cores` is the number of worker processes.
    """
    files.write_csv(paths.LAST_TIMES, by_stage[["stage", "seconds"]])
    if is_complete:
        facts = {"cores": cores, "data": data, "stages": len(by_stage), "total": round(seconds, 2)}
        files.write_json(paths.COMPLETE_TIMES, {"by_stage": by_stage.to_dict("records"), "facts": facts})


def read_complete() -> tuple[pd.DataFrame, dict[str, Any]]:
    """Return the times of the last full run, as in :func:`gather`, and facts about it.

    Raises PlacecatError if there has been no full run.
    """
    try:
        content = files.read_json(paths.COMPLETE_TIMES)
    except FileNotFoundError:
        raise PlacecatError("no complete run has been measured here: run `placecat repro --force`") from None
    return pd.DataFrame(content["by_stage"], columns=COLUMNS), content["facts"]


def known() -> dict[str, float]:
    """Return how many seconds each stage took in the last full run here or, failing that, the one in git."""
    try:
        by_stage, _ = read_complete()
    except PlacecatError:
        if not paths.KEPT_TIMES.is_file():
            return {}
        by_stage = files.read_table(paths.KEPT_TIMES, ["stage"])
    return dict(zip(by_stage["stage"], by_stage["seconds"].astype(float), strict=True))


def keep() -> None:
    """Copy the times of the last full run to reports/times.csv and times.json, which are in git."""
    by_stage, facts = read_complete()
    files.write_csv(paths.KEPT_TIMES, by_stage)
    files.write_json(paths.KEPT_TIMES_FACTS, facts)


def text(by_stage: pd.DataFrame, seconds: float) -> str:
    """Format the times for the terminal, longest stage first; `seconds` is the wall time of the call."""
    if by_stage.empty:
        return f"Times: no stage had to run; {seconds:.1f} s."
    spent, total = float(by_stage["seconds"].sum()), len(by_stage)
    rows = {
        **dict(zip(by_stage["stage"], by_stage["seconds"], strict=True)),
        f"{total} stage{'' if total == 1 else 's'}": spent,
        "DVC and the rest": max(0.0, seconds - spent),
        "all": seconds,
    }
    took = [f"{value:.1f} s" for value in rows.values()]
    name_width, time_width = max(map(len, rows)), max(map(len, took))
    lines = [
        f"  {name:{name_width}}    {value:>{time_width}}" for name, value in zip(rows, took, strict=True)
    ]
    return "\n".join(["Times of the stages that ran:", *lines])
