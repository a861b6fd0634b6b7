import numpy as np
import pytest
import yaml
from clips import steady, write_clip, zero
from made_robot_at_home import make
from test_cold import write_sequence

from placecat import files
from placecat.errors import PlacecatError
from placecat.footage.frames import read_frames
from placecat.sequences import listing
from placecat.stages import sequences
from placecat.training.integration import training_walks
from placecat.training.plan import Part
from project import ROOT
from sketch import draw_homes

CLASSES = ["bedroom", "bathroom", "kitchen", "living_room", "dining_room"]


@pytest.fixture
def dataset(tmp_path, monkeypatch):
    """Settings for two small homes in the current folder."""
    draw_homes(tmp_path / "homes", homes=2, frames_per_room=2, width=64, height=36)
    monkeypatch.chdir(tmp_path)
    return {
        "layout": "vpc2009",
        "root": "homes",
        "homes": ["Home1", "Home2"],
        "fps": 5.0,
        "camera": "one",
        "classes": CLASSES,
        "ignored": ["transition", "corridor"],
        "aliases": {},
        "require_all_classes": True,
    }


def cameras(folder, dataset):
    (folder / "params.yaml").write_text(yaml.safe_dump({"dataset": dataset}))
    sequences.main()
    return [
        files.read_json(folder / f"data/sequences/{home}/home.json")["camera"] for home in dataset["homes"]
    ]


def test_one_camera_for_all_homes_or_one_per_home(tmp_path, dataset):
    assert cameras(tmp_path, dataset) == ["one", "one"]
    assert cameras(tmp_path, dataset | {"camera": {"Home2": "two", "Home1": "one"}}) == ["one", "two"]


def test_a_home_without_a_camera_is_reported_and_nothing_is_written(tmp_path, dataset):
    with pytest.raises(PlacecatError, match=r"lists no camera for Home2: add dataset\.camera\.Home2"):
        cameras(tmp_path, dataset | {"camera": {"Home1": "one"}})
    assert not (tmp_path / "data/sequences").exists()


def test_missing_frames_of_a_video_are_reported_and_recorded(tmp_path, dataset, capsys):
    path = write_clip(tmp_path / "films/one.mp4", steady(30), options={"g": "1000", "bf": "0"})
    write_clip(tmp_path / "films/two.mp4", steady(30))
    for name in ("one", "two"):
        (tmp_path / f"films/{name}.csv").write_text("start,end,label\n1,30,kitchen\n")
    zero(path, 21)
    chosen = {"layout": "video", "root": "films", "homes": ["one", "two"], "fps": None}
    cameras(tmp_path, dataset | chosen | {"require_all_classes": False})
    assert "placecat: note: films/one.mp4: frame 21 of 30 cannot be decoded" in capsys.readouterr().err
    facts = [files.read_json(tmp_path / f"data/sequences/{name}/home.json") for name in ("one", "two")]
    same = {"camera": "one", "fps": 30.0, "height": 48, "width": 64}
    assert facts == [same | {"is_even": False, "lost_frames": [21]}, same]
    assert len(files.read_table(tmp_path / "data/sequences/one/labels.csv")) == 29
    times = listing.uneven_times("one")
    assert times[20] == pytest.approx(21 / 30)
    assert listing.uneven_times("two") is None
    # Transitions are counted as if the camera had a constant frame rate.
    (walk, other), rates = training_walks([Part("one", (0, 1, 2, 3, 4)), Part("two", (0, 1, 2, 3, 4))])
    assert (len(walk), len(other), rates) == (30, 30, [30.0, 30.0])


def test_a_layout_gets_its_settings(tmp_path, dataset):
    write_sequence(tmp_path / "cold", "town/seq1", ["CR", "CR", "KT"])
    (tmp_path / "cold/town/seq1/std_cam").rename(tmp_path / "cold/town/seq1/omni_cam")
    cold = {"layout": "cold", "root": "cold", "homes": ["town-seq1"]}
    cold |= {
        "ignored": [],
        "classes": ["corridor", "kitchen"],
        "aliases": {"CR": "corridor", "KT": "kitchen"},
    }
    with pytest.raises(PlacecatError, match=r"std_cam: the image folder is missing"):
        cameras(tmp_path, dataset | cold)
    assert cameras(tmp_path, dataset | cold | {"images": "omni_cam"}) == ["one"]
    sources = files.read_table(tmp_path / "data/sequences/town-seq1/frames.csv")["source"]
    assert sources.str.contains("/omni_cam/").all()


def test_rotated_frames_of_robot_at_home(tmp_path, dataset):
    """Check the frame size, the column of turns, and the classes of the rooms."""

    picture = np.zeros((32, 24, 3), np.uint8)
    seen = make(tmp_path / "rah", lambda *_: picture, cameras=[2], frames=2)
    own = yaml.safe_load((ROOT / "conf/dataset/robot_at_home.yaml").read_text()) | {"root": "rah"}
    assert cameras(tmp_path, own | {"camera": "RGBD_2", "turn": 270}) == ["RGBD_2"] * 5
    for home in own["homes"]:
        folder = tmp_path / "data/sequences" / home
        facts = files.read_json(folder / "home.json")
        assert (facts["width"], facts["height"]) == (32, 24)
        listed, labels = listing.read_frames(home), files.read_table(folder / "labels.csv")
        assert listed["turn"].tolist() == [270] * len(labels)
        assert {image.shape for image in read_frames("rah", listed, size=listing.frame_size(home))} == {
            (24, 32, 3)
        }
        classes = {"bedroom": 0, "masterroom": 0, "bathroom": 1, "kitchen": 2, "livingroom": 3}
        wanted = [classes.get(one.kind, -1) for one in seen if one.home == home and one.is_labelled]
        assert labels["class"].tolist() == wanted
    assert cameras(tmp_path, own | {"camera": "RGBD_2"}) == ["RGBD_2"] * 5
    assert "turn" not in listing.read_frames("alma")
    with pytest.raises(PlacecatError, match=r"pare, sequence pare-s1, frame 1: unknown label 'hall'"):
        cameras(tmp_path, own | {"camera": "RGBD_2", "ignored": ["corridor", "dressingroom", "fullhouse"]})
