"""Check the rendered videos that come with the project. They are read in the same way as in the pipeline."""

from pathlib import Path
from types import SimpleNamespace

import pandas as pd
import pytest
import yaml

from placecat import files
from placecat.footage.recording import Recording
from placecat.sequences import video
from placecat.stages import sequences
from placecat_homes import render, shortcuts
from project import ROOT, rendered

pytestmark = [pytest.mark.slow, pytest.mark.xdist_group("data")]

SIZES = {"homes": {(1280, 720)}, "university": {(640, 480)}, "apartments": {(640, 480), (1280, 720)}}
"""Frame sizes of each data set, as (width, height)."""
EVERY = 9
"""Step between judged frames; the frames between them would add no information."""


def settings():
    """Return the data sets in conf/dataset that are in the repository, by name."""
    paths = sorted((ROOT / "conf/dataset").glob("*.yaml"))
    found = {path.stem: yaml.safe_load(path.read_text()) for path in paths}
    return {name: dataset for name, dataset in found.items() if dataset["root"] in rendered()}


class Undecoded(Recording):
    """A recording that lists the frames of an intact video without decoding them."""

    def pictures(self, first=1):
        shown = next(super().pictures())
        for number in range(first, self.count + 1):
            yield SimpleNamespace(number=number, size=shown.size)


@pytest.fixture(scope="module")
def looks():
    """The features that shortcuts may use in judged frames, by video and position; `homes` fills them in."""
    found = {}

    def ask(root, frames):
        found.update(dict.fromkeys(frames_of(root, frames)))
        return []

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(video, "Recording", Undecoded)
        patch.setattr(shortcuts, "read_frames", ask)
        for home in judged()["homes"]:
            shortcuts._see(judged(), home, EVERY)
    return found


def frames_of(root, frames):
    return [(root / name, row) for name, row in zip(frames["source"], frames["position"], strict=True)]


def judged():
    dataset = settings()["homes"]
    return dataset | {"root": ROOT / dataset["root"]}


@pytest.fixture(scope="module")
def homes(tmp_path_factory, looks):
    """The output of the stage `sequences` for each data set: labels and facts, by home."""

    class Looking(Recording):
        """A recording that passes decoded frames to the shortcut test, so that they are decoded only once."""

        def pictures(self, first=1):
            for picture in super().pictures(first):
                frame = self.path.resolve(), picture.number - 1
                if frame in looks:
                    looks[frame] = shortcuts._look(picture.image())
                yield picture

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(video, "Recording", Looking)
        # Frames that are decoded in other processes would be missed.
        patch.setenv("PLACECAT_WORKERS", "1")
        return {name: read(name, tmp_path_factory.mktemp(name), patch) for name in settings()}


def read(name, folder, patch):
    patch.chdir(folder)
    (folder / "data").mkdir()
    for out in rendered():
        (folder / out).symlink_to(ROOT / out)
    # The stage reads no other settings. tests/config/test_compose.py composes each data set.
    Path("params.yaml").write_text(yaml.safe_dump({"dataset": settings()[name]}))
    sequences.main()
    found = {}
    for home in settings()[name]["homes"]:
        made = folder / "data/sequences" / home
        found[home] = pd.read_csv(made / "labels.csv"), files.read_json(made / "home.json")
    return found


def test_each_folder_of_videos_is_a_data_set():
    assert sorted(settings()) == sorted(SIZES)
    assert sorted(dataset["root"] for dataset in settings().values()) == sorted(rendered())


def test_every_video_is_used_and_has_labels_and_was_rendered():
    used = {f"{dataset['root']}/{home}" for dataset in settings().values() for home in dataset["homes"]}
    assert used == {f"data/{name}" for name in render.listed()}
    there = {path.relative_to(ROOT).as_posix() for out in rendered() for path in (ROOT / out).rglob("*")}
    assert there == {f"{name}.{ending}" for name in used for ending in ("mp4", "csv")}


def test_the_videos_are_small_in_total():
    assert 0 < sum(path.stat().st_size for out in rendered() for path in (ROOT / out).rglob("*")) < 60e6


