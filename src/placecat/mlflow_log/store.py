"""Write to MLflow, either to a tracking server or to a SQLite database that many processes share."""

from __future__ import annotations

import hashlib
import logging
import os
import re
import shutil
import sqlite3
import tempfile
from collections.abc import Iterator, Mapping, Sequence
from contextlib import closing, contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any
from urllib.parse import urlparse
from urllib.request import url2pathname

from placecat.errors import PlacecatError

# Functions import MLflow only when needed, since the import takes 5 s.
if TYPE_CHECKING:
    from mlflow import MlflowClient

# Tags that the MLflow user interface recognizes.
DESCRIPTION = "mlflow.note.content"
COMMIT = "mlflow.source.git.commit"
PARENT = "mlflow.parentRunId"
_EXPERIMENT_KIND = {"mlflow.experimentKind": "custom_model_development"}

# The folder where DVC makes temporary copies of the project.
_QUEUED = (".dvc", "tmp", "exps")

# Limits of MLflow.
_MOST_METRICS, _MOST_PARAMS, _LONGEST_PARAM, _LONGEST_KEY = 800, 100, 6000, 250


def queued_in() -> Path | None:
    """Return the project folder if the current folder is DVC's temporary copy for a queued experiment."""
    here = Path.cwd()
    copies = [folder for folder in here.parents if folder.parts[-3:] == _QUEUED]
    return copies[-1].parents[2] if copies else None


def queued_experiment() -> str:
    """Return the name of the queued DVC experiment that runs this process, or ""."""
    return os.environ.get("DVC_EXP_NAME", "queued") if queued_in() else ""


def tracking_uri() -> str:
    """Return MLFLOW_TRACKING_URI from the environment, or else the URI of mlflow.db in the project."""
    project = queued_in()
    own = "sqlite:///mlflow.db" if project is None else f"sqlite:///{project / 'mlflow.db'}"
    return os.environ.get("MLFLOW_TRACKING_URI") or own


def connect(uri: str) -> MlflowClient:
    """Connect to a tracking server or to a database, which is created if missing.

    Examples of `uri` are ``http://127.0.0.1:5000`` and ``sqlite:///mlflow.db`` (relative to the current
    folder). If several processes connect at once, one creates the database and the others wait. Raises
    PlacecatError if `uri` is not an address, if no compatible MLflow responds there, or if the database
    driver is not installed.
    """
    os.environ.setdefault("MLFLOW_DISABLE_TELEMETRY", "true")
    # Otherwise, MLflow prints a line per run.
    os.environ.setdefault("MLFLOW_SUPPRESS_PRINTING_URL_TO_STDOUT", "true")
    # By default, MLflow retries for minutes before it reports that no server is responding.
    os.environ.setdefault("MLFLOW_HTTP_REQUEST_MAX_RETRIES", "3")
    from mlflow import MlflowClient

    # MLflow would log the 50 migrations of a new database.
    for talkative in ("mlflow.store.db.utils", "alembic"):
        logging.getLogger(talkative).setLevel(logging.WARNING)
    try:
        with _told_plainly(uri), alone(uri), _quick_if_new(uri):
            client = MlflowClient(uri)
            client.search_experiments(max_results=1)
    except PlacecatError:
        raise
    except ImportError as error:
        driver = f"{error.name} is not installed" if error.name else str(error)
        raise PlacecatError(
            f"MLflow at {_shown(uri)}: the database driver is missing ({driver}): install it with pip, or "
            "set MLFLOW_TRACKING_URI to another database, such as sqlite:///mlflow.db"
        ) from None
    except (OSError, ValueError) as error:
        raise PlacecatError(
            f"MLflow at {_shown(uri)}: {error}: set MLFLOW_TRACKING_URI to an address such as "
            "http://127.0.0.1:5000 or sqlite:///mlflow.db"
        ) from None
    return client


