import numpy as np
import pytest

from placecat_bench.scale import drawing
from placecat_bench.scale.database import Stretch

LABELS = ["kitchen"] * 6 + ["transition"] * 3 + ["bedroom"] * 4
CLASSES = np.array([1] * 6 + [-1] * 3 + [0] * 4)
WALK = [
    Stretch(1, "bedroom", 20),
    Stretch(1, "closet", 9),
    Stretch(1, "kitchen", 5),
    Stretch(2, "bathroom", 3),
]
OWN = [0, -1, 1, 2]


def test_source_frames_match_the_label_or_class_and_stretches_are_continuous():
    chosen = drawing.draw_frames(WALK, LABELS, CLASSES, OWN, "a")
    assert len(chosen) == 37
    assert set(chosen[:20]) == {9, 10, 11, 12}
    # Without a closet, another frame without a class is used. Without a bathroom, any frame is used.
    assert set(chosen[20:29]) <= {6, 7, 8}
    assert set(chosen[29:34]) <= set(range(6))
    assert set(np.diff(chosen[:20])) <= {0, 1, -3}


def test_frames_get_the_requested_number_of_regions_of_their_class():
    counts = np.array([3, 0, 2, 3, 1, 2, 1, 1, 1, 2, 3, 3, 0])
    chosen = np.array([0, 1, 9, 12, 6])
    frame, place = drawing.draw_regions(chosen, counts, CLASSES, 5, "a")
    assert frame.shape == place.shape == (5, 5)
    assert (CLASSES[frame] == CLASSES[chosen][:, None]).all()
    assert (place < counts[frame]).all() and (place >= 0).all()
    assert frame[0, :3].tolist() == [0, 0, 0] and place[0, :3].tolist() == [0, 1, 2]


@pytest.mark.parametrize("chunk", [1, 10_000])
def test_no_two_drawn_frames_are_equal_and_values_stay_in_range(tmp_path, monkeypatch, chunk):
    monkeypatch.setattr(drawing, "CHUNK", chunk)
    source = np.random.default_rng(0).random((6, 4, 3), np.float32) - 0.2
    source[0, 0, 0] = 0.0
    np.save(tmp_path / "local_hog.npy", source)
    frame, place = np.zeros((8, 2), np.int64), np.tile([0, 1], (8, 1))
    target = tmp_path / "data/features/a/local_hog.npy"
    drawing.write_jittered(tmp_path / "local_hog.npy", target, frame, place, 0.1, "a")
    drawn = np.load(target)
    assert drawn.shape == (8, 2, 3) and drawn.dtype == np.float32
    assert len(np.unique(drawn[:, 1], axis=0)) == 8
    assert (drawn[:, 0, 0] == 0.0).all()
    assert source.min() <= drawn.min() and drawn.max() <= source.max()
    np.testing.assert_allclose(drawn, np.broadcast_to(source[0, :2], drawn.shape), rtol=0.6)
    if chunk == 1:
        monkeypatch.setattr(drawing, "CHUNK", 10_000)
        drawing.write_jittered(tmp_path / "local_hog.npy", target, frame, place, 0.1, "a")
        np.testing.assert_array_equal(np.load(target), drawn)
