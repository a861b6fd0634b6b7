"""The quality of each result's distributions: log-loss, calibration error, and stay accuracy."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
import pandas as pd

from placecat.evaluation.quality import HomeQuality
from placecat.results.measured import DECIMALS, Quality

QUALITY_COLUMNS = ["result", "home", "seed", *HomeQuality._fields]
TEXT_COLUMNS = QUALITY_COLUMNS[:3]
_COUNTS = ("stays", "stays_right")
# Decimals in files. Numbers are rounded because the last bits of a logarithm depend on the processor.
FILE_DECIMALS = 6
STAY_SHARE = "stay_share"
_SHOWN = DECIMALS | {STAY_SHARE: 2}


def gather(homes: Sequence[str], seeds: Sequence[str], measured: Sequence[Sequence[HomeQuality]]) -> Quality:
    """Collect the quality measures of a result; `measured` is indexed by seed, then by home."""
    values = np.array(measured, np.float64).reshape(len(seeds), len(homes), -1)
    return Quality(
        tuple(homes), tuple(seeds), {field: values[..., k] for k, field in enumerate(HomeQuality._fields)}
    )


def quality_rows(name: str, one: Quality) -> list[tuple[str | float, ...]]:
    """List the rows of one result for the combined results file (see `QUALITY_COLUMNS`)."""
    rows = []
    for s, seed in enumerate(one.seeds):
        for h, home in enumerate(one.homes):
            values = {field: float(one.values[field][s, h]) for field in HomeQuality._fields}
            written = (int(v) if field in _COUNTS else round(v, FILE_DECIMALS) for field, v in values.items())
            rows.append((name, home, seed, *written))
    return rows


def from_rows(table: pd.DataFrame) -> dict[str, Quality]:
    """Rebuild the quality of all results, by result name, from the rows of `quality_rows`."""
    found = {}
    for name, rows in table.groupby("result", sort=False):
        homes, seeds = tuple(dict.fromkeys(rows["home"])), tuple(dict.fromkeys(rows["seed"]))
        index = (pd.Categorical(rows["seed"], seeds).codes, pd.Categorical(rows["home"], homes).codes)
        values = {}
        for field in HomeQuality._fields:
            values[field] = np.full((len(seeds), len(homes)), np.nan)
            values[field][index] = rows[field]
        found[str(name)] = Quality(homes, seeds, values)
    return found


def quality_table(found: Mapping[str, Quality]) -> pd.DataFrame:
    """Average each result's measures over homes and seeds; return one row per result.

    The columns are result, homes, seeds and stays (their numbers; seeds is 0 if nothing is random), log_loss
    (nats), calibration_error (percent), stay_accuracy (percent, averaged over the places in a home, then over
    homes), and stay_share (the percentage of all stays that are named correctly). Each measure also has a
    column ``..._spread``, which is the difference between the largest and smallest numbers over seeds, or NaN
    if nothing is random.
    """
    rows = []
    for name, one in found.items():
        row: dict[str, str | float] = {"result": name, "homes": len(one.homes)}
        row["seeds"] = len(one.seeds) if one.is_random else 0
        row["stays"] = int(one.values["stays"][0].sum())
        for measure, decimals in _SHOWN.items():
            values = one.stay_share() if measure == STAY_SHARE else one.over_homes(measure)
            row[measure] = round(float(values.mean()), decimals) if len(values) else np.nan
            random = one.is_random and len(values)
            row[f"{measure}_spread"] = round(float(np.ptp(values)), decimals) if random else np.nan
        rows.append(row)
    columns = [part for measure in _SHOWN for part in (measure, f"{measure}_spread")]
    return pd.DataFrame(rows, columns=["result", "homes", "seeds", "stays", *columns])
