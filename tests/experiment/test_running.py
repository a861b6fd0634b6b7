"""An experiment reproduces the numbers of the tables and learns nothing from its test home."""

import json
import math
import shutil
from dataclasses import replace

import numpy as np
import pandas as pd
import pytest
from made_experiments import SMALL, make_project, resolved
from made_features import CLASSES, HOMES, PARAMS

from placecat import paths, settings
from placecat.evaluation.accuracy import confusion_matrix, home_accuracy
from placecat.experiment.running import compute, made_from
from placecat.results.measured import from_scores
from placecat.results.sources import sources
from placecat.training import fold_file

PROBABILITIES = PARAMS["probabilities"]
QUALITIES = ("log_loss", "calibration_error")
GIST = ("descriptor=gist", "classifier=knn", "codebook.tree.branching=4")


def confusion(result, home, seed, fold=None):
    return np.array(result["homes"][home]["folds"][fold or home][seed]["confusion"])


def by_hand(labels, proba):
    """Compute log-loss and calibration error on the labelled frames of one home, by place and by bin."""
    losses, of_bin = [], {}
    places = sorted(set(labels) - {-1})
    for place in places:
        own = proba[labels == place]
        losses.append(np.mean([-math.log(max(row[place], PROBABILITIES["smallest"])) for row in own]))
        for row in own:
            number = math.ceil(max(row) * PROBABILITIES["bins"])
            is_right = row.argmax() == place
            of_bin.setdefault(number, []).append((is_right - max(row)) / len(own))
    return np.mean(losses), 100 * sum(abs(sum(gaps)) for gaps in of_bin.values()) / len(places)


def test_an_experiment_equals_the_cell_of_a_table(tmp_path, monkeypatch):
    from placecat.stages import trials

    monkeypatch.chdir(make_project(tmp_path / "project"))
    monkeypatch.setenv("PLACECAT_WORKERS", "1")
    trials.main()
    scores, missing = (pd.read_csv(f"data/trials/some/{name}.csv") for name in ("scores", "missing"))
    table = from_scores(scores, missing, HOMES, CLASSES)
    for clusters in (4, 13):
        found = compute(resolved(*GIST, f"classifier.clusters={clusters}", "test_home=[h1,h3]"))
        cell = table.of(f"trials/table_01/||{clusters}")
        for number, home in enumerate(cell.homes):
            for seed, counts in zip(cell.seeds, cell.confusion, strict=True):
                np.testing.assert_array_equal(confusion(found, home, seed), counts[number])
        assert found["accuracy"] == pytest.approx(cell.by_home().mean(), abs=1e-12)
    too_many = compute(resolved(*GIST, "classifier.clusters=400", "test_home=h1"))
    assert [too_many[name] for name in ("accuracy", *QUALITIES)] == [None] * 3
    assert too_many["reason"] == missing.set_index("home").loc["H1", "reason"]
    svm = compute(
        resolved("descriptor=gist", "classifier=nu_svm", "classifier.reduction={cells: 4, components: 3}")
    )
    for number, home in enumerate(HOMES):
        cell = table.of("trials/table_02/|PCA|").confusion[0, number]
        np.testing.assert_array_equal(confusion(svm, home, "no-seed"), cell)


def test_an_experiment_on_a_split_equals_the_cue_of_that_split(tmp_path, monkeypatch):
    """The experiment and the cue agree in decisions, log-loss and calibration error."""
    from placecat.stages import scores, splits

    monkeypatch.chdir(make_project(tmp_path / "project"))
    monkeypatch.setenv("PLACECAT_WORKERS", "1")
    splits.main()
    found = compute(resolved(*SMALL, "descriptor=hog", "descriptor.color=color_mv", data="site"))
    labels = pd.read_csv("data/site_sequences/site/robot/labels.csv")["class"].to_numpy()
    assert -1 in labels
    source = sources(settings.load())["splits/site/cues/hog_y"]
    _, of_stage = scores.measure(source, PROBABILITIES)
    of_seeds = []
    for number, seed in enumerate(("seed-0", "seed-1")):
        proba = fold_file.read(paths.SPLITS / f"site/cues/hog_y/robot.{seed}.npz", "test")
        expected = confusion_matrix(labels, proba.argmax(axis=1), 4)
        np.testing.assert_array_equal(confusion(found, "robot", seed), expected)
        own = found["homes"]["robot"]["folds"]["robot"][seed]
        of_seeds.append([own["log_loss"], own["calibration_error"]])
        assert of_seeds[-1] == pytest.approx(by_hand(labels, proba), abs=1e-6)
        assert of_seeds[-1] == [round(of_stage.values[name][number, 0], 6) for name in QUALITIES]
    assert of_seeds[0] != of_seeds[1]
    for part in (found, found["homes"]["robot"]):
        assert [part[name] for name in QUALITIES] == pytest.approx(np.mean(of_seeds, axis=0))
    assert (
        of_stage.averages().items()
        >= {
            "log_loss": round(found["log_loss"], 3),
            "calibration_error": round(found["calibration_error"], 2),
        }.items()
    )


@pytest.mark.slow
def test_training_homes_are_judged_without_the_test_home(tmp_path, monkeypatch):
    """Marking or removing the test home changes nothing, but the marker has an effect in a training home."""
    found = {}
    for name, marked, home in (
        ("plain", None, "H3"),
        ("marked", "H3", "H3"),
        ("gone", None, "H3"),
        ("other", None, "H1"),
        ("other marked", "H3", "H1"),
    ):
        folder = make_project(tmp_path / name, marked=marked)
        monkeypatch.chdir(folder)
        if name == "gone":
            shutil.rmtree(folder / "data/features/H3")
            shutil.rmtree(folder / "data/sequences/H3")
        found[name] = compute(resolved(*SMALL, "judge=training_homes", f"test_home={home}"))
    assert set(found["plain"]["homes"]["H3"]["folds"]) == {"H1", "H2", "H4"}
    assert json.dumps(found["plain"]) == json.dumps(found["marked"]) == json.dumps(found["gone"])
    assert found["other"] != found["other marked"]
    accuracies = [
        home_accuracy(confusion(found["plain"], "H3", seed, fold))
        for fold in ("H1", "H2", "H4")
        for seed in ("seed-0", "seed-1")
    ]
    assert found["plain"]["accuracy"] == pytest.approx(np.mean(accuracies))
    folds = [own for fold in found["plain"]["homes"]["H3"]["folds"].values() for own in fold.values()]
    for name in QUALITIES:
        assert found["plain"][name] == pytest.approx(np.mean([own[name] for own in folds]))


def test_settings_of_probabilities_are_part_of_the_result(project):
    """If these settings change, a resumed sweep computes its results again."""
    one = resolved(*SMALL)
    other = replace(one, probabilities={"bins": 2, "smallest": 0.2})
    assert made_from(one) != made_from(other)
    found, changed = (compute(experiment) for experiment in (one, other))
    assert found["accuracy"] == changed["accuracy"]
    for name in QUALITIES:
        homes = [home[name] for home in found["homes"].values()]
        assert len(homes) == len(HOMES)
        assert found[name] == pytest.approx(np.mean(homes))
        assert found[name] != changed[name]


def test_number_format_does_not_change_the_experiment(project):
    """The seed for clustering is derived from the text of the descriptor."""
    one, other = (
        compute(resolved(*SMALL, f"descriptor.y_weight={weight}", "test_home=H1")) for weight in ("1", "1.0")
    )
    assert json.dumps(one) == json.dumps(other)
