"""The ledger of the project's own findings, which are read from their files."""

import dataclasses
import re

import numpy as np
import pandas as pd
import pytest
from made_accuracies import measured
from made_accuracies import results as some_results

import made_results
from placecat.errors import PlacecatError
from placecat.evaluation.verdict import FAILS, HOLDS, UNDECIDED
from placecat.results.measured import Results
from placecat.settings import read_yaml
from placecat.thesis.claims import read_finding
from placecat.thesis.findings import ledger
from placecat.thesis.judging import look_up
from placecat.thesis.published import Published
from placecat.thesis.rules import Rules, claimed_range

CONF = made_results.ROOT / "conf"
FILES = sorted((made_results.ROOT / "data/thesis/findings").glob("*.yaml"))
CONFIGS = {path.stem: read_yaml(path) for path in FILES}
FINDINGS = {name: read_finding(name, config) for name, config in CONFIGS.items()}
VERDICT = read_yaml(CONF / "verdict/bootstrap.yaml")
PUBLISHED = Published(made_results.published(), made_results.published_text())
RESULTS = made_results.made()
QUICK = VERDICT | {"resamples": 300}


def results_of(finding):
    return {name for one in finding.comparisons for side in one.sides for name in side.results}


def test_there_are_34_findings():
    assert [one.number for one in FINDINGS.values()] == list(range(1, 35))
    assert list(FINDINGS) == [f"finding_{one.number:02d}" for one in FINDINGS.values()]


@pytest.mark.parametrize("name", FINDINGS)
def test_a_finding_uses_results_that_a_run_has(name):
    assert results_of(FINDINGS[name]) <= set(RESULTS.measured)


@pytest.mark.parametrize("name", FINDINGS)
def test_the_published_numbers_support_the_claims(name):
    """No comparison has its sides swapped, and each range contains the published difference."""
    for comparison in FINDINGS[name].comparisons:
        thesis = look_up(comparison, PUBLISHED, comparison.sides)
        claimed = claimed_range(comparison.range, thesis.difference, Rules(**VERDICT))
        if claimed is not None and not np.isnan(thesis.difference):
            assert claimed.low < thesis.difference < claimed.high, comparison


def test_only_three_claims_have_no_published_numbers():
    without = {
        finding.number
        for finding in FINDINGS.values()
        if all(np.isnan(look_up(one, PUBLISHED, one.sides).difference) for one in finding.comparisons)
    }
    assert without == {31, 32, 34}


def test_smoothing_hurts_and_helps_in_the_thesis():
    (own, university, robot) = (
        look_up(one, PUBLISHED, one.sides).difference for one in FINDINGS["finding_23"].comparisons
    )
    assert own > 1 and university > 1
    assert robot < -1


@pytest.fixture(scope="module")
def judged():
    return ledger(CONFIGS, QUICK, RESULTS, PUBLISHED)[:2]


def test_the_ledger_has_one_row_per_finding_and_per_comparison(judged):
    findings, comparisons = judged
    assert findings["number"].tolist() == list(range(1, 35))
    assert findings["claim"].tolist() == [one.claim for one in FINDINGS.values()]
    assert set(findings["verdict"]) <= {HOLDS, FAILS, UNDECIDED}
    assert (findings["reason"].str.len() > 0).all()
    assert (findings["measured"].str.len() > 0).all()
    expected = [
        (one.number, reading)
        for one in FINDINGS.values()
        for reading in ("", *one.readings)
        for _ in one.comparisons
    ]
    assert list(comparisons[["finding", "reading"]].itertuples(index=False, name=None)) == expected


def test_findings_on_knn_are_also_judged_as_printed(judged):
    findings, comparisons = judged
    printed = findings[findings["verdict_as_printed"] != ""]
    assert printed["number"].tolist() == [11, 12, 13, 14, 15, 16, 18]
    assert set(printed["verdict_as_printed"]) <= {HOLDS, FAILS, UNDECIDED}
    assert findings.loc[findings["verdict_tenth"] != "", "number"].tolist() == [24]
    used, other = (
        comparisons[(comparisons["finding"] == 14) & (comparisons["reading"] == reading)]
        for reading in ("", "as_printed")
    )
    assert other["left_results"].tolist() == [
        name.replace("table_11", "table_11_printed") for name in used["left_results"]
    ]
    assert other["published"].tolist() == used["published"].tolist()
    assert other["measured"].tolist() != used["measured"].tolist()


def test_the_reason_says_how_many_frames_the_filter_drops(judged):
    reason = judged[0].set_index("number").loc[24, "reason"]
    assert "the threshold 0.10000 drops 25% of the labelled frames" in reason