def experiment_id(client: MlflowClient, uri: str, name: str, *, artifacts: Path, description: str) -> str:
    """Return the id of an experiment, which is created if missing.

    Several processes may call this at once. `artifacts` is the folder for the files of a new experiment,
    unless a server stores them. If the project was moved or copied with its database, the database is
    updated, so that MLflow finds the files of earlier runs. `description` (Markdown) replaces any earlier
    description. Raises PlacecatError if the experiment was deleted but not purged, since MLflow still
    reserves its name.
    """
    from mlflow.exceptions import MlflowException

    server = re.match(r"https?:|databricks|uc:", uri) is not None
    location = None if server else artifacts.resolve().as_uri()
    with writing(client):
        found = client.get_experiment_by_name(name)
        if found is None:
            try:
                made = client.create_experiment(
                    name, artifact_location=location, tags={DESCRIPTION: description, **_EXPERIMENT_KIND}
                )
                return str(made)
            except MlflowException:
                # A server cannot be locked: either another process got there first, or this is a real error.
                found = client.get_experiment_by_name(name)
                if found is None:
                    raise
        if found.lifecycle_stage != "active":
            raise PlacecatError(
                f"the MLflow experiment {name!r} at {_shown(uri)} was deleted: restore it with "
                f"`mlflow experiments restore -x {found.experiment_id}`, or purge it with `mlflow gc`"
            )
        if location is not None:
            _follow(uri, str(found.artifact_location), artifacts.resolve())
        if found.tags.get(DESCRIPTION) != description:
            client.set_experiment_tag(found.experiment_id, DESCRIPTION, description)
    return str(found.experiment_id)


def _follow(uri: str, before: str, artifacts: Path) -> None:
    """Update the paths in the project's database after the project folder has been moved.

    MLflow stores absolute paths and has no command to change them. A database outside the folder is left
    alone, since several projects may share it.
    """
    from sqlalchemy.engine import make_url

    database, now = Path(str(make_url(uri).database)).resolve(), artifacts.as_uri()
    if before == now or not before.startswith("file:") or database.parent != artifacts.parent:
        return
    with closing(sqlite3.connect(database)) as connection, connection:
        for table, column in (("experiments", "artifact_location"), ("runs", "artifact_uri")):
            connection.execute(
                f"UPDATE {table} SET {column} = ? || substr({column}, ?) WHERE {column} = ? "
                f"OR substr({column}, 1, ?) = ?",
                (now, len(before) + 1, before, len(before) + 1, f"{before}/"),
            )


def start_run(
    client: MlflowClient,
    experiment_id: str,
    name: str,
    *,
    parent: str | None = None,
    description: str = "",
    params: Mapping[str, str] = {},
    metrics: Mapping[str, float] = {},
    tags: Mapping[str, str] = {},
    files: Sequence[Path] = (),
) -> str:
    """Start a run and return its id; the run is RUNNING until `finish_run`.

    `parent` is the id of the enclosing run, and `description` is Markdown. `files` are copied and keep their
    names. Values of `params` are truncated to 6000 characters, since MLflow rejects longer ones.
    """
    from mlflow.entities import Metric, Param
    from mlflow.utils.time import get_current_time_millis

    own = {PARENT: parent, DESCRIPTION: description}
    all_tags = {**tags, **{name: text for name, text in own.items() if text}}
    now = get_current_time_millis()
    numbers = [Metric(name, float(value), now, 0) for name, value in metrics.items()]
    texts = [Param(name, str(value)[:_LONGEST_PARAM]) for name, value in params.items()]
    with writing(client):
        info = client.create_run(experiment_id, run_name=name, tags=all_tags).info
        while numbers or texts:
            client.log_batch(info.run_id, numbers[:_MOST_METRICS], texts[:_MOST_PARAMS])
            del numbers[:_MOST_METRICS], texts[:_MOST_PARAMS]
    _store(client, str(info.run_id), str(info.artifact_uri), files)
    return str(info.run_id)


def finish_run(client: MlflowClient, run_id: str, *, status: str = "FINISHED") -> None:
    """End a run with the status FINISHED, FAILED or KILLED."""
    with writing(client):
        client.set_terminated(run_id, status)


