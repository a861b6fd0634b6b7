"""Log each table to MLflow as a run, with nested runs for its rows and without duplicates.

A run has these tags. ``placecat.kind`` is table, row, figures or findings. ``placecat.table`` is the name of
the table, and ``placecat.digest`` is the checksum of its contents. ``placecat.current`` is "true" for valid
runs, or the name of the queued DVC experiment that logged them. A run counts only if it is current and
FINISHED.

A table is written in four steps. First, the runs of the table and its rows are started. Next, ``current``
becomes "false" in the superseded runs. Finally, the runs of the rows are finished, and then the run of the
table. If the process is killed, its unfinished runs do not count, so no table counts twice. The next call
deletes these runs and writes the table again. Processes on one machine take turns. Several machines may write
at once; at the end, each keeps only the latest current run of a table.
"""

from __future__ import annotations

import hashlib
import platform
import tempfile
import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING

from placecat.mlflow_log import store
from placecat.mlflow_log.store import COMMIT

if TYPE_CHECKING:
    from mlflow import MlflowClient
    from mlflow.entities import Run

KIND, TABLE, DIGEST = "placecat.kind", "placecat.table", "placecat.digest"
CURRENT, SUPERSEDED_BY = "placecat.current", "placecat.superseded_by"
# Name of the training protocol, such as "5-5-1"; a table lists the protocols of all its rows.
PROTOCOL = "protocol"
# Name of the queued DVC experiment that logged a run. Such runs do not supersede runs of the project.
DVC_EXPERIMENT = "placecat.dvc_experiment"
# The machine that logs a run; other machines cannot tell whether an unfinished run is still being written.
MACHINE = "placecat.machine"
# Milliseconds after which an unfinished run counts as abandoned.
_TORSO = 24 * 3600 * 1000
# Change this to log all runs again when their contents change but their numbers do not.
_FORM = "4"
# Placeholder for the run id in a description.
RUN_ID = "{run_id}"
ARTIFACTS = Path("mlartifacts")
# Description of the experiment for a data set.
DESCRIPTION = (
    "Visual place categorization, measured on {title}. Every table of the thesis is a run, and every row of "
    "a table is a nested run. To see only current runs, filter by "
    '``tags.`placecat.current` = "true"``. '
    'To see sweeps over settings, filter by ``tags.`placecat.kind` = "sweep"``.'
)


@dataclass(frozen=True)
class RowRun:
    """The contents of one row's MLflow run, with a readable name such as "Table 26: 5-5-1, all cues, Gist".

    `params` identify the row. `metrics` are its numbers: ``accuracy``, ``accuracy/home_1``, ... in percent,
    and the quality of its probabilities (:meth:`placecat.results.measured.Quality.averages`). `description`
    is Markdown. `files` writes the files of the row into a folder and returns their paths.
    """

    name: str
    params: Mapping[str, str]
    metrics: Mapping[str, float]
    description: str = ""
    files: Callable[[Path], Sequence[Path]] = lambda folder: ()


@dataclass(frozen=True)
class TableRun:
    """The contents of one table's MLflow run, with a name such as "table_26" and a title.

    `content` is everything that the table shows, as text. `params` are the settings that affect the numbers,
    by dotted name. `metrics` are in percent unless their name says otherwise. `description` is Markdown, in
    which `RUN_ID` is replaced by the run id. `rows` are nested runs, and `files` is as in a row. `kind`
    is "table", or "figures" or "findings" for the two runs that are not tables.
    """

    name: str
    title: str
    content: str
    params: Mapping[str, str]
    metrics: Mapping[str, float]
    description: str
    rows: Sequence[RowRun] = ()
    files: Callable[[Path], Sequence[Path]] = lambda folder: ()
    kind: str = "table"

    def digest(self, data_version: str) -> str:
        """Return a checksum of everything that the run shows: title, numbers, settings and data version."""
        content = [_FORM, self.title, self.content, repr(sorted(self.params.items())), data_version]
        return hashlib.sha256("\n".join(content).encode()).hexdigest()


def log_tables(
    runs: Sequence[TableRun],
    *,
    uri: str,
    experiment: str,
    description: str,
    data: str,
    data_version: str,
    commit: str,
    artifacts: Path,
    dvc_experiment: str = "",
) -> dict[str, str]:
    """Log every table whose contents are new, and mark the runs that it supersedes.

    Returns the digest of each table by name; digests do not depend on the time or on earlier runs. Raises
    PlacecatError if MLflow does not respond or rejects a request.

    Parameters
    ----------
    runs
        All tables of the experiment in display order.
    uri
        MLflow tracking URI.
    experiment, description, artifacts
        Name of the experiment, which is created if missing; its description in Markdown; and the folder for
        the files of a new experiment, unless a server stores them.
    data, data_version, commit
        Title of the data set, the checksum of its files, and the git commit, "" if there is none.
    dvc_experiment
        Name of the queued DVC experiment that calls this function, or ""; only earlier runs of the same
        experiment are superseded.
    """
    client = store.connect(uri)
    with store.alone(uri):
        number = store.experiment_id(client, uri, experiment, artifacts=artifacts, description=description)
        common = {
            "data": data,
            "data_version": data_version,
            "mlflow.source.name": "placecat.stages.tracking",
        }
        if commit:
            common[COMMIT] = commit
        if dvc_experiment:
            common[DVC_EXPERIMENT] = dvc_experiment
            runs = [replace(run, title=f"{run.title} ({dvc_experiment})") for run in runs]
        digests = {run.name: run.digest(data_version) for run in runs}
        # Log the last table first, since the user interface shows the latest run at the top.
        _log_new(client, number, runs[::-1], digests, common)
        _settle(client, number, dvc_experiment)
        return digests


