import numpy as np
import pandas as pd

from made_report import cells
from placecat.report.summary import best_system, count_verdicts, headlines, judged_together
from project import ROOT


def test_headlines_of_published_numbers_match_the_thesis():
    first, second, third = headlines(cells(26))
    assert (first.group, first.best, first.cue.measured) == ("4-5-1, all cues", "Centrist", "42.71")
    assert (first.integration.published, first.smoothed.published) == ("42.29", "45.53")
    assert (second.best_published, second.cue.published) == ("Centrist", "43.99")
    assert (second.integration.measured, second.smoothed.measured) == ("45.71", "47.53")
    assert (third.best, third.cue.measured) == ("", "")
    assert (third.integration.measured, third.smoothed.measured) == ("46.50", "47.68")


def test_the_best_cue_may_differ_from_the_published_one():
    table = cells(26)
    hog = (
        (table["group"] == "5-5-1, all cues")
        & (table["row"] == "HOG + y-Pos")
        & (table["column"] == "Average")
    )
    table.loc[hog, "measured"] = 60.0
    table.loc[table["row"] == "Integration", "measured"] = np.nan
    second = headlines(table)[1]
    assert (second.best, second.best_published) == ("HOG + y-Pos", "Centrist")
    assert second.cue.difference == 16.01
    assert (second.integration.measured, second.integration.published) == ("", "45.71")


def test_all_verdicts_are_counted():
    findings = pd.DataFrame({"verdict": ["holds", "undecided", "holds"]})
    assert count_verdicts(findings) == {"holds": 2, "does not hold": 0, "undecided": 1}


def test_only_finding_23_is_judged_from_the_cases_of_all_comparisons():
    assert judged_together(pd.read_csv(ROOT / "reports/findings_comparisons.csv")) == {23}


def test_the_best_system_is_the_highest_average_that_was_measured():
    table = cells(26)
    best = best_system(table)
    assert (best["group"], best["row"], best["cell"].measured) == (
        "5-5-1, HOG+SIFT+Centrist+Gist+holistic Centrist",
        "HMM",
        "47.68",
    )
    table.loc[table["row"] == "HMM", "measured"] = np.nan
    assert best_system(table)["row"] == "Integration"
    assert best_system(table.assign(measured=np.nan)) is None
