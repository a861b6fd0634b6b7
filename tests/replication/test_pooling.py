"""Splitting homes into groups, and judging the findings on the homes of all groups."""

import numpy as np
import pandas as pd
import pytest
from made_groups import HOMES
from scipy import stats

import made_results
from placecat.evaluation.verdict import HOLDS
from placecat.replication import group_results, groups, options, pooling
from placecat.thesis import definitions
from placecat.thesis.published import Published


def test_homes_too_few_for_a_group_are_returned():
    dataset = made_results.PARAMS["dataset"] | {"homes": [*HOMES, "attic"]}
    planned, rest = groups.split({"dataset": dataset}, 6)
    assert [group.homes for group in planned] == [tuple(HOMES[:6]), tuple(HOMES[6:])]
    assert rest == ("attic",)


def test_a_setting_with_a_value_for_each_home_keeps_those_of_the_group():
    dataset = made_results.PARAMS["dataset"] | {"homes": HOMES, "camera": {home: home[-1] for home in HOMES}}
    first, second = groups.split({"dataset": dataset}, 6)[0]
    assert list(second.params["dataset"]["camera"]) == list(second.homes) == HOMES[6:]
    assert first.params["dataset"]["aliases"] == {}


def test_a_clear_difference_holds_on_many_homes():
    """24 homes are enough to decide a difference of 5 points if homes have a standard deviation of 3."""
    homes = [f"home_{number}" for number in range(1, 25)]
    params = made_results.PARAMS | {"dataset": made_results.PARAMS["dataset"] | {"homes": homes}}
    results = made_results.made(params)
    rng = np.random.default_rng(0)
    # Each place has 100 frames; these are the numbers of correct ones.
    gained = rng.normal(5.0, 3.0, 24).round().astype(int)
    for name, right in (
        ("cues/gist_naive_bayes/5-5-1", 60 + gained),
        ("trials/gist_without_color/||", np.full(24, 60)),
    ):
        one = results.measured[name]
        one.confusion[:] = 0
        for home, count in enumerate(right):
            one.confusion[:, home] = np.eye(5, dtype=int) * count + np.roll(
                np.eye(5, dtype=int), 1, axis=1
            ) * (100 - count)
    findings = {"finding_06": definitions.findings(made_results.ROOT)["finding_06"]}
    findings["finding_06"] = findings["finding_06"] | {
        "comparisons": [one | {"range": "better"} for one in findings["finding_06"]["comparisons"]]
    }
    parts = [homes[first : first + 6] for first in range(0, 24, 6)]
    rows, details = pooling.judge(
        findings,
        made_results.PARAMS["verdict"],
        options.Options(group=6, level=0.98, shared=0.1),
        results,
        made_published(),
        parts,
    )
    assert rows["verdict"].item() == HOLDS
    assert rows["difference"].item() == pytest.approx(gained.mean(), abs=0.006)
    assert details["shared"].item() == pytest.approx(_icc(gained.reshape(4, 6)), abs=0.006)


def _icc(table):
    """Compute the intraclass correlation from SciPy's analysis of variance, in which F = B / W."""
    f = stats.f_oneway(*table).statistic
    return (f - 1.0) / (f + table.shape[1] - 1.0)


def made_published():
    text = dict.fromkeys(("name", "section", "quantity", "home", "quote"), str)
    read = pd.read_csv(made_results.ROOT / "data/thesis/published_text.csv", dtype=text).fillna(
        dict.fromkeys(text, "")
    )
    return Published(made_results.published(), read)


def test_results_from_homes_are_recognized():
    assert group_results.is_of_homes("trials/table_03/gamma=1.0||0.1")
    assert not group_results.is_of_homes("splits/university/hmm/five")
