"""Compute how many homes are needed to decide each finding, from the spread between homes in a run."""

import re
from typing import NamedTuple

import numpy as np
import pandas as pd

from placecat.errors import PlacecatError
from placecat.evaluation.verdict import Range, corrected_level
from placecat.paths import COMPARISONS
from placecat.replication.options import Options
from placecat.replication.simulation import power, spread

# The largest number of homes to try, and the required probability of a verdict.
MOST, _WANTED = 240, 0.8


class Run(NamedTuple):
    """The run from which the spread is taken, with its number of homes and the level of its intervals."""

    homes: int
    level: float


# The run on the data set that comes with the project.
SIX = Run(6, 0.95)


class _Comparison(NamedTuple):
    """A comparison: the share of homes that count, their spread, the claimed range, and both differences.

    These are the published difference and the measured one.
    """

    share: float
    deviation: float
    claimed: Range
    published: float
    measured: float


def power_table(comparisons: pd.DataFrame, homes: int, options: Options, run: Run = SIX) -> pd.DataFrame:
    """Compute the power of each finding, from the comparisons in the ledger of `run`.

    `homes` is the number of homes in the replication, a multiple of the group size in `options`.

    Returns one row per finding, with its number, the number of its comparisons, units (how many homes of the
    replication count, 0 if unknown) and spread (the largest standard deviation between homes, in points).
    Each row also has power (the probability of a verdict with `homes` homes) and needed (the number of homes
    for a power of 80%, infinite above `MOST`). Both appear twice, first on the assumption that the published
    differences are true, then that the measured ones are. Numbers are NaN for comparisons of one home, of
    stays or of shares, and for unpublished differences.
    """
    rows = []
    for number, of_finding in comparisons[comparisons["reading"].fillna("") == ""].groupby("finding"):
        known = [_known(row, run) for row in of_finding.to_dict("records")]
        row = {"number": number, "comparisons": len(known), "units": 0, "spread": np.nan}
        complete = [one for one in known if one is not None]
        if len(complete) == len(known):
            row["units"] = min(round(one.share * homes) for one in complete)
            row["spread"] = round(max(one.deviation for one in complete), 1)
        for truth in ("published", "measured"):
            effects = [getattr(one, truth) for one in complete]
            usable = len(complete) == len(known) and not np.isnan(effects).any()
            row[f"power_{truth}"] = (
                round(_power(complete, effects, homes, options.level), 2) if usable else np.nan
            )
            row[f"needed_{truth}"] = _needed(complete, effects, options) if usable else np.nan
        rows.append(row)
    return pd.DataFrame(rows)


def _known(row: dict, run: Run) -> _Comparison | None:
    claimed = _claimed(str(row["range"]))
    units = re.fullmatch(r"(\d+) homes?(?: x (\d+) seeds?)?", str(row["units"]))
    if claimed is None or units is None or int(units[1]) < 2:
        return None
    homes, seeds = int(units[1]), int(units[2] or 1)
    low, high = float(row["low"]), float(row["high"])
    deviation = spread(low, high, homes * seeds, run.level)
    published = pd.to_numeric(row["published"], errors="coerce")
    return _Comparison(homes / run.homes, deviation, claimed, float(published), float(row["measured"]))


def _claimed(text: str) -> Range | None:
    if text == "both signs":
        return None
    ends = [float(end) for end in re.findall(r"-?\d+(?:\.\d+)?", text)]
    if text.startswith("between") and len(ends) == 2:
        return Range(*ends)
    if text.startswith("above") and len(ends) == 1:
        return Range(ends[0], np.inf)
    if text.startswith("below") and len(ends) == 1:
        return Range(-np.inf, ends[0])
    raise PlacecatError(f"{COMPARISONS}: unknown range {text!r}: run `placecat repro` again")


def _power(known: list[_Comparison], effects: list[float], homes: int, level: float) -> float:
    """Return the probability of the more likely verdict, assuming that comparisons are independent."""
    wide = corrected_level(level, len(known))
    holds, no_failure = 1.0, 1.0
    for one, effect in zip(known, effects, strict=True):
        units = max(2, round(one.share * homes))
        one_holds, one_fails = power(effect, one.deviation, units, one.claimed, level=level, wide=wide)
        holds *= one_holds
        no_failure *= 1.0 - one_fails
    return max(holds, 1.0 - no_failure)


def _needed(known: list[_Comparison], effects: list[float], options: Options) -> float:
    for homes in range(2 * options.group, MOST + 1, options.group):
        if _power(known, effects, homes, options.level) >= _WANTED:
            return homes
    return np.inf


def markdown(table: pd.DataFrame) -> str:
    """Format the table from :func:`power_table` as Markdown for docs/replication.md."""
    lines = [
        "| finding | comparisons | homes that count | spread | power, needed: as published | as measured |",
        "|---:|---:|---:|---:|---:|---:|",
    ]
    for row in table.to_dict("records"):
        cells = [str(row["number"]), str(row["comparisons"])]
        cells += ["", ""] if np.isnan(row["spread"]) else [str(row["units"]), f"{row['spread']:.1f}"]
        for truth in ("published", "measured"):
            share, homes = row[f"power_{truth}"], row[f"needed_{truth}"]
            count = f"over {MOST}" if np.isinf(homes) else f"{homes:.0f}"
            cells.append("" if np.isnan(share) else f"{100 * share:.0f}%, {count}")
        lines.append("| " + " | ".join(cells) + " |")
    return "\n".join(lines)
