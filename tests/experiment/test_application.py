"""The application from the command line, with real workers, a real MLflow database and no extras."""

import json
import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pandas as pd
import pytest
from made_experiments import SMALL, make_project, resolved

import plain_install
from placecat import __main__, files
from placecat.experiment import summary
from placecat.experiment.running import compute, made_from

# All tests run on one worker, so the sweep runs only once.
pytestmark = [pytest.mark.slow, pytest.mark.xdist_group("experiment")]

# Half of the experiments fail, because there are fewer than 1000 clusters.
SWEPT = ("descriptor=gist", "classifier=knn", "classifier.base.n_neighbors=1,1000", "test_home=h1,H_2")
CLUSTERS = SMALL[1:]


def run(folder, *arguments, **environment):
    plain = folder.parent / "plain_install"
    path = str(plain) if plain.exists() else plain_install.path_of(plain)
    own = {"PLACECAT_WORKERS": "2", "MLFLOW_DISABLE_TELEMETRY": "true"}
    own["PYTHONPATH"] = os.pathsep.join(filter(None, [path, os.environ.get("PYTHONPATH")]))
    return subprocess.run(
        [sys.executable, "-m", "placecat", "experiment", *arguments],
        cwd=folder,
        env=os.environ | own | environment,
        capture_output=True,
        text=True,
        check=False,
    )


@pytest.fixture(scope="module")
def sweep(tmp_path_factory):
    folder = make_project(tmp_path_factory.mktemp("sweep") / "project")
    (folder / "dvc.lock").write_text("stages: {sequences: {outs: [{md5: 0123abcd.dir}]}}")
    return folder, run(folder, "-m", *SWEPT, *CLUSTERS, "hydra.sweep.dir=swept")


def test_a_failed_experiment_does_not_affect_the_others(sweep):
    folder, result = sweep
    assert result.returncode == 1
    assert "Traceback" not in result.stderr + result.stdout
    assert "test_home" in result.stdout
    table = pd.read_csv(folder / "swept/summary.csv")
    assert table["test_home"].tolist() == ["H1", "H2", "H1", "H2"]
    for measure in ("accuracy", "log_loss", "calibration_error"):
        assert table[measure].notna().tolist() == [True, True, False, False]
    assert table["note"].str.contains("n_neighbors=1000").tolist() == [False, False, True, True]
    for line in result.stdout.splitlines():
        if line.startswith("classifier.base.n_neighbors=1000"):
            assert "failed: n_neighbors=1000 exceeds n_clusters=" in line


def test_two_workers_produce_the_same_bytes_as_one(sweep, tmp_path, monkeypatch):
    folder, _ = sweep
    monkeypatch.chdir(folder)
    for number, home in enumerate(("h1", "H_2")):
        experiment = resolved("descriptor=gist", "classifier=knn", *CLUSTERS, f"test_home={home}")
        files.write_json(tmp_path / "result.json", compute(experiment) | made_from(experiment))
        assert (folder / f"swept/{number}/result.json").read_bytes() == (
            tmp_path / "result.json"
        ).read_bytes()


def test_a_sweep_is_an_mlflow_run_with_nested_experiments(sweep):
    from mlflow import MlflowClient

    folder, result = sweep
    assert "Logged: run" in result.stdout
    client = MlflowClient(f"sqlite:///{folder / 'mlflow.db'}")
    experiment = client.get_experiment_by_name("placecat/made")
    runs = client.search_runs(experiment.experiment_id)
    (parent,) = (one for one in runs if one.data.tags["placecat.kind"] == "sweep")
    trials = [one for one in runs if one.data.tags["placecat.kind"] == "trial"]
    assert len(trials) == 4
    assert {one.data.tags["mlflow.parentRunId"] for one in trials} == {parent.info.run_id}
    assert {one.data.tags["data_version"] for one in runs} == {"0123abcd.dir"}
    assert parent.data.metrics["failed"] == 2
    assert "| H1 " in parent.data.tags["mlflow.note.content"]
    assert {one.path for one in client.list_artifacts(parent.info.run_id)} == {"summary.csv"}
    done = [one for one in trials if one.info.status == "FINISHED"]
    assert sorted(one.info.status for one in trials) == ["FAILED", "FAILED", "FINISHED", "FINISHED"]
    for one in done:
        own = json.loads((folder / f"swept/{0 if 'H1' in one.info.run_name else 1}/result.json").read_text())
        for measure in ("accuracy", "log_loss", "calibration_error"):
            assert one.data.metrics[measure] == own[measure]
        assert one.data.params["clusters"] == "13"
        assert {path.path for path in client.list_artifacts(one.info.run_id)} == {
            "confusion.png",
            "counts.csv",
            "result.json",
        }


def test_the_same_experiment_runs_on_another_launcher(sweep):
    """Submitit works as on a cluster, but starts a process on this machine."""
    pytest.importorskip("hydra_plugins.hydra_submitit_launcher")
    folder, _ = sweep
    result = run(
        folder,
        "-m",
        *SWEPT[:2],
        "test_home=h1",
        *CLUSTERS,
        "hydra/launcher=submitit_local",
        "hydra.sweep.dir=submitted",
        "track=false",
        # Submitit is in an extra.
        PYTHONPATH=os.environ.get("PYTHONPATH", ""),
    )
    assert result.returncode == 0, result.stderr
    one, other = (folder / f"{name}/0/result.json" for name in ("swept", "submitted"))
    assert one.read_bytes() == other.read_bytes()