def _log_new(
    client: MlflowClient,
    experiment_id: str,
    runs: Sequence[TableRun],
    digests: Mapping[str, str],
    common: Mapping[str, str],
) -> None:
    known: dict[str, list[Run]] = {}
    scope = common.get(DVC_EXPERIMENT, "")
    # Find the runs that have not been superseded, whether they are complete or not.
    for one in search(client, experiment_id, f"tags.`{DIGEST}` LIKE '%'"):
        if SUPERSEDED_BY not in one.data.tags and one.data.tags.get(DVC_EXPERIMENT, "") == scope:
            known.setdefault(one.data.tags.get(TABLE, ""), []).append(one)
    for run in runs:
        digest = digests[run.name]
        earlier = known.get(run.name, [])
        complete = [one for one in earlier if one.info.status == "FINISHED"]
        same = [one for one in complete if one.data.tags.get(DIGEST) == digest]
        for torso in earlier:
            if torso not in complete and _is_torso(torso):
                delete(client, experiment_id, torso.info.run_id)
        new = [] if same else _log(client, experiment_id, run, digest, common)
        chosen = same[0].info.run_id if same else new[-1]
        old = [one.info.run_id for one in complete if one.info.run_id != chosen]
        _make_current(client, experiment_id, new, old, chosen)
    for name in known.keys() - digests.keys():
        # This table no longer exists.
        for one in known[name]:
            _supersede(client, experiment_id, one.info.run_id, "nothing")


def _is_torso(run: Run) -> bool:
    """Return whether an unfinished run is abandoned: on this machine, always, since we hold the lock."""
    is_own = run.data.tags.get(MACHINE, platform.node()) == platform.node()
    return is_own or run.info.start_time < time.time() * 1000 - _TORSO


def _settle(client: MlflowClient, experiment_id: str, scope: str) -> None:
    """Keep only the latest run of each table current, in case other machines have logged in the meantime."""
    current: dict[str, list[Run]] = {}
    condition = f"tags.`{DIGEST}` LIKE '%' and tags.`{CURRENT}` = '{scope or 'true'}'"
    for one in search(client, experiment_id, f"{condition} and attributes.status = 'FINISHED'"):
        current.setdefault(one.data.tags.get(TABLE, ""), []).append(one)
    for of_table in current.values():
        *others, latest = sorted(of_table, key=lambda one: (one.info.start_time, one.info.run_id))
        for one in others:
            _supersede(client, experiment_id, one.info.run_id, latest.info.run_id)
        if SUPERSEDED_BY in latest.data.tags:
            client.delete_tag(latest.info.run_id, SUPERSEDED_BY)


def _log(
    client: MlflowClient, experiment_id: str, run: TableRun, digest: str, common: Mapping[str, str]
) -> list[str]:
    """Log a table and its rows, but do not finish the runs; return their ids, with the table last."""
    tags = {**common, TABLE: run.name, CURRENT: common.get(DVC_EXPERIMENT, "true"), MACHINE: platform.node()}
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(temporary)
        run_id = store.start_run(
            client,
            experiment_id,
            run.title,
            params=run.params,
            metrics=run.metrics,
            tags={**tags, **_protocols(run.rows), KIND: run.kind, DIGEST: digest},
            files=run.files(folder),
        )
        store.set_tags(client, run_id, {store.DESCRIPTION: run.description.replace(RUN_ID, run_id)})
        rows = []
        # Log the last row first, since the user interface shows the latest run at the top.
        for number, row in reversed(list(enumerate(run.rows))):
            (own := folder / str(number)).mkdir()
            nested = store.start_run(
                client,
                experiment_id,
                row.name,
                parent=run_id,
                params=row.params,
                metrics=row.metrics,
                tags={**tags, **_protocols([row]), KIND: "row"},
                description=row.description,
                files=row.files(own),
            )
            rows.append(nested)
    return [*rows, run_id]


def _protocols(rows: Sequence[RowRun]) -> dict[str, str]:
    """Return a tag that lists the protocols of the rows, for filtering runs."""
    names = dict.fromkeys(row.params["protocol"] for row in rows if "protocol" in row.params)
    return {PROTOCOL: ", ".join(names)} if names else {}


def _make_current(
    client: MlflowClient, experiment_id: str, new: Sequence[str], old: Sequence[str], chosen: str
) -> None:
    # Because of the lock, other processes see either all of these changes or none.
    with store.writing(client):
        for one in old:
            _supersede(client, experiment_id, one, chosen)
        for one in new:
            store.finish_run(client, one)


def _supersede(client: MlflowClient, experiment_id: str, run_id: str, by: str) -> None:
    # Mark the run of the table last, so that an interrupted call is repeated.
    for each in [*_nested(client, experiment_id, run_id), run_id]:
        store.set_tags(client, each, {CURRENT: "false", SUPERSEDED_BY: by})


def delete(client: MlflowClient, experiment_id: str, run_id: str) -> None:
    """Delete a run and its nested runs, as the user interface does; `mlflow gc` removes them for good."""
    with store.writing(client):
        for each in [*_nested(client, experiment_id, run_id), run_id]:
            client.delete_run(each)


def _nested(client: MlflowClient, experiment_id: str, run_id: str) -> list[str]:
    found = search(client, experiment_id, f"tags.`{store.PARENT}` = '{run_id}'")
    return [str(one.info.run_id) for one in found]


def search(client: MlflowClient, experiment_id: str, condition: str) -> list[Run]:
    """Find all runs of an experiment that match a filter in MLflow's syntax."""
    found: list[Run] = []
    token = None
    with store.writing(client):
        while True:
            page = client.search_runs([experiment_id], condition, max_results=1000, page_token=token)
            found += page
            token = page.token
            if not token:
                return found
