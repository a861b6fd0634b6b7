"""Stage `tracking`: each table as a run in MLflow."""

import json
import os
import re
import subprocess
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from placecat import files, paths, settings
from placecat.lockfile import data_version
from placecat.reporting.tables import label, tables_of
from placecat.reporting.tracking import TableRun, flatten, log_tables
from placecat.stages import run


def main() -> None:
    """Log the tables to MLFLOW_TRACKING_URI, or to mlflow.db in the project's folder."""
    params = settings.load()
    dataset = settings.get(params, "dataset")
    digests = log_tables(
        [_table_run(name, table, params) for name, table in tables_of(params).items()],
        uri=os.environ.get("MLFLOW_TRACKING_URI") or "sqlite:///mlflow.db",
        experiment=f"placecat/{dataset['name']}",
        data=dataset["title"],
        data_version=data_version(),
        commit=_git_commit(),
        artifacts=Path("mlartifacts"),
    )
    files.write_json(paths.TRACKING, digests)


def _table_run(name: str, table: Mapping[str, Any], params: Mapping[str, Any]) -> TableRun:
    return TableRun(
        name=name,
        title=f"{label(table)}: {table['title']}",
        cells=files.read_table(paths.TABLES / f"{name}.csv", ["group", "row", "column", "note"]),
        settings=flatten(_settings(table, params)),
        files=[paths.TABLES / f"{name}.{ending}" for ending in ("csv", "md", "tex")],
    )


def _settings(table: Mapping[str, Any], params: Mapping[str, Any]) -> dict[str, Any]:
    """Only the settings of what the table shows, so that a change elsewhere does not supersede it."""
    shown: dict[str, Any] = {"protocol": params["protocol"]}
    if "trial" in table:
        return shown | {
            "trial": table["trial"],
            "homes": table["homes"],
            "axes": json.dumps(table["axes"], sort_keys=True),
        }
    results = [row["result"] for row in table.get("rows", [])] or [table["result"]]
    names = {part for result in results for part in result.split("/")}
    for kind in ("systems", "splits"):
        shown[kind] = {key: value for key, value in params[kind].items() if key in names}
    names |= {cue for system in shown["systems"].values() for cue in system["cues"]}
    for split in shown["splits"].values():
        names |= {cue for cues in split["systems"].values() for cue in cues}
    for kind in ("cues", "filters"):
        shown[kind] = {key: value for key, value in params[kind].items() if key in names}
    if {"hmm", "smoothing"} & names:
        shown["smoothing"] = params["smoothing"]
    return shown


def _git_commit() -> str:
    result = subprocess.run(["git", "rev-parse", "HEAD"], capture_output=True, text=True, check=False)
    commit = result.stdout.strip()
    return commit if re.fullmatch(r"[0-9a-f]{40,64}", commit) else ""


if __name__ == "__main__":
    run(main)