@pytest.mark.parametrize("name", SIZES)
def test_frames_are_as_listed(homes, name):
    for home, (labels, facts) in homes[name].items():
        listed = render.listed()[f"{name}/{home}"]
        assert len(labels) == listed["frames"], home
        assert facts["fps"] == listed["fps"], home
        assert (facts["width"], facts["height"]) in SIZES[name], home
        assert labels["label"].notna().all(), home


def test_no_shortcut_predicts_the_rooms(homes, looks, monkeypatch):
    monkeypatch.setattr(video, "Recording", Undecoded)
    monkeypatch.setattr(shortcuts, "read_frames", frames_of)
    monkeypatch.setattr(shortcuts, "_look", looks.__getitem__)
    table = shortcuts.measure(judged(), EVERY)
    assert table.shape == (5 * 6, 6 + 1)
    best = table[table["average"] > shortcuts.LIMIT]
    assert table["average"].max() <= shortcuts.LIMIT, best.round(1).to_string()


def test_homes_are_long_enough_to_compare_with_real_ones(homes):
    assert len(homes["homes"]) == 6
    assert min(len(labels) for labels, _ in homes["homes"].values()) >= 600


def test_each_home_shows_every_room_and_the_transitions(homes):
    for home, (labels, _) in homes["homes"].items():
        classes = settings()["homes"]["classes"]
        assert {*classes, "transition"} <= set(labels["label"]) <= {*classes, "corridor", "transition"}, home
    everywhere = pd.concat([labels["label"] for labels, _ in homes["homes"].values()])
    assert "corridor" in set(everywhere)


def classes_of(homes, *names):
    return {name: set(homes[name][0]["label"]) - {"transition"} for name in names}


def test_the_university_is_passed_twice_and_tested_in_other_rooms(homes):
    """Thesis 4.9 has sequences for the cues, for the integration (a second pass) and for testing."""
    university = homes["university"]
    seen = classes_of(university, *university)
    assert set.union(*seen.values()) == set(settings()["university"]["classes"])
    for route in ("north_2", "south_2", "north_4"):
        assert seen[f"{route}_cloudy_2"] == seen[f"{route}_cloudy_3"], route
    trained = seen["north_2_cloudy_2"] | seen["south_2_cloudy_2"] | {"kitchen"}
    tested = seen["south_3_cloudy_2"] | seen["north_4_cloudy_3"]
    assert trained == tested == set(settings()["university"]["classes"])
    assert "kitchen" in seen["north_4_cloudy_2"]


def test_the_apartments_train_and_test_all_classes_with_other_cameras(homes):
    """These are the sequences of thesis 4.10."""
    apartments = homes["apartments"]
    seen = classes_of(apartments, *apartments)
    classes = set(settings()["apartments"]["classes"])
    assert seen["flip"] | seen["webcam"] == seen["robot"] == classes
    cameras = {name: facts["camera"] for name, (_, facts) in apartments.items()}
    assert len({cameras[name] for name in ("flip", "webcam", "robot")}) == 3


def test_the_extra_data_is_the_flat_of_the_robot_filmed_by_hand(homes):
    """This is for thesis 4.5. In 4.10, this flat is used for testing, so nothing is trained on it."""
    listed = render.listed()
    flip, downstairs, robot = (listed[f"apartments/{name}"] for name in ("flip", "flip_downstairs", "robot"))
    assert (downstairs["plan"], downstairs["building"]) == (robot["plan"], robot["building"])
    assert (downstairs["camera"], downstairs["carriage"]) == (flip["camera"], flip["carriage"])
    params = yaml.safe_load((ROOT / "params.yaml").read_text())
    assert params["protocol"]["extra"] == {"split": "apartments", "sequences": ["flip_downstairs"]}
    own = params["splits"]["apartments"]
    used = [part["sequence"] for part in (*own["cue_parts"], *own["integration_parts"])]
    assert "flip_downstairs" not in (*used, *own["test"])
    trained = set(settings()["homes"]["classes"])
    assert trained <= classes_of(homes["apartments"], "flip_downstairs")["flip_downstairs"]
