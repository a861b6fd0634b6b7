import math
from collections import Counter
from itertools import groupby, pairwise

import numpy as np
import pytest
import yaml

from placecat.errors import PlacecatError
from placecat_homes.render import SETTINGS
from placecat_homes.walking.carriage import Carriage
from placecat_homes.walking.ground import DOORWAY, Ground
from placecat_homes.walking.itinerary import draw, ways
from placecat_homes.walking.route import Router, lengths
from placecat_homes.walking.walk import walk
from placecat_homes.walking.walk_statistics import Statistics

pytestmark = pytest.mark.slow

BODY = 0.25


def floor(rooms, doors, items=(), windows=(), cell=0.1):
    """Make a ground from rooms {name: (x0, y0, x1, y1)}, doors (room, room, x, y) and items
    (room, x, y, width, depth, height)."""
    rects = np.array(list(rooms.values()))
    low, high = rects[:, :2].min(axis=0) - 0.2, rects[:, 2:].max(axis=0) + 0.2
    shape = tuple(np.ceil((high - low) / cell).astype(int))
    x, y = (
        low[axis] + (np.arange(shape[axis]) + 0.5).reshape((-1, 1) if axis == 0 else (1, -1)) * cell
        for axis in (0, 1)
    )

    def inside(x0, y0, x1, y1):
        return (x > x0) & (x < x1) & (y > y0) & (y < y1)

    names = list(rooms)
    room = np.full(shape, -1, dtype=np.int16)
    free = np.zeros(shape, dtype=bool)
    for index, (x0, y0, x1, y1) in enumerate(rects):
        room[inside(x0, y0, x1, y1)] = index
        free |= inside(x0 + BODY, y0 + BODY, x1 - BODY, y1 - BODY)
    openings = []
    for a, b, u, v in doors:
        sides = [abs(u - edge) < 0.12 for name in (a, b) for edge in (rooms[name][0], rooms[name][2])]
        w, d = (0.4, 0.45) if any(sides) else (0.45, 0.4)
        room[inside(u - w, v - d, u + w, v + d) & (room < 0)] = DOORWAY
        free |= (
            inside(u - w, v - d + BODY, u + w, v + d - BODY)
            if any(sides)
            else inside(u - w + BODY, v - d, u + w - BODY, v + d)
        )
        openings.append((names.index(a), names.index(b), u, v))
    for _, u, v, w, d, _ in items:
        free &= ~inside(u - w / 2 - BODY, v - d / 2 - BODY, u + w / 2 + BODY, v + d / 2 + BODY)
    return Ground(
        cell=cell,
        origin=(float(low[0]), float(low[1])),
        free=free,
        room=room,
        names=tuple(names),
        kinds=tuple(name.rstrip("_0123456789") for name in names),
        rects=tuple(rooms.values()),
        doors=tuple(openings),
        windows=tuple((names.index(name), u, v) for name, u, v in windows),
        items=tuple((names.index(name), u, v, h) for name, u, v, _, _, h in items),
    )


def home(cell=0.1):
    """Rooms along a corridor, some with doors to each other."""
    rooms = {
        "bedroom_1": (0.0, 0.0, 4.0, 3.6),
        "bathroom_1": (4.1, 0.0, 6.3, 3.6),
        "bedroom_2": (6.4, 0.0, 10.0, 3.6),
        "bathroom_2": (10.1, 0.0, 12.0, 3.6),
        "corridor": (0.0, 3.7, 8.9, 5.0),
        "kitchen": (0.0, 5.1, 3.4, 8.8),
        "dining_room": (3.5, 5.1, 7.0, 8.8),
        "living_room": (7.1, 5.1, 12.0, 8.8),
    }
    doors = [
        ("bedroom_1", "corridor", 3.2, 3.65),
        ("bathroom_1", "corridor", 5.2, 3.65),
        ("bedroom_2", "corridor", 7.4, 3.65),
        ("bedroom_2", "bathroom_2", 10.05, 2.5),
        ("kitchen", "corridor", 1.5, 5.05),
        ("dining_room", "corridor", 4.4, 5.05),
        ("living_room", "corridor", 8.2, 5.05),
        ("kitchen", "dining_room", 3.45, 7.0),
        ("dining_room", "living_room", 7.05, 7.0),
    ]
    items = [
        ("bedroom_1", 1.0, 1.0, 2.0, 1.8, 0.5),
        ("bedroom_1", 3.7, 1.0, 0.6, 1.6, 2.0),
        ("bathroom_1", 4.5, 0.9, 0.8, 1.7, 0.55),
        ("bathroom_1", 6.0, 1.2, 0.5, 0.6, 0.85),
        ("bedroom_2", 8.6, 0.9, 1.6, 1.8, 0.5),
        ("bathroom_2", 11.6, 0.9, 0.7, 1.7, 0.55),
        ("kitchen", 0.3, 7.0, 0.6, 3.4, 0.9),
        ("dining_room", 5.3, 7.4, 1.2, 1.0, 0.75),
        ("living_room", 11.5, 7.0, 0.9, 2.2, 0.8),
        ("living_room", 9.8, 7.0, 0.6, 1.0, 0.45),
    ]
    windows = [("bedroom_1", 1.5, 0.0), ("kitchen", 1.7, 8.8), ("living_room", 9.0, 8.8)]
    return floor(rooms, doors, items, windows, cell)


