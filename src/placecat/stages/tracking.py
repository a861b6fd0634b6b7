"""Stage `tracking`: log tables, figures and findings to MLflow; table rows become nested runs."""

import json
from collections.abc import Mapping
from functools import cache
from pathlib import Path
from typing import Any

from placecat import files, paths, settings
from placecat.mlflow_log.content import figures_run, findings_run, table_run
from placecat.mlflow_log.store import queued_experiment, queued_in, tracking_uri
from placecat.mlflow_log.tables import ARTIFACTS, DESCRIPTION, TableRun, log_tables
from placecat.provenance.made import Made, made
from placecat.results.collect import read_results
from placecat.runs.lockfile import data_version, git_commit
from placecat.stages import run
from placecat.thesis.records import trials_of
from placecat.thesis.tables import folder_of, read


def main() -> None:
    """Log the tables to MLFLOW_TRACKING_URI, or to mlflow.db in the project folder."""
    params = settings.load()
    results, trials = read_results(params), trials_of(params)

    @cache
    def how(result: str) -> Made:
        return made(result, params, trials)

    by_split: dict[str, list[TableRun]] = {"": []}
    for table, cells, of_table in read(params):
        written = [folder_of(table) / f"{table['name']}.{ending}" for ending in ("csv", "md", "tex")]
        shown = settings.flatten(_settings(table, params))
        logged = table_run(table, cells, results, of_table, shown, written, how)
        by_split.setdefault(table.get("split", ""), []).append(logged)
    by_split[""] += [figures_run(paths.FIGURES), findings_run(paths.FINDINGS, paths.COMPARISONS)]
    digests: dict[str, str] = {}
    for split, runs in by_split.items():
        dataset = settings.get(params, f"splits.{split}.dataset" if split else "dataset")
        digests |= log_tables(
            runs,
            uri=tracking_uri(),
            experiment=f"placecat/{dataset['name']}",
            description=DESCRIPTION.format(title=dataset["title"]),
            data=dataset["title"],
            data_version=data_version("site_sequences" if split else "sequences"),
            commit=git_commit(),
            artifacts=(queued_in() or Path()) / ARTIFACTS,
            dvc_experiment=queued_experiment(),
        )
    files.write_json(paths.TRACKING, digests)


def _settings(table: Mapping[str, Any], params: Mapping[str, Any]) -> dict[str, Any]:
    """Return the settings that affect a table; changes to other settings do not supersede it."""
    shown: dict[str, Any] = {"protocol": params["protocol"]}
    if "trial" in table:
        return shown | {
            "trial": table["trial"],
            "homes": table["homes"],
            "axes": json.dumps(table["axes"], sort_keys=True),
        }
    results = [row["result"] for row in table.get("rows", [])] or [table["result"]]
    shown["probabilities"] = params["probabilities"]
    names = {part for result in results for part in result.split("/")}
    for kind in ("systems", "splits"):
        shown[kind] = {key: value for key, value in params[kind].items() if key in names}
    names |= {cue for system in shown["systems"].values() for cue in system["cues"]}
    for split in shown["splits"].values():
        names |= {cue for cues in split["systems"].values() for cue in cues}
    for kind in ("cues", "filters"):
        shown[kind] = {key: value for key, value in params[kind].items() if key in names}
    if "toy" in names:
        shown["toy"] = params["toy"]
    if {"hmm", "smoothing"} & names:
        shown["smoothing"] = params["smoothing"]
    return shown


if __name__ == "__main__":
    run(main)
