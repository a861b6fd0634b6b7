"""Writing to MLflow: any tracking server, or a SQLite database that many processes share."""

from __future__ import annotations

import hashlib
import logging
import os
import re
import shutil
import sqlite3
import tempfile
from collections.abc import Iterator, Mapping, Sequence
from contextlib import closing, contextmanager, nullcontext
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypedDict, Unpack
from urllib.parse import urlparse
from urllib.request import url2pathname

from placecat.errors import PlacecatError

# Functions import MLflow when they need it: that takes 5 s.
if TYPE_CHECKING:
    from contextlib import AbstractContextManager

    from mlflow import MlflowClient

# Tags that the user interface knows.
DESCRIPTION = "mlflow.note.content"
COMMIT = "mlflow.source.git.commit"
PARENT = "mlflow.parentRunId"
_EXPERIMENT_KIND = {"mlflow.experimentKind": "custom_model_development"}

# DVC makes its temporary copies here.
_QUEUED = (".dvc", "tmp", "exps")

# Limits of MLflow.
_MOST_METRICS, _MOST_PARAMS, _MOST_TAGS = 800, 100, 100
_LONGEST_PARAM = 6000
_LONGEST_KEY = 250


def queued_in() -> Path | None:
    """The project's folder, if this folder is DVC's temporary copy for a queued experiment."""
    here = Path.cwd()
    copies = [folder for folder in here.parents if folder.parts[-3:] == _QUEUED]
    return copies[-1].parents[2] if copies else None


def queued_experiment() -> str:
    """Name of the queued DVC experiment that runs this, "" if none does."""
    return os.environ.get("DVC_EXP_NAME", "queued") if queued_in() else ""


def tracking_uri() -> str:
    """The tracking server in MLFLOW_TRACKING_URI (environment), or mlflow.db in the project's folder."""
    project = queued_in()
    own = "sqlite:///mlflow.db" if project is None else f"sqlite:///{project / 'mlflow.db'}"
    return os.environ.get("MLFLOW_TRACKING_URI") or own


def connect(uri: str) -> MlflowClient:
    """Connect to a tracking server, e.g. ``http://127.0.0.1:5000``, or a database, made if there is none.

    A database is e.g. ``sqlite:///mlflow.db`` (relative to this folder). If several processes connect at
    once, one makes it and the others wait. Raises PlacecatError if `uri` is not an address, if no compatible
    MLflow answers there, or if the driver of the database is missing.
    """
    os.environ.setdefault("MLFLOW_DISABLE_TELEMETRY", "true")
    # MLflow would print a line per run.
    os.environ.setdefault("MLFLOW_SUPPRESS_PRINTING_URL_TO_STDOUT", "true")
    # By default MLflow tries for minutes before it reports that no server answers.
    os.environ.setdefault("MLFLOW_HTTP_REQUEST_MAX_RETRIES", "3")
    from mlflow import MlflowClient

    # A new database logs its 50 migrations.
    for talkative in ("mlflow.store.db.utils", "alembic"):
        logging.getLogger(talkative).setLevel(logging.WARNING)
    try:
        with _told_plainly(uri), _lock(uri), _quick_if_new(uri):
            client = MlflowClient(uri)
            client.search_experiments(max_results=1)
    except PlacecatError:
        raise
    except ImportError as error:
        driver = f"{error.name} is not installed" if error.name else str(error)
        raise PlacecatError(
            f"MLflow at {_shown(uri)}: the driver of this database, {driver}: install it with pip, or let "
            "MLFLOW_TRACKING_URI name another, e.g. sqlite:///mlflow.db"
        ) from None
    except (OSError, ValueError) as error:
        raise PlacecatError(
            f"MLflow at {_shown(uri)}: {error}: set MLFLOW_TRACKING_URI to an address such as "
            "http://127.0.0.1:5000 or sqlite:///mlflow.db"
        ) from None
    return client


def experiment_id(client: MlflowClient, uri: str, name: str, *, artifacts: Path, description: str) -> str:
    """Find an experiment by name, or make it; several processes may do so at once.

    `artifacts` is the folder for the files of a new experiment, unless a server stores them. After a project
    was moved or copied with its database, MLflow looks for the files of earlier runs in the new folder.
    `description` (Markdown) replaces an earlier one. Raises PlacecatError if the experiment was deleted but
    not purged, since MLflow then reserves its name.
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
                # A server cannot be locked: another process was quicker, or this is another error.
                found = client.get_experiment_by_name(name)
                if found is None:
                    raise
        if found.lifecycle_stage != "active":
            raise PlacecatError(
                f"the experiment {name!r} of MLflow at {_shown(uri)} was deleted: restore it with "
                f"`mlflow experiments restore -x {found.experiment_id}`, or purge it with `mlflow gc`"
            )
        if location is not None:
            _follow(uri, str(found.artifact_location), artifacts.resolve())
        if found.tags.get(DESCRIPTION) != description:
            client.set_experiment_tag(found.experiment_id, DESCRIPTION, description)
    return str(found.experiment_id)


def _follow(uri: str, before: str, artifacts: Path) -> None:
    """Update the paths in a database in the project's folder after the folder was moved.

    MLflow stores absolute paths and has no command to change them. A database elsewhere is left alone, since
    several projects may share it.
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


class Content(TypedDict, total=False):
    """Content of a run except its files, each part a mapping of names to values; every part is optional.

    Parameters are cut at 6000 characters, since MLflow refuses longer ones.
    """

    params: Mapping[str, str]
    metrics: Mapping[str, float]
    tags: Mapping[str, str]


