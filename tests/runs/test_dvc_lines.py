"""How `placecat repro` changes the lines that DVC prints."""

import logging

import pytest

from placecat.runs.dvc import _Left


def said(left, text):
    record = logging.LogRecord("dvc", logging.INFO, "", 0, text, (), None)
    return record.getMessage() if left.filter(record) and left.filter(record) else None


def test_a_stage_line_shows_the_number_and_the_time_left():
    left = _Left(["features", "cues", "report"], {"features": 600.0, "cues": 60.0, "report": 9.0})
    assert said(left, "Running stage 'features':") == "Running stage 'features': 1 of 3, at most 11 min left"
    assert said(left, "Stage 'cues' didn't change, skipping") == "Stage 'cues' didn't change, skipping"
    assert said(left, "Running stage 'report':") == "Running stage 'report': 3 of 3, at most 9 s left"


@pytest.mark.parametrize(
    "text",
    [
        "Stage 'render' is frozen. Its dependencies are not going to be",
        "Verifying outputs in frozen stage: 'a'",
    ],
)
def test_messages_about_frozen_stages_are_hidden(text):
    assert said(_Left([], {}), text) is None
