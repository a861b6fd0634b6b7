"""Predict from a home of a data set, with its floors and labels."""

import json

import numpy as np
import pandas as pd
import pytest
import yaml
from commands import predict, refused
from fake_categorizer import CLASSES, FakeCategorizer, expected
from helpers_sequences import write_image
from made_robot_at_home import make

from placecat.errors import PlacecatError
from placecat.evaluation.accuracy import confusion_matrix, home_accuracy
from placecat.predict import command
from placecat.predict.home import DataSetHome, data_set
from project import ROOT

FLOORS = (12, 18)
# The classes are not in the model's order. One class and one ignored label are unknown to the model.
DATASET = {
    "name": "mine",
    "title": "my homes",
    "thesis_data": None,
    "layout": "vpc2009",
    "root": "homes",
    "homes": ["Villa", "Hut"],
    "fps": 4.0,
    "camera": "mine",
    "classes": ["kitchen", "office", "bedroom", "living_room"],
    "ignored": ["corridor"],
    "aliases": {"lounge": "living_room"},
    "require_all_classes": True,
}
LABELS = (
    "1/\n12\n1 8 bedroom\n9 10 corridor\n11 12 lounge\n-1 -1 end\n"
    "2/\n18\n1 6 kitchen\n7 18 bedroom\n-1 -1 end\n-1 -1 end\n"
)
TRUTH = [*["bedroom"] * 8, *[""] * 2, *["living_room"] * 2, *["kitchen"] * 6, *["bedroom"] * 12]


class Reset(FakeCategorizer):
    """Fake system that records the number of frames seen before each restart."""

    def __init__(self):
        super().__init__()
        self.resets = []

    def reset(self):
        self.resets.append(len(self.times))


