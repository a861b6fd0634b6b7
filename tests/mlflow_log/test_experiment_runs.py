"""The metrics of experiments in MLflow."""

from pathlib import Path

from placecat.experiment import tracking
from placecat.mlflow_log import store

QUALITY = {"log_loss": 1.25, "calibration_error": 12.5}


def test_an_experiment_has_the_measures_of_its_result(monkeypatch):
    logged = {}
    monkeypatch.setattr(tracking, "_open", lambda: (None, "1", "here"))
    monkeypatch.setattr(tracking, "_versions", dict)
    monkeypatch.setattr(tracking, "_write_confusion", lambda *arguments: [])
    monkeypatch.setattr(store, "start_run", lambda *arguments, **content: logged.update(content))
    monkeypatch.setattr(store, "finish_run", lambda *arguments, status: logged.update(status=status))
    used = {
        "descriptor": {"kind": "holistic", "name": "gist"},
        "classifier": {"model": "knn", "base": {"name": "knn"}},
        "test_home": ["H1"],
        "probabilities": {"bins": 10, "smallest": 1e-9},
    }
    homes = {"H1": {"accuracy": 50.0, "reason": None, "folds": {}} | QUALITY}
    result = {"settings": used, "accuracy": 50.0, "reason": None, "homes": homes} | QUALITY
    assert "gist knn H1" in tracking.log_one(result, Path("nowhere"))
    assert logged["metrics"] == {"accuracy": 50.0, "accuracy/H1": 50.0} | QUALITY
    assert logged["params"]["probabilities.bins"] == "10"
    assert logged["status"] == "FINISHED"