def main_with(monkeypatch, *words):
    """Run the application in this process."""
    monkeypatch.setattr(sys, "argv", sys.argv)
    try:
        __main__.main(["experiment", *words])
    except SystemExit as ended:
        return ended.code
    return 0


def test_a_single_experiment_is_reported_by_home_and_place(sweep, monkeypatch, capsys):
    folder, _ = sweep
    monkeypatch.chdir(folder)
    monkeypatch.setenv("PLACECAT_WORKERS", "1")
    quiet = ("hydra/job_logging=none", "hydra/hydra_logging=none", "track=false", "hydra.run.dir=one")
    assert main_with(monkeypatch, "descriptor=gist", *CLUSTERS, "codebook.cells=4", *quiet) == 0
    printed = capsys.readouterr().out
    own = json.loads((folder / "one/result.json").read_text())
    assert own["accuracy"] == pytest.approx(np.mean([home["accuracy"] for home in own["homes"].values()]))
    assert f"average: {own['accuracy']:.2f}%" in printed
    assert f"H2: {own['homes']['H2']['accuracy']:.2f}% (seed-0 " in printed
    quality = f"Log-loss {own['log_loss']:.3f} nats, calibration error {own['calibration_error']:.2f}%"
    assert quality in printed.splitlines()
    assert "as percentages of the frames of each true place" in printed


def test_an_invalid_combination_computes_nothing(sweep, monkeypatch):
    folder, _ = sweep
    monkeypatch.chdir(folder)
    words = ("-m", "descriptor=gist", "classifier.clusters=13,14", "codebook.tree.branching=4")
    message = main_with(monkeypatch, *words)
    assert message.startswith("placecat: 1 of 2 combinations are invalid")
    assert not (folder / "multirun").exists()


@pytest.mark.parametrize(
    ("words", "expected"),
    [
        (["test_home=home9"], "test_home=home9 does not exist: for data set made, use H1, H2, H3, H4 or all"),
        (
            ["descriptor=hogg"],
            "the settings cannot be composed: descriptor has no 'hogg'; did you mean 'hog'? (",
        ),
        (["-m", "descriptor=hogg", "test_home=h1,h2"], "the settings cannot be composed: descriptor has no "),
        (
            ["clasifier.clusters=3"],
            "the settings cannot be composed: there is no setting 'clasifier.clusters'",
        ),
        (["seeds=${foo}"], "the settings cannot be composed: Interpolation key 'foo' not found"),
    ],
)
def test_an_invalid_setting_gives_one_message_and_leaves_nothing(
    project, monkeypatch, capsys, words, expected
):
    before = sorted(project.iterdir())
    message = main_with(monkeypatch, *words)
    assert message.startswith(f"placecat: {expected}")
    assert "\n" not in message
    assert "search path" not in message
    assert capsys.readouterr() == ("", "")
    assert sorted(project.iterdir()) == before


def test_an_invalid_value_in_a_sweep_is_listed_without_the_search_path(project, monkeypatch):
    message = main_with(monkeypatch, "-m", "descriptor=hogg,gist", "classifier=nu_svm")
    assert "- the settings cannot be composed: descriptor has no 'hogg'; did you mean 'hog'? (" in message
    assert "search path" not in message


@pytest.mark.parametrize("command", ["experiment", "search"])
def test_help_of_a_sweep(project, monkeypatch, capsys, command):
    monkeypatch.setattr(sys, "argv", sys.argv)
    words = ["-m", "descriptor=hog,sift"] if command == "experiment" else []
    with pytest.raises(SystemExit) as ended:
        __main__.main([command, *words, "--help"])
    assert not ended.value.code
    assert "placecat experiment -m" in capsys.readouterr().out


def test_a_sweep_has_no_single_configuration(project, monkeypatch):
    assert "without -m" in main_with(monkeypatch, "-m", "descriptor=hog,sift", "--cfg", "job")


def test_help_is_our_own(project, monkeypatch, capsys):
    assert main_with(monkeypatch, "--help") == 0
    printed = capsys.readouterr().out
    assert "placecat experiment -m" in printed
    assert max(map(len, printed.splitlines())) <= 120


def test_results_are_kept_if_mlflow_is_down(sweep, monkeypatch, capsys):
    folder, _ = sweep
    monkeypatch.chdir(folder)
    monkeypatch.setenv("MLFLOW_TRACKING_URI", "http://127.0.0.1:9")
    monkeypatch.setenv("MLFLOW_HTTP_REQUEST_MAX_RETRIES", "0")
    assert not summary.tell(Path("swept"), [{}], log=[])
    printed = capsys.readouterr()
    assert "nothing was logged to MLflow: MLflow at http://127.0.0.1:9" in printed.err
    assert "Details: swept/summary.csv" in printed.out