@pytest.fixture
def system(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    made = Reset()
    monkeypatch.setattr(command.Categorizer, "load", lambda path, **_: made)
    for floor, first in ((1, 0), (2, FLOORS[0])):
        for number in range(FLOORS[floor - 1]):
            write_image(tmp_path / f"homes/Villa/{floor}/{number + 1:08d}.jpg", first + number)
    (tmp_path / "homes/Villa/label.txt").write_text(LABELS)
    (tmp_path / "params.yaml").write_text(yaml.safe_dump({"dataset": DATASET}))
    return made


def test_all_floors_are_scored_together(system, tmp_path, capsys):
    predict("home:Villa")
    results = tmp_path / "predictions/Villa"
    table = pd.read_csv(results / "frames.csv")
    smoothed = np.stack([expected(number)[0] for number in range(sum(FLOORS))])
    assert np.array_equal(table[[f"p_{name}" for name in CLASSES]].to_numpy(), smoothed)
    assert table["file"][12] == "Villa/2/00000001.jpg"
    assert table["seconds"].tolist() == [number / 4 for number in range(30)]
    truth = [CLASSES.index(name) if name else -1 for name in TRUTH]
    percent = home_accuracy(confusion_matrix(truth, smoothed.argmax(axis=1), 3))
    assert json.loads((results / "summary.json").read_text())["agreement"]["accuracy"] == round(percent, 2)
    assert f"Accuracy (mean over the labelled places): {percent:.2f}%" in capsys.readouterr().out
    # The threshold keeps the first eleven decisions.
    kept = confusion_matrix(truth[:11], smoothed[:11].argmax(axis=1), 3)
    scored = np.bincount([place for place in truth if place >= 0])
    shares = kept / scored[:, None] / 3
    agreement = json.loads((results / "summary.json").read_text())["agreement"]
    assert agreement["named"] == round(100 * shares.sum(), 2)
    assert agreement["named_wrongly"] == round(100 * (1 - np.trace(shares) / shares.sum()), 2)
    # The system restarts on every floor, and nothing carries over.
    assert system.resets == [0, 12]
    assert system.times == [0.25] * 30


def test_a_change_of_floor_ends_a_stay(system, tmp_path):
    system.threshold = 0.0
    predict("home:Villa")
    visits = pd.read_csv(tmp_path / "predictions/Villa/visits.csv")
    # Otherwise the second stay would end at frame 16.
    assert visits["frames"].tolist() == [8, 4, 4, 8, 6]
    assert visits["place"].tolist() == ["bedroom", "living_room", "living_room", "kitchen", "bedroom"]
    assert visits["end_seconds"].tolist() == [2.0, 3.0, 4.0, 6.0, 7.5]


def test_every_nth_frame_is_counted_on_each_floor(system, tmp_path):
    predict("home:Villa", "--every", "5")
    assert pd.read_csv(tmp_path / "predictions/Villa/frames.csv")["frame"].tolist() == [
        1,
        6,
        11,
        13,
        18,
        23,
        28,
    ]
    assert system.resets == [0, 3]


def test_classes_unknown_to_the_model_are_rejected_or_ignored(system, tmp_path, capsys):
    labels = tmp_path / "homes/Villa/label.txt"
    labels.write_text(LABELS.replace("7 18 bedroom", "7 18 office"))
    text = refused("home:Villa")
    places = "bedroom, living_room, kitchen"
    assert f"Villa: the label 'office' is not one of the model's places ({places})" in text
    assert "--ignore office" in text
    predict("home:Villa", "--ignore", "office")
    assert "correct" in capsys.readouterr().out


def test_a_training_home_of_the_model_is_noted(system, tmp_path, capsys):
    note = "the model was trained on Villa, so this accuracy says nothing about new homes"
    # Neither a home with this name in another data set nor another home in this data set counts.
    for title, homes in (("other homes", ["Villa"]), ("my homes", ["Hut"]), ("my homes", ["Hut", "Villa"])):
        system.card["data"] |= {"title": title, "homes": homes}
        predict("home:Villa")
        told = json.loads((tmp_path / "predictions/Villa/summary.json").read_text())["notes"]
        expected_note = title == "my homes" and "Villa" in homes
        assert any(one.startswith(note) for one in told) == expected_note
        assert (f"note: {note}; `placecat train --without Villa`" in capsys.readouterr().err) == expected_note


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["home:Palace"], "home:Palace: my homes has no such home: use one of Villa, Hut"),
        (["home:Hut"], "Hut"),
        (["home:"], "home: needs the name of a home: use one of Villa, Hut"),
        (["home:Villa", "--labels", "x.csv"], "--labels cannot be used with data sets"),
        (["homes/Villa/1", "--set", "dataset=homes"], "--set chooses the data set for home:NAME"),
    ],
)
def test_user_errors_give_one_message(system, tmp_path, arguments, message):
    text = refused(*arguments)
    assert message in text and len(text.splitlines()) == 1
    assert not (tmp_path / "predictions").exists()


def test_overrides_select_another_data_set(monkeypatch):
    monkeypatch.chdir(ROOT)
    assert data_set([])["name"] == "homes"
    chosen = data_set(["dataset=my_homes", "dataset.root=far", "dataset.homes=[Villa]"])
    assert (chosen["layout"], chosen["root"], chosen["homes"]) == ("vpc2009", "far", ["Villa"])
    with pytest.raises(PlacecatError, match="rooot"):
        data_set(["dataset.rooot=far"])


def test_a_layout_receives_its_settings(tmp_path):
    """The layout receives the camera, turn and observations, as in the `sequences` stage."""
    seen = make(tmp_path / "robot", lambda home, room, number: np.full((6, 8, 3), number % 256, np.uint8))
    dataset = yaml.safe_load((ROOT / "conf/dataset/robot_at_home.yaml").read_text())
    chosen = {
        "root": str(tmp_path / "robot"),
        "camera": {"alma": "RGBD_2"},
        "turn": 90,
        "observations": "all",
    }
    source = DataSetHome("alma", dataset | chosen, None)
    with pytest.raises(
        PlacecatError, match=r"dataset\.camera lists no camera for alma: add dataset\.camera\.alma"
    ):
        DataSetHome("alma", dataset | chosen | {"camera": {"anto": "RGBD_2"}}, None)
    images = [frame.image for frame in source.frames(1)]
    expected_numbers = [
        number for number, one in enumerate(seen) if (one.home, one.camera) == ("alma", "RGBD_2")
    ]
    assert [int(image[0, 0, 0]) for image in images] == [number % 256 for number in expected_numbers]
    assert source.size == (6, 8) and {image.shape for image in images} == {(8, 6, 3)}