def university(cell=0.1):
    rooms = {
        "corridor": (0.0, 4.1, 16.0, 6.0),
        "office_1": (0.0, 0.0, 4.0, 4.0),
        "office_2": (4.1, 0.0, 8.0, 4.0),
        "kitchen": (8.1, 0.0, 11.0, 4.0),
        "bathroom": (11.1, 0.0, 14.0, 4.0),
        "printer_area": (5.0, 6.1, 9.0, 9.0),
    }
    doors = [(name, "corridor", (x0 + x1) / 2, 4.05) for name, (x0, _, x1, _) in list(rooms.items())[1:5]]
    doors.append(("printer_area", "corridor", 7.0, 6.05))
    items = [("office_1", 0.8, 1.0, 1.6, 0.8, 0.75), ("kitchen", 10.6, 1.5, 0.6, 2.5, 0.9)]
    return floor(rooms, doors, items, cell=cell)


def statistics(name):
    return Statistics.of(yaml.safe_load((SETTINGS / "walk" / f"{name}.yaml").read_text(encoding="utf-8")))


def carriage(name):
    return Carriage.of(yaml.safe_load((SETTINGS / "carriage" / f"{name}.yaml").read_text(encoding="utf-8")))


def make(ground, of, by, seed, frames=640, **options):
    return walk(ground, np.random.default_rng(seed), statistics(of), carriage(by), frames, 5.0, **options)


@pytest.fixture(scope="module")
def homes():
    ground = home()
    return ground, [make(ground, "home", "tripod", seed) for seed in range(6)]


def test_a_walk_has_the_requested_frames_and_stays_on_free_floor(homes):
    ground, walks = homes
    for one in walks:
        assert len(one.label) == len(one.yaw) == len(one.pitch) == len(one.roll) == 640
        assert one.position.shape == (640, 3)
        assert ground.is_free(one.position[:, :2]).all()
        steps = np.hypot(*np.diff(one.position[:, :2], axis=0).T)
        assert steps.max() < 1.6 / 5


def test_the_camera_turns_slowly_enough_for_frames_to_overlap(homes):
    for one in homes[1]:
        assert np.degrees(np.abs(np.diff(one.yaw))).max() < 14.0
        assert np.degrees(one.pitch).min() > -42 and np.degrees(one.pitch).max() < 15
        assert -22 < np.degrees(one.pitch).mean() < -8
        assert np.degrees(np.abs(one.roll)).max() < 8


def test_every_class_has_its_share_of_frames(homes):
    for one in homes[1]:
        counts = Counter(one.label)
        for kind in statistics("home").classes:
            assert counts[kind] >= 0.04 * 640


def test_labels_match_the_rooms(homes):
    ground, walks = homes
    for one in walks:
        rooms = ground.room_at(one.position[:, :2])
        kinds = [ground.kinds[room] if room >= 0 else DOORWAY for room in rooms]
        wrong = sum(label not in ("transition", kind) for label, kind in zip(one.label, kinds, strict=True))
        assert wrong <= 2


def test_walks_have_the_measured_statistics(homes):
    settings = statistics("home")
    shares = [one.label.count("transition") / 640 for one in homes[1]]
    mean, deviation, least, most = settings.transition_share
    assert least - 0.01 <= min(shares) and max(shares) <= most + 0.01
    assert abs(np.mean(shares) - mean) < deviation
    stays = [sum(label != "transition" for label, _ in groupby(one.label)) for one in homes[1]]
    assert all(5 <= count <= 21 for count in stays)


def test_the_order_of_rooms_follows_the_statistics():
    ground, settings = home(), statistics("home")
    rng = np.random.default_rng(0)
    seen = Counter()
    for _ in range(150):
        kinds = [ground.kinds[stop.room] for stop in draw(ground, rng, settings)]
        seen.update(pairwise(kinds))
    for kind in settings.classes:
        total = sum(count for (before, _), count in seen.items() if before == kind)
        odds = settings.follows[kind]
        shares = {after: seen[kind, after] / total for after in odds}
        for after, odd in odds.items():
            assert shares[after] == pytest.approx(odd / sum(odds.values()), abs=0.16)