def test_published_and_measured_numbers_come_from_the_same_cell():
    """Without 496 and 991 clusters, the measurement at 196 is compared with the thesis's number at 196."""
    names = [f"trials/table_04/Naive Bayes||{number}" for number in (496, 991)]
    there = {name: one for name, one in RESULTS.measured.items() if name not in names}
    reasons = {(name, home): "too few frames" for name in names for home in RESULTS.homes}
    lacking = dataclasses.replace(RESULTS, measured=there, missing=reasons)
    _, comparisons, _ = ledger({"finding_05": CONFIGS["finding_05"]}, QUICK, lacking, PUBLISHED)
    row = comparisons.iloc[1]
    assert row["right_results"] == "trials/table_04/Naive Bayes||196"
    assert row["published_right"] == PUBLISHED.of_trial(row["right_results"])
    assert "most clusters without 496, 991, which this data does not allow" in row["reason"]


def test_the_university_is_pooled_as_in_its_table(judged):
    comparisons = judged[1]
    row = comparisons[comparisons["finding"] == 29].iloc[0]
    (name,) = row["left_results"].split("; ")
    assert row["units"] == f"{len(RESULTS.stays[name].homes)} stays"
    assert row["measured_left"] == pytest.approx(RESULTS.stays[name].pooled().by_home().mean(), abs=0.005)


def test_intervals_contain_the_measurements(judged):
    for table, name in zip(judged, ("difference", "measured"), strict=True):
        known = table.dropna(subset=["low"])
        assert len(known) > len(table) / 2
        assert (known["low"] <= known[name]).all()
        assert (known[name] <= known["high"]).all()


def test_few_units_decide_nothing(judged):
    _, comparisons = judged
    few = comparisons[comparisons["units"].isin(["2 homes", "1 home", "1 home x 2 seeds"])]
    assert len(few) > 4
    assert set(few[few["range"] != "both signs"]["verdict"]) == {UNDECIDED}


def test_the_ledger_is_deterministic_and_ignores_order(judged):
    again = ledger(dict(reversed(CONFIGS.items())), QUICK, RESULTS, PUBLISHED)[:2]
    for one, other in zip(judged, again, strict=True):
        pd.testing.assert_frame_equal(one, other)


@pytest.mark.parametrize("missing", ["nothing measured", "one home", "reasons"])
def test_missing_measurements_are_undecided_with_a_reason(missing):
    if missing == "one home":
        measured = {
            name: dataclasses.replace(one, homes=one.homes[:1], confusion=one.confusion[:, :1])
            for name, one in RESULTS.measured.items()
        }
        lacking = Results(RESULTS.homes, RESULTS.classes, measured, {})
    else:
        names = RESULTS.measured if missing == "reasons" else ()
        reasons = {(name, "home_1"): "too few frames" for name in names}
        lacking = Results(RESULTS.homes, RESULTS.classes, {}, reasons)
    findings, comparisons, _ = ledger(CONFIGS, QUICK, lacking, PUBLISHED)
    assert set(findings["verdict"]) == {UNDECIDED}
    words = {
        "one home": "too few|no home has|no stays",
        "reasons": "too few frames",
        "nothing measured": "no result",
    }
    assert comparisons["reason"].str.contains(words[missing]).all()
    assert findings["reason"].str.contains(words[missing]).all()


def test_a_finding_shows_its_deciding_comparison():
    homes = np.array([30.0, 45.0, 38.0, 51.0, 27.0, 42.0])
    gains = {"clear": [9, 8, 9, 9, 8, 9], "close": [3, 2, 3, 3, 2, 3], "open": [9, -8, 9, -8, 9, -8]}
    gains["wrong"] = [-9, -8, -9, -9, -8, -9]
    named = {name: measured(homes + gain) for name, gain in gains.items()} | {"base": measured(homes)}

    def row(*lefts):
        right = {"label": "base", "result": "base"}
        own = [{"left": {"label": one, "result": one}, "right": right, "range": "better"} for one in lefts]
        config = {"number": 1, "section": "1", "claim": "A claim.", "comparisons": own}
        findings, _, _ = ledger({"f": config}, QUICK, some_results(**named), PUBLISHED)
        return findings.iloc[0]

    both = row("clear", "close")
    assert both["verdict"] == HOLDS
    assert both["measured"] == "close 41.50, base 38.83"
    assert both["difference"] == 2.67
    assert re.match(
        r"2 comparisons: holds 2, allowing for 2 comparisons \(Bonferroni: 97.5% intervals\); "
        "shown: close against base; the whole",
        both["reason"],
    )
    assert row("clear", "open")[["verdict", "measured"]].tolist() == [UNDECIDED, "open 39.33, base 38.83"]
    assert row("absent", "open")["measured"] == "open 39.33, base 38.83"
    assert row("clear", "open", "wrong", "absent")["verdict"] == FAILS
    assert row("clear", "absent")[["verdict", "measured"]].tolist() == [UNDECIDED, ""]
    assert row("clear")["reason"] == "the whole interval is above 0"


def test_unknown_rules_are_rejected():
    with pytest.raises(PlacecatError, match="verdict has no setting 'levl'; did you mean 'level'"):
        ledger(CONFIGS, VERDICT | {"levl": 0.9}, RESULTS, PUBLISHED)
