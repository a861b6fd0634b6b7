"""Log finished experiments to MLflow, from one process. The runs of a sweep are nested in a parent run."""

import hashlib
import json
import tempfile
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from placecat import files, settings
from placecat.errors import PlacecatError
from placecat.experiment import output, summary
from placecat.experiment.running import made_from_of
from placecat.experiment.summary import Ran
from placecat.mlflow_log import store
from placecat.mlflow_log.params import params_of_cue
from placecat.mlflow_log.tables import ARTIFACTS, DESCRIPTION, delete, search
from placecat.paths import NO_SEED
from placecat.report.charts.matrices import draw_matrices
from placecat.results.confusion import ALL_HOMES, pooled_rows
from placecat.results.measured import Measured
from placecat.runs.lockfile import data_version, git_commit
from placecat.search import report

_KIND = "placecat.kind"
# Tag that identifies a sweep.
_SWEEP = "placecat.sweep"
_FILES = (output.SUMMARY, report.SUMMARY)


def log_sweep(ran: Sequence[Ran], folder: Path, overrides: Sequence[str]) -> str:
    """Log a sweep and its experiments, unless they are already logged; replace an incomplete log.

    `folder` is the sweep's folder, which contains its summary. A sweep is identified by its overrides and by
    the settings, data and code of its experiments. Returns the location of the log as text. Raises
    PlacecatError if MLflow cannot be written to.
    """
    swept = list(ran[0].values)
    name = f"{' x '.join(swept) or 'one combination'}: {len(ran)} experiments"
    origins = sorted({json.dumps(made_from_of(one.result), sort_keys=True) for one in ran})
    identity = hashlib.sha256(json.dumps([*overrides, *origins]).encode()).hexdigest()
    client, experiment, where = _open()
    with store.alone(store.tracking_uri()):
        earlier = search(client, experiment, f"tags.`{_SWEEP}` = '{identity}'")
        if not any(one.info.status == "FINISHED" for one in earlier):
            for one in earlier:
                delete(client, experiment, one.info.run_id)
            _log_sweep(client, experiment, name, ran, folder, identity)
    return f"run {name!r} of {where}"


def _log_sweep(
    client: Any, experiment: str, name: str, ran: Sequence[Ran], folder: Path, identity: str
) -> None:
    swept = list(ran[0].values)
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
        tags={_KIND: "sweep", _SWEEP: identity} | _versions(),
        files=[path for name in _FILES if (path := folder / name).is_file()],
        description=summary.markdown(ran),
    )
    for one in ran:
        label = " ".join(one.values.values()) or f"experiment {one.number}"
        _log_one(client, experiment, label, one, parent)
    failed = any(one.has_failed for one in ran)
    store.finish_run(client, parent, status="FAILED" if failed else "FINISHED")


def log_one(result: dict[str, Any], folder: Path) -> str:
    """Log a single experiment with its result and folder; return the location of the log as text."""
    client, experiment, where = _open()
    used = result["settings"]
    name = f"{used['descriptor']['name']} {used['classifier']['base']['name']} {'+'.join(used['test_home'])}"
    _log_one(client, experiment, name, Ran(0, {}, folder, result), None)
    return f"run {name!r} of {where}"


def _open() -> tuple[Any, str, str]:
    """Return an MLflow client, the id of the MLflow experiment for the data set, and its location as text."""
    params = settings.load()
    name, title = (str(settings.get(params, f"dataset.{key}")) for key in ("name", "title"))
    uri = store.tracking_uri()
    client = store.connect(uri)
    description = DESCRIPTION.format(title=title)
    experiment = store.experiment_id(
        client, uri, f"placecat/{name}", artifacts=ARTIFACTS, description=description
    )
    return client, experiment, f"the MLflow experiment {f'placecat/{name}'!r} at {uri}"


def _versions() -> dict[str, str]:
    try:
        version = data_version()
    except PlacecatError:
        # The features were not computed by DVC.
        version = "unknown"
    return {"data_version": version, store.COMMIT: git_commit()}


def _log_one(client: Any, experiment: str, name: str, one: Ran, parent: str | None) -> None:
    result = one.result
    metrics: dict[str, float] = {} if one.seconds is None else {"seconds": one.seconds}
    params = {store.key(key): value for key, value in one.values.items()}
    artifacts = [one.folder / name for name in (output.RESULT, output.TRACEBACK)]
    artifacts = [path for path in artifacts if path.is_file()]
    if "settings" in result:
        params |= _params(result["settings"])
    if result["accuracy"] is not None:
        metrics |= {name: result[name] for name in output.MEASURES}
        for home, of_home in result["homes"].items():
            if of_home["accuracy"] is not None:
                metrics[store.key("accuracy", home)] = of_home["accuracy"]
    note = result.get(output.FAILED) or result["reason"] or ""
    with tempfile.TemporaryDirectory() as temporary:
        if result["accuracy"] is not None:
            artifacts += _write_confusion(Path(temporary), name, result)
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
    store.finish_run(client, run, status="FAILED" if one.has_failed else "FINISHED")


def _params(used: dict[str, Any]) -> dict[str, str]:
    """Return the parameters of an experiment, under the same names as those of a table row."""
    parts = ("descriptor", "classifier", "codebook")
    rest = settings.flatten({name: value for name, value in used.items() if name not in parts})
    cue = params_of_cue(used["descriptor"], used["classifier"], used.get("codebook"))
    return {"decides": "cue"} | {store.key(name): value for name, value in rest.items()} | cue


def _write_confusion(folder: Path, name: str, result: dict[str, Any]) -> list[Path]:
    counts = summary.confusion(result)[None, None]
    pooled = Measured((ALL_HOMES,), (NO_SEED,), tuple(result["classes"]), counts)
    draw_matrices(folder / "confusion.png", name, {"": pooled})
    files.write_csv(folder / "counts.csv", pooled_rows(pooled))
    return [folder / "confusion.png", folder / "counts.csv"]
