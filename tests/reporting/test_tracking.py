import pandas as pd
import pytest

from placecat.reporting.tracking import TableRun, flatten, log_tables, metric_name

CELLS = pd.DataFrame(
    [
        (5, "", "SVM", "Home 1", 37.22, 30.5, "measured"),
        (5, "", "SVM + y", "Average", 42.26, None, "why not"),
    ],
    columns=["table", "group", "row", "column", "published", "measured", "note"],
)


@pytest.fixture
def log(tmp_path, monkeypatch):
    monkeypatch.setenv("MLFLOW_DISABLE_TELEMETRY", "true")
    monkeypatch.chdir(tmp_path)
    uri = "sqlite:///mlflow.db"
    table = tmp_path / "table_05.csv"
    CELLS.to_csv(table, index=False)

    def log(cells=CELLS, data_version="v1"):
        run = TableRun("table_05", "Table 5: Gist", cells, {"cues.gist.classifier.base.nu": "0.2"}, [table])
        return log_tables(
            [run],
            uri=uri,
            experiment="placecat/test",
            data="test homes",
            data_version=data_version,
            commit="",
            artifacts=tmp_path / "artifacts",
        )

    return log


def runs(current=None):
    from mlflow import MlflowClient

    client = MlflowClient("sqlite:///mlflow.db")
    experiment = client.get_experiment_by_name("placecat/test")
    found = client.search_runs([experiment.experiment_id])
    return [run for run in found if current is None or run.data.tags["placecat.current"] == current]


def test_a_table_is_a_run_and_is_never_logged_twice(log, tmp_path):
    first = log()
    assert log() == first
    (run,) = runs()
    assert run.data.metrics == {"SVM/Home 1": 30.5}
    assert run.data.params == {"cues.gist.classifier.base.nu": "0.2"}
    assert run.data.tags["data_version"] == "v1"
    assert run.info.status == "FINISHED"
    assert [path.name for path in (tmp_path / "artifacts").rglob("*.csv")] == ["table_05.csv"]


def test_a_changed_result_supersedes(log):
    log()
    changed = CELLS.assign(measured=[31.0, None])
    log(changed)
    (old,) = runs("false")
    (new,) = runs("true")
    assert new.data.metrics == {"SVM/Home 1": 31.0}
    assert old.data.tags["placecat.superseded_by"] == new.info.run_id
    log(CELLS, data_version="v2")
    assert len(runs("true")) == 1
    assert len(runs()) == 3


def test_metric_names_are_accepted_by_mlflow():
    name = metric_name("4-5-1, all cues", "Ori M/V + y-Pos", "Home 1")
    assert name == "4-5-1 all cues/Ori M/V and y-Pos/Home 1"


def test_settings_are_flat():
    assert flatten({"a": {"b": 1, "c": {"d": None}}, "e": [1, 2]}) == {
        "a.b": "1",
        "a.c.d": "None",
        "e": "[1, 2]",
    }
