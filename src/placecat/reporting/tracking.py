"""MLflow: an experiment a data set, a run a table; running again never duplicates one."""

import hashlib
import re
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pandas as pd

_DIGEST = "placecat.digest"
_TABLE = "placecat.table"
_CURRENT = "placecat.current"


@dataclass(frozen=True)
class TableRun:
    """What MLflow is to know of one table.

    Attributes
    ----------
    name
        E.g. "table_26".
    title
        For people.
    cells
        The filled table.
    settings
        Flat settings that the numbers depend on.
    files
        Files to keep with the run.
    """

    name: str
    title: str
    cells: pd.DataFrame
    settings: dict[str, str]
    files: list[Path]

    def digest(self, data_version: str) -> str:
        """Checksum of all that the run shows: the table's numbers, its settings, the version of the data."""
        content = [self.cells.to_csv(index=False), repr(sorted(self.settings.items())), data_version]
        return hashlib.sha256("\n".join(content).encode()).hexdigest()


def flatten(settings: Mapping[str, Any], prefix: str = "") -> dict[str, str]:
    """Nested settings as dotted names with text values, e.g. ``cues.gist.classifier.base.nu``: ``0.2``."""
    flat: dict[str, str] = {}
    for name, value in settings.items():
        if isinstance(value, Mapping):
            flat |= flatten(value, f"{prefix}{name}.")
        else:
            flat[f"{prefix}{name}"] = str(value)
    return flat


def metric_name(*parts: str) -> str:
    """A name that MLflow accepts: letters, digits, and ``_-. /`` only."""
    text = "/".join(part for part in parts if part).replace("+", "and")
    return re.sub(r"[^\w\-. /]", "", text)


def log_tables(
    runs: list[TableRun],
    *,
    uri: str,
    experiment: str,
    data: str,
    data_version: str,
    commit: str,
    artifacts: Path,
) -> dict[str, str]:
    """Log every table whose content is new; mark what it supersedes.

    Parameters
    ----------
    uri
        MLflow tracking URI.
    experiment
        Name of the experiment; made if it does not exist.
    data, data_version
        What the data set is called, and the checksum of its files.
    commit
        Git commit, or "" if there is none.
    artifacts
        Where a new experiment on a local database keeps its files.

    Returns
    -------
    dict
        For each table the digest of its content, which does not depend on time or on earlier runs.
    """
    from mlflow import MlflowClient
    from mlflow.entities import Metric, Param, RunTag
    from mlflow.utils.time import get_current_time_millis

    client = MlflowClient(uri)
    found = client.get_experiment_by_name(experiment)
    if found is None:
        location = artifacts.resolve().as_uri() if uri.startswith("sqlite:") else None
        experiment_id = client.create_experiment(experiment, artifact_location=location)
    else:
        experiment_id = found.experiment_id
    digests = {}
    for run in runs:
        digest = digests[run.name] = run.digest(data_version)
        earlier = client.search_runs(
            [experiment_id], f"tags.`{_TABLE}` = '{run.name}' and tags.`{_CURRENT}` = 'true'", max_results=100
        )
        complete = [one for one in earlier if one.info.status == "FINISHED"]
        if any(one.data.tags.get(_DIGEST) == digest for one in complete):
            continue
        tags = {
            _TABLE: run.name,
            _DIGEST: digest,
            _CURRENT: "true",
            "data": data,
            "data_version": data_version,
            "mlflow.source.git.commit": commit,
            "mlflow.note.content": f"{run.title}. Measured on {data}; percent, mean over places.",
        }
        created = client.create_run(experiment_id, run_name=run.name, tags=tags)
        now = get_current_time_millis()
        measured = run.cells[run.cells["measured"].notna()]
        metrics = [
            Metric(metric_name(group, row, column), float(value), now, 0)
            for group, row, column, value in measured[["group", "row", "column", "measured"]].itertuples(
                index=False
            )
        ]
        params = [Param(name, value[:6000]) for name, value in sorted(run.settings.items())]
        for start in range(0, len(metrics), 1000):
            client.log_batch(created.info.run_id, metrics=metrics[start : start + 1000])
        for start in range(0, len(params), 100):
            client.log_batch(created.info.run_id, params=params[start : start + 100])
        for file in run.files:
            client.log_artifact(created.info.run_id, str(file))
        client.set_terminated(created.info.run_id)
        for one in earlier:
            client.log_batch(
                one.info.run_id,
                tags=[RunTag(_CURRENT, "false"), RunTag("placecat.superseded_by", created.info.run_id)],
            )
    return digests
