import hashlib

import cv2
import numpy as np
import pytest

from placecat.sequences import open_home, read_frames
from sketch import ROOMS, WALL_HEIGHT, WALL_WIDTH, draw_homes, draw_room

SMALL = {"homes": 4, "frames_per_room": 4, "width": 96, "height": 54}
CLASSES = {"kitchen", "bathroom", "living_room", "dining_room", "bedroom"}


def digests(root):
    files = (path for path in root.rglob("*") if path.is_file())
    return {path.relative_to(root): hashlib.sha256(path.read_bytes()).hexdigest() for path in files}


@pytest.fixture(scope="module")
def drawn(tmp_path_factory):
    out = tmp_path_factory.mktemp("sketch") / "deep/homes"
    draw_homes(out, **SMALL)
    return out


def test_the_layout_reader_reads_the_drawn_homes(drawn):
    for name in ("Home1", "Home2", "Home3", "Home4"):
        home = open_home("vpc2009", drawn, name, fps=5.0)
        labels = home.frames["label"]
        assert set(labels) == {*CLASSES, "corridor", "transition"}
        assert sorted(labels.value_counts()[sorted(CLASSES)]) == [4, 4, 4, 6, 6]
        assert home.frames["sequence"].unique().tolist() == (["1", "2"] if name == "Home4" else ["1"])
        assert (home.width, home.height) == (96, 54)
        frames = list(read_frames(drawn, home.frames, size=(96, 54)))
        assert len(frames) == len(labels)
        assert min(float(frame.std()) for frame in frames) > 5


def test_frames_are_distinct_and_reproducible(drawn, tmp_path):
    first, threads = digests(drawn), cv2.getNumThreads()
    assert len(set(first.values())) == len(first)
    draw_homes(tmp_path / "again", **SMALL)
    assert digests(tmp_path / "again") == first
    large = {"homes": 1, "frames_per_room": 4, "width": 640, "height": 360}
    draw_homes(tmp_path / "large", **large)
    try:
        cv2.setNumThreads(1 if threads > 1 else 2)
        draw_homes(tmp_path / "threads", **large)
    finally:
        cv2.setNumThreads(threads)
    assert digests(tmp_path / "threads") == digests(tmp_path / "large")


@pytest.mark.slow
def test_colours_do_not_predict_classes():
    # The class with the nearest mean colour in the other homes is rarely correct; chance is 20%.
    homes, rooms = 12, sorted(CLASSES)
    means = np.empty((homes, len(rooms), 3))
    for home, place in np.ndindex(homes, len(rooms)):
        means[home, place] = draw_room(rooms[place], np.random.default_rng([home, place])).mean(axis=(0, 1))
    right = 0
    for home in range(homes):
        others = np.delete(means, home, axis=0).mean(axis=0)
        distance = np.linalg.norm(means[home][:, None] - others, axis=2)
        right += int((distance.argmin(axis=1) == np.arange(len(rooms))).sum())
    assert right / (homes * len(rooms)) <= 0.35


@pytest.mark.parametrize("room", ROOMS)
def test_walls_have_the_documented_size(room):
    wall = draw_room(room, np.random.default_rng(3))
    assert (wall.shape, wall.dtype) == ((WALL_HEIGHT, WALL_WIDTH, 3), np.uint8)
