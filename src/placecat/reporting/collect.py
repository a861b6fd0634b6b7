"""Reading the results that the stage `scores` wrote, and records of other kinds."""

from collections.abc import Iterator, Mapping
from dataclasses import replace
from typing import Any

import pandas as pd

from placecat import definitions, files, listing, paths, settings
from placecat.evaluation.trials import expand
from placecat.learning.toy_circles import NAMES
from placecat.reporting.quality import TEXT_COLUMNS, from_rows
from placecat.reporting.results import Results, from_scores
from placecat.training import protocol


def read_results(params: Mapping[str, Any]) -> Results:
    """Read every result of a run.

    Parameters
    ----------
    params
        All settings; ``dataset`` and ``splits`` name homes and places.

    Raises
    ------
    PlacecatError
        If the stage `scores` has not run.
    """
    others = [own["dataset"]["classes"] for own in settings.get(params, "splits").values()]
    results = from_scores(
        _read("scores"),
        _read("missing"),
        settings.get(params, "dataset.homes"),
        settings.get(params, "dataset.classes"),
        [*others, NAMES],
        _read("stays"),
        files.read_table(paths.SCORES / "dropped.csv", ["filter", "home"]),
    )
    quality = files.read_table(paths.SCORES / "probabilities.csv", TEXT_COLUMNS)
    return replace(results, quality=from_rows(quality))


def read_records(params: Mapping[str, Any]) -> dict[str, pd.DataFrame]:
    """Read what numbers in the thesis's text are measured by besides results.

    Returns
    -------
    dict
        ``benchmarks`` and ``scale``, which git keeps; ``nu``, a row a model of a nu-SVM that trained for one
        test home: result, home, asked, lowest and highest nu in force of its two-class machines;
        ``rejected``, a row a labelled frame that a filter rejects: filter, home, information. Without rows
        where nothing is there.
    """
    kept = {"benchmarks": paths.BENCHMARKS, "scale": paths.SCALE_STAGES}
    found = {name: pd.read_csv(path) if path.is_file() else pd.DataFrame() for name, path in kept.items()}
    found["nu"] = pd.DataFrame([*_nu_of_cues(params), *_nu_of_trials(params)])
    found["rejected"] = pd.DataFrame(_rejected(params))
    return found


def _nu_of_cues(params: Mapping[str, Any]) -> Iterator[dict[str, Any]]:
    for name, cue in settings.get(params, "cues").items():
        asked = _asked(cue["classifier"])
        if asked is None:
            continue
        for path in sorted((paths.CUES / name).glob("*/*/*/facts.json")):
            nu = files.read_json(path).get("nu")
            if nu:
                scheme, home = path.parts[-4:-2]
                yield _nu(f"cues/{name}/{scheme}", home, asked, min(nu), max(nu))


def _nu_of_trials(params: Mapping[str, Any]) -> Iterator[dict[str, Any]]:
    homes = settings.get(params, "dataset.homes")
    for study, tables in definitions.studies(params).items():
        path = paths.TRIALS / study / "facts.csv"
        if not path.is_file():
            continue
        trials = [trial for name, table in tables.items() for trial in expand(name, table, homes)]
        all_asked = {trial.name: _asked(trial.settings["classifier"]) for trial in trials}
        for facts in files.read_table(path, ["trial", "home", "seed"]).to_dict("records"):
            asked = all_asked.get(facts["trial"])
            if asked is not None and pd.notna(facts["nu_lowest"]):
                yield _nu(facts["trial"], facts["home"], asked, facts["nu_lowest"], facts["nu_highest"])


def _nu(result: str, home: str, asked: float, lowest: float, highest: float) -> dict[str, Any]:
    return {"result": result, "home": home, "asked": asked, "lowest": lowest, "highest": highest}


def _asked(classifier: Mapping[str, Any]) -> float | None:
    """The nu that a classifier's settings ask for, if it is a nu-SVM."""
    base = classifier.get("base", {})
    return float(base["nu"]) if base.get("name") == "nu_svm" else None


def _rejected(params: Mapping[str, Any]) -> Iterator[dict[str, Any]]:
    homes = settings.get(params, "dataset.homes")
    for home in protocol.tested_homes(homes, settings.get(params, "protocol.test_homes")):
        path = paths.features(home) / "information.npy"
        information = files.read_array(path)[listing.read_labels(home) >= 0]
        for name, options in settings.get(params, "filters").items():
            if options["threshold"] is None:
                continue
            for value in information[information < options["threshold"]]:
                yield {"filter": name, "home": home, "information": float(value)}


def _read(name: str) -> pd.DataFrame:
    # Names of homes may look like numbers.
    table = files.read_csv(paths.SCORES / f"{name}.csv")
    text = [column for column in table.columns if column != "frames"]
    return table.astype(dict.fromkeys(text, str))
