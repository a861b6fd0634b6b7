import multiprocessing
import shutil
import traceback
from pathlib import Path

import pytest

from placecat.errors import PlacecatError
from placecat.mlflow_log import store

pytestmark = [pytest.mark.slow, pytest.mark.xdist_group("mlflow")]


@pytest.fixture(autouse=True)
def folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    # Retries would take too long.
    monkeypatch.setenv("MLFLOW_HTTP_REQUEST_MAX_RETRIES", "0")
    return tmp_path


def uri():
    """Return an absolute URI, since MLflow caches connections by URI."""
    return f"sqlite:///{Path('mlflow.db').resolve()}"


def experiment(client):
    return store.experiment_id(client, uri(), "placecat/test", artifacts=Path("files"), description="Hi")


def test_a_run_with_more_than_one_batch(folder):
    client = store.connect(uri())
    params = {f"p{number}": str(number) for number in range(130)} | {"long": "x" * 7000}
    metrics = {f"m{number}": number / 7 for number in range(900)}
    (folder / "one.txt").write_text("1")
    parent = store.start_run(client, experiment(client), "parent")
    assert client.get_run(parent).info.status == "RUNNING"
    child = store.start_run(
        client,
        experiment(client),
        "child",
        params=params,
        metrics=metrics,
        tags={"a": "b"},
        files=[folder / "one.txt"],
        parent=parent,
        description="Read *me*.",
    )
    store.finish_run(client, child)
    store.finish_run(client, parent, status="FAILED")
    run = client.get_run(child)
    assert run.info.status == "FINISHED"
    assert run.data.params == params | {"long": "x" * 6000}
    assert run.data.metrics == metrics
    assert run.data.tags["mlflow.parentRunId"] == parent
    assert run.data.tags["mlflow.note.content"] == "Read *me*."
    assert [one.path for one in client.list_artifacts(child)] == ["one.txt"]
    assert client.get_run(parent).info.status == "FAILED"


def _log_one(number, start, failures):
    try:
        start.wait()
        client = store.connect(uri())
        run = store.start_run(client, experiment(client), f"run {number}", metrics={"number": number})
        store.finish_run(client, run)
    except BaseException:
        failures.put(traceback.format_exc())


def test_sixteen_processes_can_create_the_database_at_once():
    """Fork real processes, since importing MLflow in each would take 5 s.

    No database is open yet. A barrier makes all processes start at once.
    """
    import mlflow  # noqa: F401

    context = multiprocessing.get_context("fork")
    start, failures = context.Barrier(16), context.SimpleQueue()
    processes = [context.Process(target=_log_one, args=(number, start, failures)) for number in range(16)]
    for process in processes:
        process.start()
    for process in processes:
        process.join(120)
    assert failures.empty(), failures.get()
    assert [process.exitcode for process in processes] == [0] * 16
    client = store.connect(uri())
    runs = client.search_runs([experiment(client)])
    assert sorted(run.data.metrics["number"] for run in runs) == list(range(16))
    assert {run.info.status for run in runs} == {"FINISHED"}


@pytest.mark.parametrize(
    ("address", "says"),
    [
        ("sqlite:///broken.db", "file is not a database"),
        ("sqlite://", "does not name a file"),
        ("ftp://somewhere", "ftp"),
        ("http://me:secret@127.0.0.1:9", "127.0.0.1"),
    ],
)
def test_other_servers_are_reported_in_one_line(folder, address, says):
    (folder / "broken.db").write_text("This is not a database, despite its name." * 9)
    with pytest.raises(PlacecatError, match=says) as caught:
        store.connect(address)
    assert "\n" not in str(caught.value)
    assert "secret" not in str(caught.value)


def test_a_deleted_experiment_is_reported(folder):
    client = store.connect(uri())
    client.delete_experiment(experiment(client))
    with pytest.raises(PlacecatError, match="mlflow experiments restore"):
        experiment(client)


def test_the_server_comes_from_the_environment(monkeypatch):
    monkeypatch.delenv("MLFLOW_TRACKING_URI", raising=False)
    assert store.tracking_uri() == "sqlite:///mlflow.db"
    monkeypatch.setenv("MLFLOW_TRACKING_URI", "http://127.0.0.1:5000")
    assert store.tracking_uri() == "http://127.0.0.1:5000"


def test_names_are_accepted_by_mlflow():
    name = store.key("4-5-1, all cues", "Ori M/V + y-Pos", "", "Home 1")
    assert name == "4-5-1 all cues/Ori M/V and y-Pos/Home 1"


def test_a_moved_project_finds_its_files(tmp_path, monkeypatch):
    before, now = tmp_path / "before", tmp_path / "now"
    before.mkdir()
    for place in (before, now):
        if place == now:
            shutil.copytree(before, now)
        monkeypatch.chdir(place)
        client = store.connect(uri())
        # The database also contains paths of files in another project, which must not change.
        if place == before:
            other = client.create_experiment("other", artifact_location=(tmp_path / "files/x").as_uri())
        Path("one.txt").write_text(place.name)
        run = store.start_run(client, experiment(client), place.name, files=[Path("one.txt")])
        store.finish_run(client, run)
    assert [path.parents[3] for path in sorted(tmp_path.glob("*/files/*/artifacts/one.txt"))] == [
        before,
        now,
        now,
    ]
    shutil.rmtree(before)
    found = client.search_runs([experiment(client)], order_by=["attributes.start_time"])
    texts = [Path(client.download_artifacts(one.info.run_id, "one.txt")).read_text() for one in found]
    assert texts == ["before", "now"]
    assert client.get_experiment(other).artifact_location == (tmp_path / "files/x").as_uri()


def test_paths_in_a_database_outside_the_project_do_not_change(tmp_path, monkeypatch):
    (tmp_path / "mine").mkdir()
    client = store.connect(uri())
    places = []
    for artifacts in (Path("files"), Path("mine/files")):
        number = store.experiment_id(client, uri(), "placecat/test", artifacts=artifacts, description="")
        places.append(client.get_experiment(number).artifact_location)
    assert places == [(tmp_path / "files").as_uri()] * 2


@pytest.mark.parametrize(
    ("address", "message"),
    [
        ("http://[::1", "Invalid IPv6"),
        ("nonsense", "MLflow at nonsense: "),
        ("foo://x", "MLflow at foo://x: "),
        ("sqlite://", "does not name a file"),
        ("sqlite:////proc/x/y.db", "MLflow at sqlite:////proc/x/y.db: "),
        (
            "mssql+pyodbc://me:secret@host/db",
            r"me:\*\*\*@host/db: the database driver is missing \(pyodbc is not",
        ),
    ],
)
def test_an_invalid_address_and_a_missing_driver_are_reported(address, message):
    with pytest.raises(PlacecatError, match=message) as caught:
        store.connect(address)
    assert "\n" not in str(caught.value)
    assert "secret" not in str(caught.value)
