import pytest
import yaml
from clips import steady, write_clip, zero

from placecat import files, listing
from placecat.errors import PlacecatError
from placecat.stages import sequences
from placecat.training.integration import training_walks
from placecat.training.plan import Part
from sketch import draw_homes

CLASSES = ["bedroom", "bathroom", "kitchen", "living_room", "dining_room"]


@pytest.fixture
def dataset(tmp_path, monkeypatch):
    """Settings of two small homes below the current folder."""
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


def test_one_camera_for_all_homes_or_one_a_home(tmp_path, dataset):
    assert cameras(tmp_path, dataset) == ["one", "one"]
    assert cameras(tmp_path, dataset | {"camera": {"Home2": "two", "Home1": "one"}}) == ["one", "two"]


def test_a_home_without_a_camera_gives_a_message_and_leaves_nothing(tmp_path, dataset):
    with pytest.raises(PlacecatError, match=r"names none for Home2: add dataset\.camera\.Home2"):
        cameras(tmp_path, dataset | {"camera": {"Home1": "one"}})
    assert not (tmp_path / "data/sequences").exists()


def test_what_is_missing_of_a_video_is_told_and_kept(tmp_path, dataset, capsys):
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
    assert len(files.read_csv(tmp_path / "data/sequences/one/labels.csv")) == 29
    times = listing.uneven_times("one")
    assert times[20] == pytest.approx(21 / 30)
    assert listing.uneven_times("two") is None
    # Transitions are counted on the frames that an even camera would have shown.
    (walk, other), rates = training_walks([Part("one", (0, 1, 2, 3, 4)), Part("two", (0, 1, 2, 3, 4))])
    assert (len(walk), len(other), rates) == (30, 30, [30.0, 30.0])
