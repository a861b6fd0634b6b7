"""The results of each group of homes in reports/replication, and of all groups together."""

import hashlib
import json
from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import pandas as pd

from placecat import files, paths, settings
from placecat.errors import PlacecatError
from placecat.results.measured import Results, from_scores

SCORES, MISSING, DROPPED = "scores.parquet", "missing.csv", "dropped.csv"
TABLES, FACTS = "tables.csv", "facts.json"

_OTHER_DATA = ("splits/", "toy/")


def is_of_homes(result: str) -> bool:
    """Return whether a result comes from homes, not the university, the apartments or the toy problem."""
    return not result.startswith(_OTHER_DATA)


def folder_of(number: int) -> Path:
    """Return the folder with the results of a group, which is in git."""
    return paths.REPLICATION / f"group_{number}"


def write(target: Path, run: Path, homes: Sequence[str], params: Mapping[str, Any]) -> None:
    """Copy the results of a group from the folder of its run to `target`.

    The files contain the decision counts for the homes in the group, all tables merged into one, the missing
    results, the number of frames that each information filter drops, and the names of the homes with a
    checksum of the settings.
    """
    scores = files.read_cells(run / paths.SCORES / "scores.csv")
    kinds = {name: int if name == "frames" else "category" for name in scores.columns}
    scores = scores[scores["result"].map(is_of_homes)].astype(kinds)
    tables = [
        files.read_table(path, ["table", "group", "row", "column", "note"]).assign(table=path.stem)
        for path in sorted((run / paths.TABLES).glob("*.csv"))
    ]
    with files.replacing(target) as folder:
        folder.mkdir(parents=True)
        scores.to_parquet(folder / SCORES, index=False, compression="zstd")
        for name in (MISSING, DROPPED):
            files.write_csv(folder / name, files.read_cells(run / paths.SCORES / name))
        # Leave out the notes, which are the same as in reports/tables.
        files.write_csv(folder / TABLES, pd.concat(tables, ignore_index=True).drop(columns="note"))
        files.write_json(folder / FACTS, {"homes": list(homes), "settings": _comparable(params)})


def _comparable(params: Mapping[str, Any]) -> str:
    """Return a checksum of all settings except the homes; only groups with the same checksum are pooled."""
    dataset = {name: one for name, one in params["dataset"].items() if name not in ("homes", "root")}
    # Leave out settings that have a value for each home, such as cameras and frame rates.
    dataset = {
        name: one for name, one in dataset.items() if not (isinstance(one, Mapping) and name != "aliases")
    }
    content = json.dumps({**params, "dataset": dataset}, sort_keys=True)
    return hashlib.sha256(content.encode()).hexdigest()


def pooled(
    groups: Sequence[tuple[int, Sequence[str]]], params: Mapping[str, Any], others: Results
) -> Results:
    """Read the results of all groups, each given by its number and homes, as if they were one data set.

    `params` contains all settings. `others` are the results of the project's own run, of which only those on
    other data are added. Raises PlacecatError if the results of a group are missing, or belong to different
    homes or settings.
    """
    scores, missing, dropped = [], [], []
    for number, homes in groups:
        folder = folder_of(number)
        if not (folder / FACTS).is_file():
            raise PlacecatError(f"{folder} is missing: run `placecat replicate` with --groups {number}")
        facts = files.read_json(folder / FACTS)
        if facts != {"homes": list(homes), "settings": _comparable(params)}:
            raise PlacecatError(
                f"{folder} has results for other homes or settings: run `placecat replicate` for all groups"
            )
        table = pd.read_parquet(folder / SCORES)
        scores.append(table.astype({name: str for name in table.columns if name != "frames"}))
        missing.append(files.read_cells(folder / MISSING))
        dropped.append(files.read_table(folder / DROPPED, ["filter", "home"]))
    names = [home for _, homes in groups for home in homes]
    together = [pd.concat(parts, ignore_index=True) for parts in (scores, missing, dropped)]
    of_homes = from_scores(
        together[0], together[1], names, settings.get(params, "dataset.classes"), dropped=together[2]
    )
    elsewhere = {name: one for name, one in others.measured.items() if not is_of_homes(name)}
    return replace(of_homes, measured=of_homes.measured | elsewhere, stays=others.stays)
