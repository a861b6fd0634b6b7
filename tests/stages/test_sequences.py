import pytest
import yaml

from placecat import files
from placecat.errors import PlacecatError
from placecat.stages import sequences
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
