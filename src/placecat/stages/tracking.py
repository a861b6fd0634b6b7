"""Stage `tracking`: each table as a run in MLflow."""

import os
import re
import subprocess
from pathlib import Path
from typing import Any

import pandas as pd
import yaml

from placecat import files, paths, settings
from placecat.reporting.tracking import TableRun, flatten, log_tables
from placecat.stages import run


def main() -> None:
    """Log the tables to MLFLOW_TRACKING_URI, or to mlflow.db in the project's folder."""
    params = settings.load()
    dataset = settings.get(params, "dataset")
    runs = [_table_run(name, table, params) for name, table in settings.get(params, "tables").items()]
    digests = log_tables(
        runs,
        uri=os.environ.get("MLFLOW_TRACKING_URI") or "sqlite:///mlflow.db",
        experiment=f"placecat/{dataset['name']}",
        data=dataset["title"],
        data_version=_data_version(),
        commit=_git_commit(),
        artifacts=Path("mlartifacts"),
    )
    files.write_json(paths.TRACKING, digests)


def _table_run(name: str, table: dict[str, Any], params: dict[str, Any]) -> TableRun:
    # Only the settings of what the table shows, so that a change elsewhere does not supersede it.
    used = {row["result"] for row in table.get("rows", [])} | (
        {table["result"]} if "result" in table else set()
    )
    shown: dict[str, Any] = {"protocol": params["protocol"]}
    names = {result.split("/")[1] for result in used}
    systems = {key: value for key, value in params["systems"].items() if key in names}
    cues = names | {cue for system in systems.values() for cue in system["cues"]}
    shown["systems"] = systems
    shown["cues"] = {key: value for key, value in params["cues"].items() if key in cues}
    if any(result.split("/")[0] in ("hmm", "smoothing") for result in used):
        shown["smoothing"] = params["smoothing"]
    return TableRun(
        name=name,
        title=f"Table {table['number']}: {table['title']}",
        cells=pd.read_csv(paths.TABLES / f"{name}.csv", dtype={"group": str}).fillna(
            {"group": "", "note": ""}
        ),
        settings=flatten(shown),
        files=[paths.TABLES / f"{name}.csv", paths.TABLES / f"{name}.md"],
    )


def _data_version() -> str:
    """DVC's checksum of the listed sequences, which have the checksum of every source file."""
    lock = yaml.safe_load(Path("dvc.lock").read_text(encoding="utf-8"))
    outs = lock["stages"]["sequences"]["outs"]
    return str(outs[0]["md5"])


def _git_commit() -> str:
    result = subprocess.run(["git", "rev-parse", "HEAD"], capture_output=True, text=True, check=False)
    commit = result.stdout.strip()
    return commit if re.fullmatch(r"[0-9a-f]{40,64}", commit) else ""


if __name__ == "__main__":
    run(main)
