"""A real `mlflow server`, used as a user would, and its pages in a real browser."""

import os
import socket
import subprocess
import sys
import time
import urllib.request

import numpy as np
import pytest
from PIL import Image

import made_results
from browser import needs_chromium, open_page
from placecat import files
from placecat.mlflow_log import store
from placecat.mlflow_log.content import table_run
from placecat.mlflow_log.tables import log_tables
from placecat.provenance.made import made
from placecat.results.measured import MEASURES
from placecat.thesis.tables import dataset_of, fill_table, tables_of

pytestmark = pytest.mark.xdist_group("mlflow")


def free_port():
    with socket.socket() as one:
        one.bind(("127.0.0.1", 0))
        return one.getsockname()[1]


@pytest.fixture(scope="module")
def server(tmp_path_factory):
    """The address of a server that has its own database and file folder, and accepts files over HTTP."""
    folder, port = tmp_path_factory.mktemp("server"), free_port()
    address = f"http://127.0.0.1:{port}"
    # The job runner needs 8 more processes, and is only for language models.
    environment = {"MLFLOW_SERVER_ENABLE_JOB_EXECUTION": "false", "MLFLOW_DISABLE_TELEMETRY": "true"}
    command = [sys.executable, "-m", "mlflow", "server", "--host", "127.0.0.1", "--port", str(port)]
    command += ["--workers", "1", "--backend-store-uri", "sqlite:///server.db"]
    command += ["--artifacts-destination", str(folder / "files")]
    with (folder / "log").open("wb") as log:
        process = subprocess.Popen(
            command, cwd=folder, env=os.environ | environment, stdout=log, stderr=log, start_new_session=True
        )
    try:
        for _ in range(600):
            assert process.poll() is None, (folder / "log").read_text()
            try:
                with urllib.request.urlopen(f"{address}/health", timeout=5):
                    break
            except OSError:
                time.sleep(0.2)
        else:
            pytest.fail((folder / "log").read_text())
        yield address
    finally:
        # This also ends the worker of the server.
        process.terminate()
        process.wait(30)


@pytest.fixture(scope="module")
def logged(server, tmp_path_factory):
    """Log the first group of Table 26 twice; return its cells."""
    folder = tmp_path_factory.mktemp("logged")
    results, table = made_results.made(), tables_of(made_results.PARAMS, made_results.ROOT)["table_26"]
    dataset = dataset_of(table, made_results.PARAMS)
    cells = fill_table(table, results, made_results.published(), dataset, {})
    cells = cells[cells["group"] == cells["group"].iloc[0]]
    files.write_csv(folder / "table_26.csv", cells)

    def how(result):
        return made(result, made_results.PARAMS, {})

    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("MLFLOW_TRACKING_URI", server)
        digests = [
            log_tables(
                [table_run(table, cells, results, dataset, {}, [folder / "table_26.csv"], how)],
                uri=store.tracking_uri(),
                experiment="placecat/test",
                description="Tables",
                data="made homes",
                data_version="v1",
                commit="",
                artifacts=folder / "unused",
            )
            for _ in range(2)
        ]
    assert digests[0] == digests[1]
    assert not (folder / "unused").exists()
    return cells


def runs_of(server):
    client = store.connect(server)
    experiment = client.get_experiment_by_name("placecat/test")
    runs = client.search_runs([experiment.experiment_id])
    (table,) = [run for run in runs if run.data.tags["placecat.kind"] == "table"]
    return client, experiment, table, [run for run in runs if run is not table]


def test_a_server_stores_a_table_once_with_rows_and_files(server, logged, tmp_path):
    client, _, table, rows = runs_of(server)
    measured = logged[logged["measured"].notna()]
    assert len(rows) == len(logged[["group", "row"]].drop_duplicates())
    numbers = [value for name, value in table.data.metrics.items() if not name.startswith(tuple(MEASURES))]
    assert sorted(numbers) == sorted(measured["measured"])
    assert {run.info.status for run in [table, *rows]} == {"FINISHED"}
    assert {run.data.tags["placecat.current"] for run in [table, *rows]} == {"true"}
    names = {one.path for one in client.list_artifacts(table.info.run_id)}
    assert names == {"chart.png", "confusion.png", "counts.csv", "table_26.csv"}
    path = client.download_artifacts(table.info.run_id, "chart.png", str(tmp_path))
    with Image.open(path) as chart:
        assert chart.format == "PNG"
        assert chart.width > 1000
    assert {one.path for one in client.list_artifacts(rows[0].info.run_id)} == {
        "confusion.png",
        "counts.csv",
    }


@needs_chromium
def test_the_user_interface_shows_table_26_and_its_chart(server, logged, tmp_path):
    _, experiment, table, _ = runs_of(server)
    runs = f"{server}/#/experiments/{experiment.experiment_id}/runs"
    dom, _ = open_page(f"{runs}?workflowType=machine_learning", tmp_path, "--dump-dom", *WAITING)
    title = "Table 26: Single cues, their integration, and its smoothing"
    assert title in dom
    # The list links to the run.
    assert f"/runs/{table.info.run_id}" in dom
    shown = tmp_path / "shown.png"
    page = f"{runs}/{table.info.run_id}/artifacts/chart.png?workflowType=machine_learning"
    dom, _ = open_page(page, tmp_path, "--dump-dom", f"--screenshot={shown}", *WAITING)
    assert title in dom
    # The chart is on the screen: there are as many blue bars as averages.
    pixels = np.asarray(Image.open(shown).convert("RGB")).astype(int)
    blue = np.abs(pixels - CHART_BLUE).max(axis=2) < 6
    bars = (blue.sum(axis=1) > 60).astype(int)
    averages = logged[logged["column"] == "Average"]["measured"].notna().sum()
    assert (np.diff(bars, prepend=0) == 1).sum() == averages
    assert blue.sum() > 10_000


# The bars are 75% opaque on white.
CHART_BLUE = np.round(np.array([0x00, 0x72, 0xB2]) * 0.75 + 255 * 0.25).astype(int)
WAITING = ("--virtual-time-budget=15000", "--window-size=1500,1000")
