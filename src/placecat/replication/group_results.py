"""The results of groups of homes in reports/replication, and all of them together."""

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
    """Whether a result is measured in the homes, not in the university, the apartments or the toy problem."""
    return not result.startswith(_OTHER_DATA)


def folder_of(number: int) -> Path:
    """Folder with the results of a group, in git."""
    return paths.REPLICATION / f"group_{number}"


def write(target: Path, run: Path, homes: Sequence[str], params: Mapping[str, Any]) -> None:
    """Copy the results of a group from the folder of its run.

    Writes the counts of decisions in its homes, the tables as one file, the missing results, what the
    information filters drop, and the homes and settings.
    """
    scores = files.read_csv(run / paths.SCORES / "scores.csv")
    text = [name for name in scores.columns if name != "frames"]
    scores = scores[scores["result"].map(is_of_homes)].astype(dict.fromkeys(text, "category"))
    tables = [
        files.read_table(path, ["table", "group", "row", "column", "note"]).assign(table=path.stem)
        for path in sorted((run / paths.TABLES).glob("*.csv"))
    ]
    with files.replacing(target) as folder:
        folder.mkdir(parents=True)
        scores.to_parquet(folder / SCORES, index=False, compression="zstd")
        for name in (MISSING, DROPPED):
            files.write_csv(folder / name, files.read_csv(run / paths.SCORES / name))
        # Notes are those of reports/tables.
        files.write_csv(folder / TABLES, pd.concat(tables, ignore_index=True).drop(columns="note"))
        files.write_json(folder / FACTS, {"homes": list(homes), "settings": _comparable(params)})


def _comparable(params: Mapping[str, Any]) -> str:
    """Checksum of all settings but the homes: groups with other settings are not pooled."""
    dataset = {name: one for name, one in params["dataset"].items() if name not in ("homes", "root")}
    # A camera or a frame rate for each home.
    dataset = {
        name: one for name, one in dataset.items() if not (isinstance(one, Mapping) and name != "aliases")
    }
    content = json.dumps({**params, "dataset": dataset}, sort_keys=True)
    return hashlib.sha256(content.encode()).hexdigest()


def pooled(
    groups: Sequence[tuple[int, Sequence[str]]], params: Mapping[str, Any], others: Results
) -> Results:
    """Read the results of all groups as those of one data set.

    Parameters
    ----------
    groups
        Number and homes of each group.
    params
        All settings.
    others
        The project's results, which those in other data than homes are taken from.

    Raises
    ------
    PlacecatError
        If the results of a group are missing, or are of other homes or settings.
    """
    scores, missing, dropped = [], [], []
    for number, homes in groups:
        folder = folder_of(number)
        if not (folder / FACTS).is_file():
            raise PlacecatError(f"{folder} is missing: run `placecat replicate` for group {number}")
        facts = files.read_json(folder / FACTS)
        if facts != {"homes": list(homes), "settings": _comparable(params)}:
            raise PlacecatError(
                f"{folder} has results of other homes or settings: run `placecat replicate` for all groups"
            )
        table = pd.read_parquet(folder / SCORES)
        scores.append(table.astype({name: str for name in table.columns if name != "frames"}))
        missing.append(files.read_csv(folder / MISSING).astype(str))
        dropped.append(files.read_table(folder / DROPPED, ["filter", "home"]))
    names = [home for _, homes in groups for home in homes]
    together = [pd.concat(parts, ignore_index=True) for parts in (scores, missing, dropped)]
    of_homes = from_scores(
        together[0], together[1], names, settings.get(params, "dataset.classes"), dropped=together[2]
    )
    elsewhere = {name: one for name, one in others.measured.items() if not is_of_homes(name)}
    return replace(of_homes, measured=of_homes.measured | elsewhere, stays=others.stays)
