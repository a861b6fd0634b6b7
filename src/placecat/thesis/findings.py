"""The ledger of findings: the thesis's claims, this run's measurements, and the verdicts."""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
import pandas as pd

from placecat import settings
from placecat.evaluation.bootstrap import Interval
from placecat.evaluation.verdict import VERDICTS, combine, corrected_level
from placecat.results.measured import Results
from placecat.thesis.claims import Comparison, Finding, read_finding
from placecat.thesis.judging import Judged, judge_cases, judge_comparison, percent
from placecat.thesis.published import Published
from placecat.thesis.rules import Rules

_NOTHING = Interval(float("nan"), float("nan"), float("nan"))


def ledger(
    findings: Mapping[str, Any], verdict: Mapping[str, Any], results: Results, published: Published
) -> tuple[pd.DataFrame, pd.DataFrame, list[Judged]]:
    """Judge every finding.

    `findings` maps each finding's name to its settings (see `read_finding`); invalid settings raise
    PlacecatError. `verdict` contains the settings for `Rules`.

    Returns
    -------
    findings
        One row per finding, ordered by number. The columns are number, section, claim, published, measured,
        difference, low, high, units, verdict, one ``verdict_...`` per reading ("" if the finding has no such
        reading), and reason. A finding with several comparisons shows the deciding one. If that comparison is
        a ratio, so is `difference`.
    comparisons
        One row per comparison. The columns are finding, reading ("" or the name of another reading), left,
        right, compare, published_left, published_right, published, measured_left, measured_right, measured,
        low, high, corrected_low, corrected_high, range, units, verdict, reason, left_results and
        right_results. `published` and `measured` are differences or ratios, depending on `compare`. `low` and
        `high` decide whether a comparison holds. The corrected interval, which allows for the number of
        comparisons in the finding, decides whether the comparison fails. A comparison without measurements is
        undecided. Numbers are in percent or points, rounded to two decimals, and NaN if missing.
    judged
        The full judgement for each row of `comparisons`.
    """
    rules: Rules = settings.call(Rules, settings=verdict, where="verdict")
    read = sorted((read_finding(name, one) for name, one in findings.items()), key=lambda one: one.number)
    readings = list(dict.fromkeys(reading for finding in read for reading in finding.readings))
    rows, details, all_judged = [], [], []
    for finding in read:
        by_reading = {}
        for reading in ("", *finding.readings):
            comparisons = (finding.read_as(reading) if reading else finding).comparisons
            judged = [
                judge_comparison(finding.name, one, rules, results, published, len(comparisons))
                for one in comparisons
            ]
            details += [_comparison_row(finding, reading, one) for one in judged]
            all_judged += judged
            by_reading[reading] = _finding_row(finding, judged, rules)
        row = by_reading.pop("")
        drops = filter(None, (results.drops(f"filtered/{one}") for one in finding.filters))
        reason = "; ".join([row.pop("reason"), *drops])
        verdicts = {f"verdict_{name}": by_reading.get(name, {}).get("verdict", "") for name in readings}
        rows.append(row | verdicts | {"reason": reason})
    return pd.DataFrame(rows), pd.DataFrame(details), all_judged


def _finding_row(finding: Finding, judged: Sequence[Judged], rules: Rules) -> dict[str, Any]:
    verdict, reasons = combine([one.verdict for one in judged]), []
    about_cases = all(one.claimed is None for one in judged)
    measured = [one.measurement for one in judged if one.measurement]
    if about_cases and measured:
        verdict, reason = judge_cases(measured, rules)
        reasons.append(reason)
    candidates = judged if about_cases else [one for one in judged if one.verdict == verdict]
    shown = min(candidates, key=_margin, default=judged[0])
    if len(judged) > 1:
        counts = {kind: sum(one.verdict == kind for one in judged) for kind in VERDICTS}
        listed = ", ".join(f"{kind} {count}" for kind, count in counts.items() if count)
        if not about_cases:
            level = percent(corrected_level(rules.level, len(judged)))
            listed += f", allowing for {len(judged)} comparisons (Bonferroni: {level} intervals)"
        sides = f"{shown.comparison.left.label} against {_right_label(shown.comparison)}"
        reasons.append(f"{len(judged)} comparisons: {listed}; shown: {sides}")
    if not (about_cases and measured):
        reasons.append(shown.reason)
    return {
        "number": finding.number,
        "section": finding.section,
        "claim": finding.claim,
        "published": _text(shown.comparison, shown.thesis.numbers, shown.thesis.difference),
        "measured": _text(shown.comparison, shown.measurement.numbers) if shown.measurement else "",
        **_interval("difference", shown),
        "units": shown.measurement.paired.units if shown.measurement else "",
        "verdict": verdict,
        "reason": "; ".join(dict.fromkeys(reasons)),
    }


def _margin(judged: Judged) -> tuple[bool, float]:
    """Return a sort key that puts the deciding comparison first, and those without an interval last."""
    if judged.measurement is None or np.isnan(judged.measurement.interval.low):
        return True, 0.0
    return False, judged.claimed.margin(judged.measurement.interval) if judged.claimed else 0.0


def _comparison_row(finding: Finding, reading: str, judged: Judged) -> dict[str, Any]:
    comparison, measurement = judged.comparison, judged.measurement
    results = measurement.results if measurement else tuple(side.results for side in comparison.sides)
    corrected = measurement.corrected if measurement else _NOTHING
    return {
        "finding": finding.number,
        "reading": reading,
        "left": comparison.left.label,
        "right": _right_label(comparison),
        "compare": comparison.compare,
        **_sides("published", judged.thesis.numbers),
        "published": _round(judged.thesis.difference),
        **_sides("measured", measurement.numbers if measurement else ()),
        **_interval("measured", judged),
        "corrected_low": corrected.low,
        "corrected_high": corrected.high,
        "range": "both signs" if judged.claimed is None else str(judged.claimed),
        "units": measurement.paired.units if measurement else "",
        "verdict": judged.verdict,
        "reason": judged.reason,
        "left_results": "; ".join(results[0]),
        "right_results": "; ".join(results[1]) if len(results) > 1 else "",
    }


def _sides(kind: str, numbers: Sequence[float]) -> dict[str, float]:
    left, right = [*numbers, np.nan, np.nan][:2]
    return {f"{kind}_left": _round(left), f"{kind}_right": _round(right)}


def _interval(name: str, judged: Judged) -> dict[str, float]:
    interval = judged.measurement.interval if judged.measurement else _NOTHING
    return {name: interval.estimate, "low": interval.low, "high": interval.high}


def _text(comparison: Comparison, numbers: Sequence[float], difference: float = float("nan")) -> str:
    if not np.isnan(numbers).any():
        pairs = zip(comparison.sides, numbers, strict=True)
        text = ", ".join(f"{side.label} {number:.2f}" for side, number in pairs)
        return f"{text} against {_right_label(comparison)}" if comparison.right is None else text
    return "" if np.isnan(difference) else f"{comparison.compare} {difference:.2f}"


def _right_label(comparison: Comparison) -> str:
    return comparison.right.label if comparison.right else f"{comparison.range[1]:g}"


def _round(number: float) -> float:
    return round(float(number), 2) + 0.0
