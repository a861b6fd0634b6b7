"""The stage `tracks` on two short sequences in which a camera pans over a noisy wall."""

import json
import shutil

import cv2
import numpy as np
import pandas as pd
import pytest
import yaml

from placecat.errors import PlacecatError
from placecat.stages import tracks
from placecat.vision.frame import describe_frame
from placecat.vision.tracking import RegionTracker

WIDTH, HEIGHT, FRAMES, FOUND = 320, 240, 5, 6
TRACKING = {"max_regions": 4, "width": 160, "window": 15}
LOCAL = {"hog": {"interpolation": "linear"}, "edges": {"descriptor": "centrist", "image": "laplacian"}}


def params(**tracking):
    return {
        "dataset": {"root": "homes", "homes": ["H1"]},
        "attention": {"scales": [2, 3, 4, 5]},
        "descriptors": {"local": LOCAL | {"color_mv": {"grid": 3}}, "holistic": {}},
        "tracking": {"descriptors": ["hog", "edges"]} | TRACKING | tracking,
    }


def frames_of_the_home():
    """Yield a sequence and its reverse, so that only the cut between them ends the tracks."""
    noise = np.random.default_rng(0).integers(0, 256, (40, 80, 3), np.uint8)
    wall = cv2.resize(noise, (800, 400), interpolation=cv2.INTER_CUBIC)
    for t in (*range(FRAMES), *reversed(range(FRAMES))):
        yield wall[20 : 20 + HEIGHT, 8 * t : 8 * t + WIDTH]


@pytest.fixture
def home(tmp_path, monkeypatch):
    """The current folder as the stage `features` leaves it."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("PLACECAT_WORKERS", "1")
    (tmp_path / "homes/H1").mkdir(parents=True)
    sources = []
    for number, image in enumerate(frames_of_the_home()):
        sources.append(f"H1/{number}.png")
        cv2.imwrite(str(tmp_path / "homes" / sources[-1]), image)
    rng = np.random.default_rng(3)
    regions = np.zeros((2 * FRAMES, FOUND, 4), np.float32)
    counts = rng.integers(2, FOUND + 1, 2 * FRAMES).astype(np.int16)
    for rows, count in zip(regions, counts, strict=True):
        rows[:count, :2] = rng.uniform(20, [WIDTH - 20, HEIGHT - 20], (count, 2))
        # The second region is too close to the first.
        rows[1, :2] = rows[0, :2] + 1
        rows[:count, 2] = rng.integers(2, 4, count)
        rows[:count, 3] = np.sort(rng.random(count))[::-1]
    features, sequences = tmp_path / "data/features/H1", tmp_path / "data/sequences/H1"
    features.mkdir(parents=True)
    sequences.mkdir(parents=True)
    np.save(features / "regions.npy", regions)
    np.save(features / "count.npy", counts)
    pd.DataFrame(
        {
            "sequence": ["1"] * FRAMES + ["2"] * FRAMES,
            "number": [*range(1, FRAMES + 1)] * 2,
            "source": sources,
            "position": -1,
            "seconds": 0.0,
        }
    ).to_csv(sequences / "frames.csv", index=False)
    (sequences / "home.json").write_text(json.dumps({"width": WIDTH, "height": HEIGHT, "fps": 5}))
    return tmp_path


def run(folder, **tracking):
    (folder / "params.yaml").write_text(yaml.safe_dump(params(**tracking)))
    tracks.main()
    return folder / "data/tracks/H1"


def test_regions_are_tracked_in_each_sequence_and_described_where_they_are(home):
    folder = run(home)
    assert {path.name for path in folder.iterdir()} == {
        "count.npy",
        "regions.npy",
        "local_hog.npy",
        "local_edges.npy",
        "descriptors.json",
        "manifest.json",
    }
    assert json.loads((folder / "descriptors.json").read_text()) == {"hog": "hog", "edges": "centrist"}
    got = {path.stem: np.load(path, allow_pickle=False) for path in folder.glob("*.npy")}
    assert got["local_hog"].shape == (2 * FRAMES, 4, 128)
    assert got["local_edges"].shape == (2 * FRAMES, 4, 256)
    found = np.load(home / "data/features/H1/regions.npy")
    counts = np.load(home / "data/features/H1/count.npy")
    followed = 0
    for number, image in enumerate(frames_of_the_home()):
        if number % FRAMES == 0:
            tracker = RegionTracker(**TRACKING)
        # Only the four strongest new regions are offered.
        regions = tracker.step(image, found[number, : min(4, counts[number])])
        followed += (tracker.ages > 0).sum()
        count = got["count"][number]
        assert count == len(regions)
        np.testing.assert_array_equal(got["regions"][number, :count], regions)
        expected = describe_frame(image, {"local": LOCAL}, regions=regions)
        for name in (f"local_{name}" for name in LOCAL):
            np.testing.assert_array_equal(got[name][number, :count], expected[name][:count])
        assert all(not got[name][number, count:].any() for name in got if name != "count")
    assert followed > FRAMES


def test_the_bytes_do_not_depend_on_the_number_of_workers(home, monkeypatch, two_workers):
    monkeypatch.setenv("PLACECAT_WORKERS", "1")
    folder = run(home)
    one = {path.name: path.read_bytes() for path in folder.iterdir()}
    shutil.rmtree(folder)
    monkeypatch.setenv("PLACECAT_WORKERS", "2")
    run(home)
    assert {path.name: path.read_bytes() for path in folder.iterdir()} == one


def test_an_unknown_descriptor_is_reported_and_nothing_is_written(home):
    with pytest.raises(PlacecatError, match=r"'descriptors.local.surf' does not exist.*hog"):
        run(home, descriptors=["hog", "surf"])
    assert not (home / "data/tracks").exists() or not any((home / "data/tracks").iterdir())
