"""Experiments in MLflow: a run each, those of a sweep below one parent.

They are logged at the end and by one process, so that workers, on whatever machine, need no MLflow.
"""

import tempfile
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import pandas as pd

from placecat import files, settings
from placecat.errors import PlacecatError
from placecat.experiment import output, summary
from placecat.experiment.summary import Ran
from placecat.lockfile import data_version, git_commit
from placecat.mlflow_log import store
from placecat.mlflow_log.tables import ARTIFACTS, DESCRIPTION
from placecat.search import report

_KIND = "placecat.kind"
_FILES = (output.SUMMARY, report.SUMMARY, report.RESULTS)


def log_sweep(ran: Sequence[Ran], folder: Path) -> str:
    """Log a sweep and its experiments.

    Parameters
    ----------
    folder
        Of the sweep, with its summary.

    Returns
    -------
    str
        Where it is, for people.

    Raises
    ------
    PlacecatError
        MLflow cannot be written to.
    """
    uri, client, experiment, title = _open()
    swept = list(ran[0].values)
    name = f"{' x '.join(swept) or 'one combination'}: {len(ran)} experiments"
    top = summary.highest(ran)
    metrics: dict[str, float] = {
        "experiments": len(ran),
        "failed": sum(one.has_failed for one in ran),
        "without_number": sum(one.result["accuracy"] is None and not one.has_failed for one in ran),
    }
    own_params = {store.key(key): ", ".join(dict.fromkeys(one.values[key] for one in ran)) for key in swept}
    if top is not None:
        metrics["best"] = top[1]
        own_params |= {store.key("best", key): value for key, value in top[0].items()}
    parent = store.start_run(
        client,
        experiment,
        name,
        params=own_params,
        metrics=metrics,
        tags={_KIND: "sweep"} | _versions(),
        files=[path for name in _FILES if (path := folder / name).is_file()],
        description=summary.markdown(ran),
    )
    for one in ran:
        _log_one(client, experiment, _label(one), one.result, one.folder, one.values, one.seconds, parent)
    failed = any(one.has_failed for one in ran)
    store.finish_run(client, parent, status="FAILED" if failed else "FINISHED")
    return f"run {name!r} of the MLflow experiment {title!r} at {uri}"


def log_one(result: dict[str, Any], folder: Path) -> str:
    """Log a single experiment; parameters and result as for `log_sweep`."""
    uri, client, experiment, title = _open()
    own = result["settings"]
    name = f"{own['descriptor']['name']} {own['classifier']['base']['name']} {'+'.join(own['test_home'])}"
    seconds = float(files.read_json(folder / output.SECONDS))
    _log_one(client, experiment, name, result, folder, {}, seconds, None)
    return f"run {name!r} of the MLflow experiment {title!r} at {uri}"


def _open() -> tuple[str, Any, str, str]:
    """Address, client, and number and name of the data set's experiment."""
    params = settings.load()
    name, title = (str(settings.get(params, f"dataset.{key}")) for key in ("name", "title"))
    uri = store.tracking_uri()
    client = store.connect(uri)
    experiment = store.experiment_id(
        client,
        uri,
        f"placecat/{name}",
        artifacts=ARTIFACTS,
        description=DESCRIPTION.format(title=title),
    )
    return uri, client, experiment, f"placecat/{name}"


def _versions() -> dict[str, str]:
    try:
        version = data_version()
    except PlacecatError:
        # Features that were not made through DVC.
        version = "unknown"
    return {"data_version": version, store.COMMIT: git_commit()}


def _label(one: Ran) -> str:
    return " ".join(one.values.values()) or f"experiment {one.number}"


def _log_one(
    client: Any,
    experiment: str,
    name: str,
    result: dict[str, Any],
    folder: Path,
    values: dict[str, str],
    seconds: float | None,
    parent: str | None,
) -> None:
    metrics: dict[str, float] = {} if seconds is None else {"seconds": seconds}
    params = {store.key(key): value for key, value in values.items()}
    artifacts = [path for path in (folder / output.RESULT, folder / output.TRACEBACK) if path.is_file()]
    if "settings" in result:
        params |= {store.key(key): value for key, value in settings.flatten(result["settings"]).items()}
    if result["accuracy"] is not None:
        metrics["accuracy"] = result["accuracy"]
        for home, own in result["homes"].items():
            if own["accuracy"] is not None:
                metrics[store.key("accuracy", home)] = own["accuracy"]
    note = result.get(output.FAILED) or result["reason"] or ""
    with tempfile.TemporaryDirectory() as temporary:
        if result["accuracy"] is not None:
            path = Path(temporary) / "confusion.csv"
            counts = pd.DataFrame(summary.confusion(result), columns=result["classes"])
            counts.insert(0, "true_place", result["classes"])
            files.write_csv(path, counts)
            artifacts.append(path)
        run = store.start_run(
            client,
            experiment,
            name,
            params=params,
            metrics=metrics,
            tags={_KIND: "trial"} | _versions(),
            files=artifacts,
            parent=parent,
            description=note,
        )
    store.finish_run(client, run, status="FAILED" if output.FAILED in result else "FINISHED")
