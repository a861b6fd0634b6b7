"""The command `placecat replicate`."""

import shutil
from collections.abc import Sequence
from pathlib import Path

import pandas as pd
import yaml

from placecat import files, paths, settings
from placecat.config import compose
from placecat.errors import PlacecatError
from placecat.evaluation.verdict import VERDICTS
from placecat.replication import group_results, groups, needed, options, pooling
from placecat.results.collect import read_results
from placecat.thesis import definitions
from placecat.thesis.published import read_published

ACCURACIES, POWER = "accuracies.csv", "power.csv"


def run(overrides: Sequence[str], numbers: Sequence[int] = ()) -> str:
    """Run the groups of homes in a data set and judge the findings on all homes; return the text to print.

    `overrides` are Hydra overrides of conf/ that choose the data set. `numbers` are the groups to run (all by
    default). Their results are written to reports/replication; results of other groups are read from there.
    Raises PlacecatError for invalid settings, too few homes or an unknown group, if `make repro` has not run,
    or if a stage fails.
    """
    chosen = options.read()
    params = yaml.load(compose.compose(overrides), Loader=settings.Loader)
    planned, rest = groups.split(params, chosen.group)
    unknown = [number for number in numbers if not 1 <= number <= len(planned)]
    if unknown:
        raise PlacecatError(f"--groups: group {unknown[0]} does not exist: choose from 1 to {len(planned)}")
    if rest:
        print(f"Not used (too few for a group of {chosen.group}): {', '.join(rest)}", flush=True)
    for group in planned:
        if not numbers or group.number in numbers:
            state = "done" if groups.run(group) else "nothing to do"
            print(
                f"Group {group.number} of {len(planned)} ({group.homes[0]} to {group.homes[-1]}): {state}",
                flush=True,
            )
    missing = [group.number for group in planned if not group_results.folder_of(group.number).is_dir()]
    if missing:
        named = " ".join(map(str, missing))
        return f"The findings are judged once all groups have run. Run the others with --groups {named}"
    return judge(params, planned, chosen)


def judge(params: dict, planned: Sequence[groups.Group], chosen: options.Options) -> str:
    """Judge the findings from the results of all groups in reports/replication.

    Writes the ledger of verdicts to the same folder, and returns a summary as text.
    """
    of_groups = [(group.number, group.homes) for group in planned]
    results = group_results.pooled(of_groups, params, read_results(settings.load()))
    homes = [homes for _, homes in of_groups]
    rows, details = pooling.judge(
        definitions.findings(), settings.get(params, "verdict"), chosen, results, read_published(), homes
    )
    total = sum(map(len, homes))
    power = needed.power_table(details, total, chosen, needed.Run(total, chosen.level))
    rows = _with_others(rows, paths.FINDINGS, "number")
    details = _with_others(details, paths.COMPARISONS, "finding")
    counts = {verdict: int((rows["verdict"] == verdict).sum()) for verdict in VERDICTS}
    facts = {
        "title": str(params["dataset"]["title"]),
        "homes": total,
        "groups": len(planned),
        "level": chosen.level,
        "verdicts": counts,
    }
    tables = {paths.FINDINGS.name: rows, paths.COMPARISONS.name: details}
    tables |= {ACCURACIES: pooling.accuracies(results), POWER: power}
    for name, table in tables.items():
        files.write_csv(paths.REPLICATION / name, table)
    files.write_json(paths.REPLICATION_FACTS, facts)
    # Remove group results left over from a data set with more homes.
    expected = {group_results.folder_of(group.number) for group in planned}
    for folder in set(paths.REPLICATION.glob("group_*")) - expected:
        shutil.rmtree(folder)
    said = ", ".join(f"{verdict} {count}" for verdict, count in counts.items())
    return f"{len(rows)} findings on {total} homes: {said} ({paths.REPLICATED_FINDINGS})"


def _with_others(table: pd.DataFrame, path: Path, key: str) -> pd.DataFrame:
    """Add the rows that are only in the project's own ledger, with ``replicated`` set to False."""
    text = table.select_dtypes(exclude="number").columns
    others = files.read_table(path, text)
    others = others[~others[key].isin(table[key])].assign(replicated=False)
    return pd.concat([table.assign(replicated=True), others], ignore_index=True).sort_values(
        key, kind="stable", ignore_index=True
    )
