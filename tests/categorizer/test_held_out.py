"""Decisions in unseen homes, on synthetic outputs of the stage `features`."""

import copy
import json

import numpy as np
import pytest
from made_features import CLASSES, HOMES, PARAMS, make
from made_system import make_system

from placecat.categorizer import Categorizer, checks, held_out
from placecat.categorizer.card import unknown_text
from placecat.categorizer.train import measured
from placecat.evaluation.accuracy import confusion_matrix, home_accuracy
from placecat.sequences import listing

SYSTEM = "das"
OUT = "H2"


def small():
    """Return settings with one system of two cues, and with one seed."""
    params = copy.deepcopy(PARAMS)
    params["protocol"]["seeds"] = [0]
    params["systems"] = {SYSTEM: params["systems"][SYSTEM]}
    names = params["systems"][SYSTEM]["cues"]
    params["cues"] = {name: params["cues"][name] | {"schemes": ["5-5-1"], "extra": False} for name in names}
    params["codebooks"] = {"hog_y": params["codebooks"]["hog_y"] | {"schemes": ["5-5-1"]}}
    params["smoothing"] |= {"cues": [], "filtered": []}
    return params


@pytest.fixture(scope="module")
def project(tmp_path_factory):
    from placecat.stages import codebooks, cues, integration, smoothing

    folder = tmp_path_factory.mktemp("project")
    make(folder, params=small())
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(folder)
        patch.setenv("PLACECAT_WORKERS", "1")
        for stage in (codebooks, cues, integration, smoothing):
            stage.main()
    return folder


@pytest.fixture(autouse=True)
def inside(project, monkeypatch):
    monkeypatch.chdir(project)
    monkeypatch.setenv("PLACECAT_WORKERS", "1")


@pytest.mark.slow
def test_training_without_each_home_reproduces_the_stages_exactly():
    trained = held_out.by_training(small(), SYSTEM, [], 0)
    left = held_out.of_stages(small(), SYSTEM, 0)
    assert list(trained) == list(left) == HOMES
    for home in HOMES:
        np.testing.assert_array_equal(trained[home], left[home])


def test_left_out_homes_do_not_affect_the_measurements(project, tmp_path, monkeypatch):
    plain = held_out.by_training(small(), SYSTEM, [OUT], 0)
    make(tmp_path, marked=OUT, params=small())
    monkeypatch.chdir(tmp_path)
    marked = held_out.by_training(small(), SYSTEM, [OUT], 0)
    assert list(plain) == list(marked) == [home for home in HOMES if home != OUT]
    for home in plain:
        np.testing.assert_array_equal(plain[home], marked[home])
    own = listing.read_labels(OUT)
    monkeypatch.chdir(project)
    assert not np.array_equal(own, listing.read_labels(OUT))


def test_nothing_is_measured_with_too_few_training_homes():
    nothing = held_out.by_training(small(), SYSTEM, HOMES[:2], 0)
    assert (nothing, held_out.accuracies(nothing)) == ({}, {})
    assert held_out.unknown(nothing, 0.1, []) is None


def test_only_test_homes_are_measured():
    params = small()
    params["protocol"]["test_homes"] = ["H3"]
    left = held_out.of_stages(params, SYSTEM, 0)
    assert list(left) == ["H3"]
    # At least two homes are needed to measure a threshold.
    assert held_out.unknown(left, 0.1, []) is None


def test_the_card_has_the_accuracy_and_the_risks():
    left = held_out.of_stages(small(), SYSTEM, 0)
    for home, percent in held_out.accuracies(left).items():
        truth, places = listing.read_labels(home), left[home].argmax(axis=1)
        assert percent == round(home_accuracy(confusion_matrix(truth, places, len(CLASSES))), 2)
    found = held_out.unknown(left, 0.05, [0.3, 0.05, 0.9])
    assert [row["risk"] for row in found["measured"]] == [0.05, 0.3, 0.9]
    assert found["threshold"] == found["measured"][0]["threshold"]
    # If more errors are allowed, more frames are named. If 90% may be wrong, every frame is named.
    thresholds = [row["threshold"] for row in found["measured"]]
    assert thresholds == sorted(thresholds, reverse=True)
    lowest = min(left[home].max(axis=1)[listing.read_labels(home) >= 0].min() for home in HOMES)
    assert thresholds[-1] == lowest
    assert found["measured"][0]["coverage"] < found["measured"][-1]["coverage"] <= 1


def test_a_risk_that_no_confidence_reaches():
    # All decisions are wrong.
    wrong = {home: np.eye(len(CLASSES))[(listing.read_labels(home) + 1) % len(CLASSES)] for home in HOMES}
    found = held_out.unknown(wrong, 0.1, [])
    assert found == {
        "risk": 0.1,
        "threshold": None,
        "measured": [{"risk": 0.1, "threshold": None, "coverage": 0.0, "wrong": None, "worst": None}],
    }


def test_measurements_are_in_the_card_and_set_the_threshold():
    params = small() | {"model": {"risk": 0.4, "risks_shown": [0.1]}}
    left = held_out.of_stages(params, SYSTEM, 0)
    system = measured(make_system(), params, left)
    checks.check_card(json.loads(json.dumps(system.card)))
    assert system.card["accuracy"] == held_out.accuracies(left)
    assert [row["risk"] for row in system.card["unknown"]["measured"]] == [0.1, 0.4]
    assert Categorizer(system).threshold == system.card["unknown"]["threshold"]
    nothing = measured(make_system(), params, {})
    checks.check_card(json.loads(json.dumps(nothing.card)))
    assert (nothing.card["accuracy"], Categorizer(nothing).threshold) == ({}, 0.0)
    assert unknown_text(nothing.card).startswith("It never says `unknown`")
