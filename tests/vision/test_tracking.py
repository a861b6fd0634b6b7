from pathlib import Path

import cv2
import numpy as np
import pytest
import yaml
from hypothesis import given, settings
from hypothesis import strategies as st
from makers import smooth

from number_of_examples import examples
from placecat.errors import PlacecatError
from placecat.schema.signatures import check_vision
from placecat.vision.discovery import settings_of
from placecat.vision.regions import accept
from placecat.vision.tracking import RegionTracker

WIDTH, HEIGHT = 640, 360
CONF = Path(__file__).resolve().parents[2] / "conf/tracking/lucas_kanade.yaml"
NOTHING = np.zeros((0, 4), np.float32)


def scenery(seed=0, width=1400, height=900):
    """Draw a wide image; each frame shows part of it."""
    rng = np.random.default_rng(seed)
    coarse = np.stack([smooth(rng, height // 6, width // 6) for _ in range(3)], axis=2)
    return cv2.resize(coarse, (width, height), interpolation=cv2.INTER_CUBIC).clip(0, 255).astype(np.uint8)


SCENERY = scenery()


def view(x, y, width=WIDTH, height=HEIGHT):
    return SCENERY[y : y + height, x : x + width]


def rows(*points):
    """Return regions at the given points, with scale 2 and decreasing strength."""
    return np.array([(x, y, 2, 1 / (1 + k)) for k, (x, y) in enumerate(points)], np.float32)


SPREAD_OUT = rows(*[(x, y) for y in (60, 180, 300) for x in (80, 240, 400, 560)])


@pytest.mark.parametrize("shift", [(6, 0), (0, -8), (13, 7), (-40, 24)])
def test_regions_move_with_their_content(shift):
    dx, dy = shift
    tracker = RegionTracker()
    found = rows((200, 150), (330, 200), (420, 120))
    found[1, 2] = 4
    assert tracker.step(view(400, 300), found).tolist() == found.tolist()
    for frame in range(1, 5):
        got = tracker.step(view(400 - frame * dx, 300 - frame * dy), NOTHING)
        if len(got) < 3:
            # With the largest shift, the last positions are outside the frame.
            assert frame * abs(dx) >= 120
            break
        np.testing.assert_allclose(got[:, :2], found[:, :2] + np.array(shift) * frame, atol=0.5)
        assert got[:, 2:].tolist() == found[:, 2:].tolist()
        assert tracker.ages.tolist() == [frame] * 3
    assert frame >= 3


def test_a_region_is_followed_until_its_centre_leaves_the_image():
    for step, (x, y) in {
        (-20, 0): (100, 180),
        (20, 0): (540, 180),
        (0, -12): (320, 60),
        (0, 12): (320, 300),
    }.items():
        tracker = RegionTracker()
        tracker.step(view(400, 300), rows((x, y)))
        for frame in range(1, 8):
            place = np.array([x, y]) + np.array(step) * frame
            got = tracker.step(view(400 - frame * step[0], 300 - frame * step[1]), NOTHING)
            if (place < 0).any() or (place > [WIDTH - 1, HEIGHT - 1]).any():
                assert len(got) == 0
            # Half a window of the reduced frame is 21 pixels here.
            elif (place > 21).all() and (place < [WIDTH - 22, HEIGHT - 22]).all():
                np.testing.assert_allclose(got[0, :2], place, atol=0.5)
        assert len(tracker.ages) == 0


def test_a_region_is_lost_where_nothing_like_it_is():
    tracker = RegionTracker()
    tracker.step(view(400, 300), SPREAD_OUT)
    assert len(tracker.step(np.full((HEIGHT, WIDTH, 3), 128, np.uint8), NOTHING)) == 0
    tracker = RegionTracker()
    tracker.step(view(0, 0), SPREAD_OUT)
    # In another image, tracking back leads elsewhere, except for a lucky few.
    assert len(tracker.step(scenery(1)[:HEIGHT, :WIDTH], NOTHING)) <= 2


def test_tracking_back_detects_a_wrong_match():
    kept = {}
    for distance in (0.1, 1.0, 1000.0):
        tracker = RegionTracker(forward_backward=distance)
        tracker.step(view(0, 0), SPREAD_OUT)
        kept[distance] = len(tracker.step(scenery(1)[:HEIGHT, :WIDTH], NOTHING))
    assert kept[0.1] <= kept[1.0] < kept[1000.0]


def test_the_longest_followed_come_first_and_new_ones_fill_free_places():
    tracker = RegionTracker(max_regions=4)
    first = rows((100, 100), (500, 100))
    tracker.step(view(400, 300), first)
    # These regions are stronger, but come later. The first is on a tracked region, and there is no room for
    # the last.
    second = rows((104, 100), (100, 250), (500, 250), (300, 180)) * np.float32([1, 1, 1, 10])
    got = tracker.step(view(400, 300), second)
    np.testing.assert_allclose(got, [*first, second[1], second[2]], atol=0.05)
    assert tracker.ages.tolist() == [1, 1, 0, 0]
    for x in range(385, 235, -15):
        got = tracker.step(view(x, 300), NOTHING)
    # The scene moved to the right by 150 pixels, so one region of each age left the image.
    np.testing.assert_allclose(got[:, :2], [(250, 100), (250, 250)], atol=1)
    assert tracker.ages.tolist() == [11, 10]
    got = tracker.step(view(250, 300), rows((400, 180), (400, 40), (400, 300)))
    np.testing.assert_allclose(got[:, :2], [(250, 100), (250, 250), (400, 180), (400, 40)], atol=1)
    assert tracker.ages.tolist() == [12, 11, 0, 0]


def test_of_two_that_come_too_close_the_younger_is_given_up():
    """The camera moves away, so everything shrinks towards the centre."""
    tracker = RegionTracker()
    old, young = rows((300, 180)), rows((342, 180))
    tracker.step(view(400, 300), old)
    assert len(tracker.step(view(400, 300), young)) == 2
    for frame in range(1, 11):
        x, y = 16 * frame, 9 * frame
        around = SCENERY[300 - y : 300 + HEIGHT + y, 400 - x : 400 + WIDTH + x]
        got = tracker.step(cv2.resize(around, (WIDTH, HEIGHT), interpolation=cv2.INTER_AREA), NOTHING)
        # Two regions of scale 2 must be more than 32 pixels apart at this width.
        shrunk = WIDTH / (WIDTH + 2 * x)
        if not 29 < 42 * shrunk < 35:
            assert len(got) == (2 if 42 * shrunk > 32 else 1)
        np.testing.assert_allclose(got[0, :2], (old[0, :2] + [x, y]) * shrunk, atol=6)
    assert tracker.ages.tolist() == [11]
    assert got[0, 3] == old[0, 3]


@given(
    st.lists(
        st.lists(
            st.tuples(st.integers(0, WIDTH - 1), st.integers(0, HEIGHT - 1), st.integers(2, 5)), max_size=20
        ),
        min_size=1,
        max_size=5,
    ),
    st.integers(1, 12),
    st.tuples(st.integers(-30, 30), st.integers(-20, 20)),
)
@settings(max_examples=examples(25), deadline=None)
def test_the_regions_always_satisfy_the_inequality(found, most, shift):
    tracker = RegionTracker(max_regions=most, width=160)
    last = 0
    for frame, points in enumerate(found):
        strength = np.linspace(2, 1, len(points))
        regions = np.array([(*p, s) for p, s in zip(points, strength, strict=True)], np.float32).reshape(
            -1, 4
        )
        before = regions.copy()
        got = tracker.step(view(400 + frame * shift[0], 300 + frame * shift[1]), regions)
        np.testing.assert_array_equal(regions, before)
        assert got.dtype == np.float32
        assert len(got) == len(tracker.ages) <= most
        assert accept(got[:, :3], WIDTH, max_regions=most).tolist() == list(range(len(got)))
        assert (np.diff(tracker.ages) <= 0).all()
        assert (got[:, :2] >= 0).all()
        assert (got[:, :2] <= [WIDTH - 1, HEIGHT - 1]).all()
        assert (tracker.ages > 0).sum() <= last
        new = got[tracker.ages == 0]
        assert {tuple(row) for row in new.tolist()} <= {tuple(row) for row in regions.tolist()}
        assert (np.diff(new[:, 3]) <= 0).all()
        last = len(got)


def test_a_restart_gives_the_same_bytes():
    def follow():
        tracker = RegionTracker()
        views = [view(400 - 9 * t, 300 + 4 * t) for t in range(4)]
        return b"".join(
            tracker.step(image, SPREAD_OUT + np.float32(t)).tobytes() for t, image in enumerate(views)
        )

    first = follow()
    assert first == follow()
    threads = cv2.getNumThreads()
    try:
        cv2.setNumThreads(1)
        assert first == follow()
    finally:
        cv2.setNumThreads(threads)


def test_its_result_belongs_to_the_caller():
    tracker = RegionTracker()
    tracker.step(view(400, 300), SPREAD_OUT)[:] = 0
    np.testing.assert_allclose(tracker.step(view(400, 300), NOTHING), SPREAD_OUT, atol=0.05)


def test_positions_are_pixels_of_the_frame_at_any_reduced_width():
    found = rows((200, 150), (330, 200), (420, 120))
    for width in (160, 320, 640, 5000):
        tracker = RegionTracker(width=width)
        tracker.step(view(400, 300), found)
        got = tracker.step(view(392, 304), NOTHING)
        np.testing.assert_allclose(got[:, :2], found[:, :2] + [8, -4], atol=0.6)


def test_no_regions_at_all():
    tracker = RegionTracker()
    for _ in range(3):
        assert tracker.step(view(0, 0), NOTHING).shape == (0, 4)


def test_the_configuration_has_every_setting_with_its_default():
    conf = yaml.safe_load(CONF.read_text())
    assert conf.pop("descriptors") == ["hog", "sift", "centrist"]
    defaults = settings_of(RegionTracker)
    assert {conf.pop(name) for name in ("scale_distance", "min_distance")} == {
        "${regions.scale_distance}",
        "${regions.min_distance}",
    }
    assert conf == {name: value for name, value in defaults.items() if "distance" not in name}


@pytest.mark.parametrize(
    "wrong",
    [
        {"max_regions": 0},
        {"window": 20},
        {"width": 8},
        {"levels": -1},
        {"iterations": 0},
        {"epsilon": 0.0},
        {"forward_backward": float("nan")},
        {"min_eigenvalue": -1.0},
    ],
)
def test_impossible_settings(wrong):
    with pytest.raises(PlacecatError, match=next(iter(wrong))):
        check_vision("tracking", wrong, "tracking")