def start_run(
    client: MlflowClient,
    experiment_id: str,
    name: str,
    *,
    parent: str | None = None,
    description: str = "",
    files: Sequence[Path] = (),
    **content: Unpack[Content],
) -> str:
    """Start a run with some :class:`Content` and return its id; its status is RUNNING until `finish_run`.

    `parent` is the id of the run to nest this one in; `description` is Markdown; `files` are copied under
    their names.
    """
    tags = dict(content.pop("tags", {}))
    if parent is not None:
        tags[PARENT] = parent
    if description:
        tags[DESCRIPTION] = description
    with writing(client):
        info = client.create_run(experiment_id, run_name=name, tags=tags).info
        log(client, str(info.run_id), **content)
    _store(client, str(info.run_id), str(info.artifact_uri), files)
    return str(info.run_id)


def finish_run(
    client: MlflowClient, run_id: str, *, status: str = "FINISHED", **content: Unpack[Content]
) -> None:
    """Log more (:class:`Content`) to a run, then end it with the status FINISHED, FAILED or KILLED."""
    log(client, run_id, **content)
    with writing(client):
        client.set_terminated(run_id, status)


def key(*parts: str) -> str:
    """A name of a metric or parameter that MLflow accepts: a path of letters, digits and ``_-. /``.

    The parts of the path are neither empty nor dots only, and it has at most 250 characters.
    """
    text = "/".join(part for part in parts if part).replace("+", "and")
    allowed = re.sub(r"[^\w\-. /]", "", text).split("/")
    return "/".join(part for part in allowed if part.strip(". "))[:_LONGEST_KEY].rstrip("/")


@contextmanager
def writing(client: MlflowClient) -> Iterator[None]:
    """Lock the database if it is SQLite: one process writes, others wait. May be nested.

    Every writing function of this module locks; a block around several calls keeps the lock between them.
    Raises PlacecatError for errors of MLflow or its database in the block.
    """
    with _told_plainly(client.tracking_uri), _lock(client.tracking_uri):
        yield


@contextmanager
def alone(uri: str) -> Iterator[None]:
    """Wait for other processes of this user on this machine that hold the same tracking server."""
    from filelock import FileLock

    user = os.getuid() if hasattr(os, "getuid") else ""
    name = f"placecat-{user}-{hashlib.sha256(uri.encode()).hexdigest()[:16]}.lock"
    with FileLock(Path(tempfile.gettempdir()) / name, is_singleton=True):
        yield


def log(client: MlflowClient, run_id: str, **content: Unpack[Content]) -> None:
    """Log more (:class:`Content`) to a run."""
    from mlflow.entities import Metric, Param, RunTag
    from mlflow.utils.time import get_current_time_millis

    now = get_current_time_millis()
    metrics = [Metric(name, float(value), now, 0) for name, value in content.get("metrics", {}).items()]
    params = [Param(name, str(value)[:_LONGEST_PARAM]) for name, value in content.get("params", {}).items()]
    tags = [RunTag(name, value) for name, value in content.get("tags", {}).items()]
    with writing(client):
        while metrics or params or tags:
            client.log_batch(run_id, metrics[:_MOST_METRICS], params[:_MOST_PARAMS], tags[:_MOST_TAGS])
            del metrics[:_MOST_METRICS], params[:_MOST_PARAMS], tags[:_MOST_TAGS]


def _store(client: MlflowClient, run_id: str, place: str, paths: Sequence[Path]) -> None:
    """Copy files to a run: directly if its folder is on this machine, since the client is slower."""
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
    """In the block, connections to a new SQLite database do not wait for the disk.

    A new database has nothing to lose: if the power fails, it is removed and written again.
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


def _lock(uri: str) -> AbstractContextManager[object]:
    """A lock that all processes with this SQLite database share; nothing for other URIs."""
    path = _database(uri)
    if path is None:
        return nullcontext()
    from filelock import FileLock

    path.parent.mkdir(parents=True, exist_ok=True)
    # One object per path, so that a thread may take the lock twice.
    return FileLock(path.with_name(f"{path.name}.lock"), is_singleton=True)


def _database(uri: str) -> Path | None:
    """The file of a SQLite database; None for other URIs."""
    if not uri.startswith("sqlite"):
        return None
    from sqlalchemy.engine import make_url

    database = make_url(uri).database
    if not database or database == ":memory:":
        raise PlacecatError(
            f"the MLflow tracking URI {uri!r} does not name a file: write e.g. sqlite:///mlflow.db"
        )
    return Path(database).resolve()


@contextmanager
def _told_plainly(uri: str) -> Iterator[None]:
    """Turn errors of MLflow, its database and its server into one clear message."""
    from mlflow.exceptions import MlflowException
    from requests.exceptions import RequestException
    from sqlalchemy.exc import SQLAlchemyError

    try:
        yield
    except (MlflowException, RequestException, SQLAlchemyError) as error:
        lines = str(error).strip().splitlines() or [type(error).__name__]
        raise PlacecatError(
            _shown(f"MLflow at {uri}: {lines[0]} (MLFLOW_TRACKING_URI says where MLflow is)")
        ) from error


def _shown(text: str) -> str:
    """A text without the passwords of its URIs."""
    return re.sub(r"(://[^/:@\s]*):[^/@\s]*@", r"\1:***@", text)
