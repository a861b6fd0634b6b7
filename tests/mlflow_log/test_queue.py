"""Queued DVC experiments run in copies of the project and log to the project's MLflow."""

import time
from pathlib import Path

import pytest

from placecat.mlflow_log import store
from project import run

LOG = """
from pathlib import Path

from placecat.mlflow_log import store
from placecat.mlflow_log.tables import ARTIFACTS, TableRun, log_tables

Path("table.csv").write_text(Path("params.yaml").read_text())
table = TableRun("table_05", "Table 5", "30.5", {"nu": Path("params.yaml").read_text()},
                 {"average": 30.5}, "", files=lambda folder: [Path("table.csv")])
log_tables([table], uri=store.tracking_uri(), experiment="placecat/test", description="", data="made",
           data_version="v1", commit="", artifacts=(store.queued_in() or Path()) / ARTIFACTS,
           dvc_experiment=store.queued_experiment())
"""
STAGE = """
stages:
  tracking:
    cmd: python log.py
    deps: [log.py]
    params: [nu]
    outs: [table.csv]
"""


def test_the_copy_for_a_queued_experiment_belongs_to_the_project(tmp_path, monkeypatch):
    monkeypatch.delenv("MLFLOW_TRACKING_URI", raising=False)
    monkeypatch.setenv("DVC_EXP_NAME", "nu-0.1")
    monkeypatch.chdir(tmp_path)
    assert store.queued_in() is None
    assert store.queued_experiment() == ""
    assert store.tracking_uri() == "sqlite:///mlflow.db"
    (copy := tmp_path / ".dvc/tmp/exps/tmp1234/project").mkdir(parents=True)
    monkeypatch.chdir(copy)
    assert store.queued_in() == tmp_path
    assert store.queued_experiment() == "nu-0.1"
    assert store.tracking_uri() == f"sqlite:///{tmp_path / 'mlflow.db'}"


@pytest.mark.slow
@pytest.mark.xdist_group("mlflow")
def test_a_queued_experiment_logs_to_the_project_and_supersedes_nothing(tmp_path, monkeypatch):
    for name, text in {"log.py": LOG, "dvc.yaml": STAGE, "params.yaml": "nu: 0.2\n"}.items():
        (tmp_path / name).write_text(text)
    (tmp_path / ".gitignore").write_text("/mlflow.db*\n/mlartifacts\n/table.csv\n")
    run(tmp_path, "git", "init", "-q")
    run(tmp_path, "dvc", "init", "-q")
    # Run what `dvc repro` would run, but in this process, which has already imported MLflow.
    monkeypatch.delenv("MLFLOW_TRACKING_URI", raising=False)
    monkeypatch.chdir(tmp_path)
    exec(LOG, {})
    run(tmp_path, "git", "add", "-A")
    run(tmp_path, "git", "-c", "user.name=a", "-c", "user.email=a@b", "commit", "-qm", "all")
    run(tmp_path, "dvc", "exp", "run", "--queue", "-n", "nu-01", "-S", "nu=0.1")
    run(tmp_path, "dvc", "queue", "start")
    # Wait for the file that DVC writes when an experiment ends, since each DVC command takes seconds.
    end = time.monotonic() + 200
    while not list((tmp_path / ".dvc/tmp/exps/celery/result").glob("celery-task-meta-*")):
        assert time.monotonic() < end
        time.sleep(0.1)
    status = run(tmp_path, "dvc", "queue", "status").stdout
    assert "Success" in status, run(tmp_path, "dvc", "queue", "logs", "nu-01").stdout
    client = store.connect(f"sqlite:///{tmp_path / 'mlflow.db'}")
    experiment = client.get_experiment_by_name("placecat/test")
    current = {}
    for one in client.search_runs([experiment.experiment_id]):
        current[one.info.run_name] = (one.data.tags["placecat.current"], one.data.params["nu"].strip())
        (file,) = client.list_artifacts(one.info.run_id)
        assert file.path == "table.csv"
        assert Path(one.info.artifact_uri.removeprefix("file://")).is_relative_to(tmp_path / "mlartifacts")
    assert current == {"Table 5": ("true", "nu: 0.2"), "Table 5 (nu-01)": ("nu-01", "nu: 0.1")}
    assert not list((tmp_path / ".dvc/tmp").rglob("mlflow.db"))