def key(*parts: str) -> str:
    """Return a metric or parameter name that MLflow accepts: a path of letters, digits and ``_-. /``.

    The path is at most 250 characters long, and no part of it is empty or just dots.
    """
    text = "/".join(part for part in parts if part).replace("+", "and")
    allowed = re.sub(r"[^\w\-. /]", "", text).split("/")
    return "/".join(part for part in allowed if part.strip(". "))[:_LONGEST_KEY].rstrip("/")


@contextmanager
def writing(client: MlflowClient) -> Iterator[None]:
    """Lock MLflow with :func:`alone` during a block, and turn its errors into a PlacecatError.

    Every function in this module that writes uses this.
    """
    with _told_plainly(client.tracking_uri), alone(client.tracking_uri):
        yield


@contextmanager
def alone(uri: str) -> Iterator[None]:
    """Lock a SQLite database or a server during a block; blocks may be nested.

    A server is locked only for this user's processes on this machine.
    """
    from filelock import FileLock

    database, user = _database(uri), os.getuid() if hasattr(os, "getuid") else ""
    if database is None:
        name = f"placecat-{user}-{hashlib.sha256(uri.encode()).hexdigest()[:16]}.lock"
        path = Path(tempfile.gettempdir()) / name
    else:
        path = database.with_name(f"{database.name}.lock")
        path.parent.mkdir(parents=True, exist_ok=True)
    # There is one object per path, so that a process may acquire the lock twice.
    with FileLock(path, is_singleton=True):
        yield


def set_tags(client: MlflowClient, run_id: str, tags: Mapping[str, str]) -> None:
    """Set several tags of a run at once: either all of them are set, or none."""
    from mlflow.entities import RunTag

    with writing(client):
        client.log_batch(run_id, tags=[RunTag(name, value) for name, value in tags.items()])


def _store(client: MlflowClient, run_id: str, place: str, paths: Sequence[Path]) -> None:
    """Copy files to a run, bypassing MLflow's slower client if the run folder is on this machine."""
    parts = urlparse(place)
    if parts.scheme != "file":
        with _told_plainly(client.tracking_uri):
            for path in paths:
                client.log_artifact(run_id, str(path))
        return
    folder = Path(url2pathname(parts.path))
    folder.mkdir(parents=True, exist_ok=True)
    for path in paths:
        shutil.copyfile(path, folder / path.name)


@contextmanager
def _quick_if_new(uri: str) -> Iterator[None]:
    """Do not wait for the disk inside a block if the SQLite database is new.

    A new database has nothing to lose: after a power failure, it can be deleted and created again.
    """
    path = _database(uri)
    if path is None or path.exists():
        yield
        return
    from sqlalchemy import event
    from sqlalchemy.engine import Engine

    def opened(connection: Any, _: object) -> None:
        connection.execute("PRAGMA synchronous = OFF")

    event.listen(Engine, "connect", opened)
    try:
        yield
    finally:
        event.remove(Engine, "connect", opened)


def _database(uri: str) -> Path | None:
    """Return the file of a SQLite database, or None for other URIs."""
    if not uri.startswith("sqlite"):
        return None
    from sqlalchemy.engine import make_url

    database = make_url(uri).database
    if not database or database == ":memory:":
        raise PlacecatError(
            f"the MLflow tracking URI {uri!r} does not name a file: use one such as sqlite:///mlflow.db"
        )
    return Path(database).resolve()


@contextmanager
def _told_plainly(uri: str) -> Iterator[None]:
    """Turn errors from MLflow, its database or its server into a one-line PlacecatError."""
    from mlflow.exceptions import MlflowException
    from requests.exceptions import RequestException
    from sqlalchemy.exc import SQLAlchemyError

    try:
        yield
    except (MlflowException, RequestException, SQLAlchemyError) as error:
        lines = str(error).strip().splitlines() or [type(error).__name__]
        raise PlacecatError(
            _shown(f"MLflow at {uri}: {lines[0]} (MLFLOW_TRACKING_URI sets its address)")
        ) from error


def _shown(text: str) -> str:
    """Hide the passwords in any URIs that a message contains."""
    return re.sub(r"(://[^/:@\s]*):[^/@\s]*@", r"\1:***@", text)
