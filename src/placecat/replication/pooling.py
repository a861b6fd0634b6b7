"""Judge the findings on the homes of all groups."""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
import pandas as pd

from placecat.errors import NotComputable
from placecat.replication.group_results import is_of_homes
from placecat.replication.options import Options
from placecat.replication.shared import shared_variance
from placecat.results.measured import Results
from placecat.thesis.claims import Finding, read_finding
from placecat.thesis.findings import ledger
from placecat.thesis.judging import Judged, in_each_home
from placecat.thesis.pairing import Paired
from placecat.thesis.published import Published

_DECIMALS = 2


def judge(
    findings: Mapping[str, Any],
    verdict: Mapping[str, Any],
    options: Options,
    results: Results,
    published: Published,
    groups: Sequence[Sequence[str]],
) -> tuple[pd.DataFrame, pd.DataFrame]:
    """Judge every finding about homes on the homes of all groups.

    `findings`, `verdict` and `published` are the same as for :func:`placecat.thesis.findings.ledger`, but the
    level in `options` replaces the one in `verdict`. `results` come from all groups, and `groups` lists the
    homes of each group.

    Returns the tables of findings and comparisons in the ledger, without findings about other data. In both,
    the additional column ``shared`` is the share of variance that homes in a group have in common
    (:func:`placecat.replication.shared.shared_variance`), or NaN if unknown. For a finding, it is the largest
    share among its comparisons. If it exceeds `options.shared`, the reason for the verdict says so.
    """
    of_homes = {name: one for name, one in findings.items() if _is_about_homes(read_finding(name, one))}
    rules = {**verdict, "level": options.level}
    rows, details, judged = ledger(of_homes, rules, results, published)
    group_of = {home: number for number, homes in enumerate(groups) for home in homes}
    details["shared"] = [_shared(one, group_of) for one in judged]
    main = details[details["reading"] == ""].groupby("finding")["shared"].max()
    rows["shared"] = rows["number"].map(main)
    rows["reason"] = [
        f"{reason}; homes of a group share {100 * shared:.0f}% of the variance, "
        "so the verdict may be wrong more often"
        if shared > options.shared
        else reason
        for reason, shared in zip(rows["reason"], rows["shared"], strict=True)
    ]
    return rows, details


def _is_about_homes(finding: Finding) -> bool:
    sides = (side for comparison in finding.comparisons for side in comparison.sides)
    return any(is_of_homes(result) for side in sides for result in side.results)


def _shared(judged: Judged, group_of: Mapping[str, int]) -> float:
    paired = judged.measurement.paired if judged.measurement else None
    if not isinstance(paired, Paired):
        return float("nan")
    try:
        values = in_each_home(judged.comparison, paired)
    except NotComputable:
        return float("nan")
    return round(shared_variance(values, [group_of[home] for home in paired.homes]), _DECIMALS)


def accuracies(results: Results) -> pd.DataFrame:
    """Summarize the accuracies of each result over homes.

    Returns the columns result, homes (their number), accuracy (mean), deviation (standard deviation between
    homes), smallest and largest, in percent or points with 2 decimals. The accuracy of a home is its mean
    over seeds. Results on other data are left out.
    """
    rows = []
    for name, one in results.measured.items():
        if not is_of_homes(name):
            continue
        of_homes = one.by_home().mean(axis=0)
        of_homes = of_homes[np.isfinite(of_homes)]
        deviation = of_homes.std(ddof=1) if len(of_homes) > 1 else np.nan
        numbers = (
            (of_homes.mean(), deviation, of_homes.min(), of_homes.max()) if len(of_homes) else (np.nan,) * 4
        )
        rows.append((name, len(of_homes), *(round(float(number), _DECIMALS) for number in numbers)))
    return pd.DataFrame(rows, columns=["result", "homes", "accuracy", "deviation", "smallest", "largest"])
