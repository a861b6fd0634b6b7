"""A short campaign: no damaged input ends in a traceback, and a stopped campaign resumes."""

import collections

import damaged_inputs
import numpy as np
import pandas as pd
import pytest

import campaign

FEW = 25
# In formats without checksums, damage can be undetectable and produce other valid images.
UNSEEN = {"pictures", "videos"}


@pytest.mark.parametrize("part", list(damaged_inputs.KINDS))
def test_damaged_inputs_end_in_a_message_or_the_intact_result(part, tmp_path):
    kind = damaged_inputs.KINDS[part](tmp_path / part)
    found = [kind.attempt(np.random.default_rng([1, number])) for number in range(FEW)]
    counts = collections.Counter(outcome for outcome, _ in found)
    allowed = {damaged_inputs.RIGHT, damaged_inputs.MESSAGE} | (
        {damaged_inputs.WRONG} if part in UNSEEN else set()
    )
    assert set(counts) <= allowed, [one for one in found if one[0] not in allowed]
    assert counts[damaged_inputs.MESSAGE] > FEW / 2


@pytest.mark.slow
def test_a_campaign_resumes_where_it_stopped(tmp_path):
    cases, report = tmp_path / "cases.csv", tmp_path / "counts.csv"
    given = ["--parts", "labels", "--cases", str(cases), "--report", str(report), "--seconds", "60", "--most"]
    campaign.main([*given, "3"])
    first = pd.read_csv(cases)
    campaign.main([*given, "5"])
    both = pd.read_csv(cases)
    assert both["number"].tolist() == [0, 1, 2, 3, 4]
    pd.testing.assert_frame_equal(both.head(3), first)
    (row,) = pd.read_csv(report).to_dict("records")
    assert (row["part"], row["tried"]) == ("labels", 5)
