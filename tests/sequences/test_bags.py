"""Test the `bags` layout: floors, labels, and reading frames by position."""

import numpy as np
import pandas as pd
import pytest
import yaml
from helpers_sequences import coded, decoded
from made_bags import CAMERA, START, compressed, picture, string, walk, write_bag

from placecat.errors import PlacecatError
from placecat.sequences import open_home, read_frames
from placecat.stages.sequences import list_homes as stage
from project import ROOT

TOPIC = "/room"
SECOND = 10**9


def described(version=2):
    """Make label messages: kitchen after one second, and bedroom after three."""
    return [
        (TOPIC, START + SECOND, string(version, "kitchen")),
        (TOPIC, START + 3 * SECOND, string(version, " bedroom ")),
    ]


@pytest.fixture
def root(tmp_path):
    """Create a home with two floors. Floor 1 has two cameras, and its labels are in seconds."""
    depth = [
        (
            "/depth",
            START + number * SECOND,
            picture(1, START + number * SECOND, np.full((48, 64), 3, np.uint16)),
        )
        for number in range(-1, 5)
    ]
    home = tmp_path / "bags/Home1"
    walk(home / "1.bag", count=40, fps=10.0, others=depth)
    walk(home / "2", count=20, fps=10.0)
    (home / "1.csv").write_text("start_seconds,end_seconds,label\n0,2.5,kitchen\n2.5,4,bedroom\n")
    (home / "2.csv").write_text("start,end,label\n1,5,transition\n6,20,bathroom\n")
    return tmp_path / "bags"


def test_a_home_has_one_sequence_per_bag(root):
    home = open_home("bags", root, "Home1", topic=CAMERA)
    frames = home.frames
    assert frames["sequence"].tolist() == ["1"] * 40 + ["2"] * 20
    assert frames["number"].tolist() == [*range(1, 41), *range(1, 21)]
    assert frames["source"].unique().tolist() == ["Home1/1.bag", "Home1/2"]
    assert np.allclose(frames["seconds"], [*np.arange(40) / 10, *np.arange(20) / 10])
    assert frames["label"].value_counts().to_dict() == {
        "kitchen": 25,
        "bedroom": 15,
        "transition": 5,
        "bathroom": 15,
    }
    assert home.label_files == {"1": "Home1/1.csv", "2": "Home1/2.csv"}
    assert home.label_lines[[0, 25, 40]].tolist() == [2, 3, 2]
    assert (home.fps, home.width, home.height, home.note) == (pytest.approx(10), 64, 48, "")


def test_frames_can_be_read_in_any_order(root):
    frames = open_home("bags", root, "Home1", topic=CAMERA).frames
    rows = frames.iloc[[3, 39, 7, 45, 59, 0]]
    assert [decoded(image) for image in read_frames(root, rows)] == [3, 39, 7, 5, 19, 0]
    # Positions also count the frames of the other camera.
    assert frames["position"].iloc[39] > 39
    (root / "Home1/1.bag").unlink()
    walk(root / "Home1/1.bag", count=3)
    with pytest.raises(
        PlacecatError, match=r"1\.bag: frame \d+ is missing or unreadable \(the file ends after 3\)"
    ):
        list(read_frames(root, frames.iloc[[20]]))


def test_labels_from_a_topic(tmp_path):
    walk(tmp_path / "a/floor.mcap", count=40, fps=10.0, late=0, others=described())
    labels = open_home("bags", tmp_path, "a", labels_topic=TOPIC).frames["label"].tolist()
    assert labels == [""] * 10 + ["kitchen"] * 20 + ["bedroom"] * 10
    (tmp_path / "a/floor.csv").write_text("start,end,label\n1,40,kitchen\n")
    with pytest.raises(PlacecatError, match=r"a/floor\.csv and dataset\.labels_topic label the same frames"):
        open_home("bags", tmp_path, "a", labels_topic=TOPIC)
    with pytest.raises(
        PlacecatError, match=r"messages of type sensor_msgs/msg/Image, not std_msgs/msg/String"
    ):
        (tmp_path / "a/floor.csv").unlink()
        open_home("bags", tmp_path, "a", labels_topic=CAMERA)


def test_lost_frames_have_no_row_and_keep_their_labels(tmp_path):
    content = [coded(number) if number != 2 else b"rubbish" for number in range(5)]
    messages = [
        (CAMERA, START + n * SECOND, compressed(2, START + n * SECOND, one)) for n, one in enumerate(content)
    ]
    write_bag(tmp_path / "a/1.mcap", messages)
    (tmp_path / "a/1.csv").write_text("start,end,label\n1,3,kitchen\n4,5,bedroom\n")
    home = open_home("bags", tmp_path, "a")
    assert home.frames["number"].tolist() == [1, 2, 4, 5]
    assert home.frames["label"].tolist() == ["kitchen", "kitchen", "bedroom", "bedroom"]
    assert home.lost == [3] and "frame 3 of 5 cannot be decoded and is lost" in home.note
    assert [decoded(image) for image in read_frames(tmp_path, home.frames)] == [0, 1, 3, 4]


@pytest.mark.parametrize(
    ("settings", "message"),
    [
        ({}, r"1\.bag: several topics have images; choose one with dataset\.topic"),
        ({"topic": "/nowhere"}, r"no topic '/nowhere'.* Correct dataset\.topic"),
        ({"topic": 3}, r"1\.bag: there is no topic 3; the bag has .* Correct dataset\.topic"),
        ({"topic": CAMERA, "labels_topic": "/words"}, r"labels_topic label the same frames"),
    ],
)
def test_invalid_settings(root, settings, message):
    with pytest.raises(PlacecatError, match=message):
        open_home("bags", root, "Home1", **settings)


def test_invalid_homes(root, tmp_path):
    walk(root / "Home2/1.bag", count=3)
    walk(root / "Home2/2.bag", count=3, size=(32, 24))
    with pytest.raises(PlacecatError, match=r"2\.bag: the frames are 32x24, but those of 1\.bag are 64x48"):
        open_home("bags", root, "Home2")
    walk(root / "Home3/1.bag", count=3)
    walk(root / "Home3/1.mcap", count=3)
    with pytest.raises(PlacecatError, match=r"1\.mcap and 1\.bag have the same name"):
        open_home("bags", root, "Home3")
    (root / "Home4").mkdir()
    with pytest.raises(PlacecatError, match=r"Home4 contains no bag; correct dataset\.homes"):
        open_home("bags", root, "Home4")


def test_the_stage_lists_bags_with_the_settings_from_conf(root, tmp_path):
    dataset = yaml.safe_load((ROOT / "conf/dataset/bags.yaml").read_text())
    given = {"root": str(root), "homes": ["Home1"], "topic": CAMERA, "require_all_classes": False}
    assert dataset["topic"] is None and dataset["labels_topic"] is None
    stage(dataset | given, tmp_path / "listed", "dataset")
    labels = pd.read_csv(tmp_path / "listed/Home1/labels.csv")
    assert labels["class"].value_counts().to_dict() == {2: 25, 0: 15, 1: 15, -1: 5}
    sources = pd.read_csv(tmp_path / "listed/Home1/sources.csv")["source"].tolist()
    assert sources == ["Home1/1.bag", "Home1/2/2.db3", "Home1/2/metadata.yaml"]