def test_a_walk_depends_on_the_seed(homes):
    ground, walks = homes
    again = make(ground, "home", "tripod", 0)
    np.testing.assert_array_equal(again.position, walks[0].position)
    np.testing.assert_array_equal(again.yaw, walks[0].yaw)
    assert again.label == walks[0].label
    assert walks[1].label != walks[0].label


def test_a_robot_visits_every_room_and_labels_are_rooms():
    ground = university()
    for seed in range(2):
        one = make(ground, "university", "robot", seed, rooms=ground.names)
        rooms = ground.room_at(one.position[:, :2])
        assert set(rooms) - {DOORWAY} == set(range(len(ground.names)))
        assert "transition" not in one.label
        inside = [(ground.kinds[r], label) for r, label in zip(rooms, one.label, strict=True) if r >= 0]
        assert sum(kind != label for kind, label in inside) <= 12
        assert np.ptp(one.position[:, 2]) == 0.0
        assert np.degrees(np.abs(one.pitch)).max() < 1.0
        assert np.degrees(np.abs(np.diff(one.yaw))).max() < 14.0


def test_a_robot_looks_where_it_drives():
    one = make(university(), "university", "robot", 3)
    moves = np.diff(one.position[:, :2], axis=0)
    fast = np.hypot(*moves.T) > 0.04
    direction = np.arctan2(moves[:, 1], moves[:, 0])
    off = np.abs((one.yaw[:-1] - direction + math.pi) % (2 * math.pi) - math.pi)[fast]
    assert np.degrees(np.median(off)) < 5
    assert np.mean(off < math.radians(30)) > 0.95


def test_rooms_can_be_chosen():
    one = make(university(), "university", "robot", 0, frames=400, rooms=("corridor", "office_1", "kitchen"))
    assert set(one.label) == {"corridor", "office", "kitchen"}


def test_only_the_doorways_of_an_apartment_are_transitions():
    one = make(home(), "apartment", "flip", 1, frames=900)
    assert 0.08 < one.label.count("transition") / 900 < 0.36
    assert "corridor" in one.label


def test_too_few_frames_raise_an_error():
    with pytest.raises(PlacecatError, match="more frames"):
        make(home(), "home", "tripod", 0, frames=60)


def test_a_path_is_free_smooth_and_nearly_shortest():
    ground = home(cell=0.05)
    start, goal = ground.nearest_free(np.array([[1.0, 3.0], [11.0, 3.0]]))
    path = Router(ground).path(start, goal)
    assert ground.is_free(path).all()
    np.testing.assert_allclose(path[[0, -1]], [start, goal])
    assert lengths(path)[-1] < 14.5
    turns = np.abs(np.diff(np.unwrap(np.arctan2(*np.diff(path, axis=0).T[::-1]))))
    assert np.degrees(turns).max() < 60


def test_ways_lead_from_door_to_door():
    ground = home()
    way = ways(ground)
    index = ground.names.index
    assert way[index("kitchen"), index("dining_room")].length == 0
    far = way[index("bedroom_1"), index("bathroom_2")]
    assert far.out == (3.2, 3.65) and far.into == (10.05, 2.5)
    assert far.length == pytest.approx(4.2 + math.hypot(2.65, 1.15))


def test_an_unknown_setting_raises_an_error():
    values = yaml.safe_load((SETTINGS / "walk" / "home.yaml").read_text(encoding="utf-8"))
    with pytest.raises(PlacecatError, match="'stay'"):
        Statistics.of({**values, "stay": 1})


def test_parts_of_a_corridor_have_no_doorway_between_them():
    rooms = {
        "corridor_1": (0.0, 0.0, 4.0, 2.0),
        "corridor_2": (4.0, 0.0, 8.0, 2.0),
        "kitchen": (0.0, 2.1, 3.0, 5.0),
        "bathroom": (5.0, 2.1, 8.0, 5.0),
    }
    doors = [
        ("corridor_1", "corridor_2", 4.0, 1.0),
        ("kitchen", "corridor_1", 1.5, 2.05),
        ("bathroom", "corridor_2", 6.5, 2.05),
    ]
    one = make(floor(rooms, doors), "apartment", "robot", 0)
    runs = [label for label, _ in groupby(one.label)]
    assert {"kitchen", "bathroom", "corridor"} < set(runs)
    assert not any(runs[k : k + 3] == ["corridor", "transition", "corridor"] for k in range(len(runs)))
