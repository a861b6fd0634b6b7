"""Read numbers from records: speeds kept in git, and facts that stages save with their results."""

from collections.abc import Iterator, Mapping
from dataclasses import replace
from typing import Any

import numpy as np
import pandas as pd

from placecat import files, paths, settings
from placecat.errors import PlacecatError
from placecat.evaluation.trials import Trial, expand
from placecat.sequences import listing
from placecat.thesis import definitions
from placecat.thesis.comparison import Line
from placecat.thesis.number import Number, Origin, nothing
from placecat.training import fold_file, protocol

# The prefix that marks a record's name in an origin.
RECORD = "record/"
PICKS = {"lowest": np.min, "highest": np.max}
_VALUE = ["quantity", "column", "where", "pick", "digits"]


def read_off(entry: Mapping[str, Any], records: Mapping[str, pd.DataFrame], where: str) -> list[Line]:
    """Read an entry's numbers from a table.

    `records` maps names to tables, which are empty if nothing was recorded. `entry` has ``record``, the
    table's name, and ``values``. Each value has ``quantity`` (its name), ``column``, and ``where``, which
    maps columns to the values that select rows. If several rows match, ``pick`` says whether to use the
    "lowest" or the "highest" value. ``digits`` is the number of digits after the decimal point (2 by
    default). Raises PlacecatError if a setting, table or column is unknown, or if several rows match and
    ``pick`` is missing; the message contains `where`, the entry's name.
    """
    settings.refuse_unknown(entry, ["record", "values"], where)
    if entry["record"] not in records:
        raise PlacecatError(
            f"{where}: there is no record {entry['record']!r} (available: {', '.join(records)})"
        )
    table = records[entry["record"]]
    origins = (Origin(f"{RECORD}{entry['record']}"),)
    return [
        Line(one["quantity"], "", replace(_value(one, table, where), origins=origins))
        for one in entry["values"]
    ]


def _value(one: Mapping[str, Any], table: pd.DataFrame, where: str) -> Number:
    settings.refuse_unknown(one, _VALUE, f"{where}.values")
    pick, digits = one.get("pick"), int(one.get("digits", 2))
    if pick is not None and pick not in PICKS:
        raise PlacecatError(f"{where}.values.pick {pick!r} does not exist: use one of {', '.join(PICKS)}")
    if table.empty:
        return nothing("not recorded")
    wanted = one.get("where", {})
    if unknown := [column for column in (*wanted, one["column"]) if column not in table]:
        has = ", ".join(map(str, table))
        raise PlacecatError(f"{where}: the record has no column {unknown[0]!r} (it has: {has})")
    for column, value in wanted.items():
        table = table[table[column] == value]
    values = table[one["column"]].dropna().to_numpy(float)
    if not len(values):
        return nothing("not recorded")
    if pick is None and len(values) > 1:
        raise PlacecatError(f"{where}: the record has {len(values)} rows for {one['quantity']!r}: add pick")
    return Number(np.array([values[0] if pick is None else PICKS[pick](values)]), False, digits=digits)


def read_records(params: Mapping[str, Any]) -> dict[str, pd.DataFrame]:
    """Read the tables behind those numbers in the text that do not come from results; return them by name.

    ``benchmarks`` and ``scale`` are kept in git. ``nu`` has one row per nu-SVM result, test home and seed.
    Its columns are result, home, the requested nu (asked), and the lowest and highest nu that the binary SVMs
    used. ``rejected`` has one row per labelled frame that a filter rejects, with the columns filter, home and
    information. A missing table has no rows.
    """
    kept = {"benchmarks": paths.BENCHMARKS, "scale": paths.SCALE_STAGES}
    found = {name: pd.read_csv(path) if path.is_file() else pd.DataFrame() for name, path in kept.items()}
    found["nu"] = pd.DataFrame([*_nu_of_cues(params), *_nu_of_trials(params)])
    found["rejected"] = pd.DataFrame(_rejected(params))
    return found


def trials_of(params: Mapping[str, Any]) -> dict[str, Trial]:
    """Return the trials of all studies, by name."""
    homes = list(settings.get(params, "dataset.homes"))
    return {
        trial.name: trial
        for tables in definitions.studies(params).values()
        for name, table in tables.items()
        for trial in expand(name, table, homes)
    }


def _nu_of_cues(params: Mapping[str, Any]) -> Iterator[dict[str, Any]]:
    for name, cue in settings.get(params, "cues").items():
        asked = _asked(cue["classifier"])
        if asked is None:
            continue
        for path in sorted((paths.CUES / name).glob("*/*.npz")):
            nu = fold_file.read_facts(path).get("nu")
            if nu:
                scheme, home = path.parent.name, path.stem.rpartition(".")[0]
                result = f"cues/{name}/{scheme}"
                yield {"result": result, "home": home, "asked": asked, "lowest": min(nu), "highest": max(nu)}


def _nu_of_trials(params: Mapping[str, Any]) -> Iterator[dict[str, Any]]:
    all_asked = {name: _asked(trial.settings["classifier"]) for name, trial in trials_of(params).items()}
    for study in definitions.studies(params):
        path = paths.TRIALS / study / "facts.csv"
        if not path.is_file():
            continue
        for facts in files.read_table(path, ["trial", "home", "seed"]).to_dict("records"):
            asked = all_asked.get(facts["trial"])
            if asked is not None and pd.notna(facts["nu_lowest"]):
                nu = {"lowest": facts["nu_lowest"], "highest": facts["nu_highest"]}
                yield {"result": facts["trial"], "home": facts["home"], "asked": asked, **nu}


def _asked(classifier: Mapping[str, Any]) -> float | None:
    """Return the nu requested in a classifier's settings, or None if the classifier is not a nu-SVM."""
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
