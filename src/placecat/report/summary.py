"""The report's headlines: the best cues, integration, smoothing, and the number of findings by verdict."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
import pandas as pd

from placecat.evaluation.verdict import VERDICTS
from placecat.report.grid import NUMBERS, Cell, make_cell
from placecat.thesis.number import AVERAGE

INTEGRATION, SMOOTHED = "Integration", "HMM"

# Accuracies of Wu et al. on the VPC-2009 home database in percent, as cited in the thesis: holistic Centrist
# on single frames (4.2), holistic Centrist filtered over time (4.2), and SIFT (2.3).
WU = {"frames": 41.87, "filtered": 46.78, "sift": 39.8}


@dataclass(frozen=True)
class Headline:
    """One group of Table 26, averaged over homes: the best cue, integration, and smoothed integration.

    `best` names the best single cue in this run, and `best_published` the best one in the thesis. Either may
    be "".
    """

    group: str
    best: str
    best_published: str
    cue: Cell
    integration: Cell
    smoothed: Cell


def best_system(table: pd.DataFrame) -> dict[str, Any] | None:
    """Return the group, row and cell of Table 26's best average, or None if nothing was measured."""
    averages = table[(table["column"] == AVERAGE) & table["measured"].notna()]
    if averages.empty:
        return None
    best = _first(averages.nlargest(1, "measured"))
    return {"group": best["group"], "row": best["row"], "cell": make_cell(best)}


def headlines(table: pd.DataFrame) -> list[Headline]:
    """Condense Table 26 (:func:`placecat.thesis.tables.fill_table`) into one headline per group, in order."""
    averages = table[table["column"] == AVERAGE]
    return [_headline(str(group), part) for group, part in averages.groupby("group", sort=False)]


def _headline(group: str, part: pd.DataFrame) -> Headline:
    cues = part[~part["row"].isin([INTEGRATION, SMOOTHED])]
    best, best_published = (
        _first(cues.dropna(subset=column).nlargest(1, column)) for column in ("measured", "published")
    )
    return Headline(
        group,
        best["row"],
        best_published["row"],
        make_cell({**best, "published": best_published["published"]}),
        *(make_cell(_first(part[part["row"] == row])) for row in (INTEGRATION, SMOOTHED)),
    )


def _first(rows: pd.DataFrame) -> Mapping[Any, Any]:
    """Return the first of the `rows`, or a row without numbers if there are none."""
    return next(iter(rows.to_dict("records")), {"row": "", **dict.fromkeys(NUMBERS, np.nan)})


def readings_of(findings: pd.DataFrame) -> dict[str, str]:
    """Map each column with verdicts under another reading of the thesis to the name of that reading."""
    prefix = "verdict_"
    return {name: name.removeprefix(prefix) for name in findings.columns if name.startswith(prefix)}


def judged_together(comparisons: pd.DataFrame) -> set[int]:
    """Return the findings with several comparisons whose cases are judged together (range "both signs")."""
    together = comparisons[comparisons["range"] == "both signs"]
    return set(together.loc[together.duplicated(["finding", "reading"]), "finding"])


def count_verdicts(findings: pd.DataFrame) -> dict[str, int]:
    """Count the findings by verdict; the three usual verdicts come first."""
    counts = findings["verdict"].value_counts()
    names = [*VERDICTS, *sorted(set(counts.index) - set(VERDICTS))]
    return {str(name): int(counts.get(name, 0)) for name in names}
