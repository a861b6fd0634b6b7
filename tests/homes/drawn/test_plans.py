"""Floor plans from many seeds are valid, and invalid settings are rejected."""

from itertools import combinations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from placecat.errors import SettingError
from placecat.settings import read_yaml
from placecat_homes.drawn import arrangements, plans
from placecat_homes.drawn.homes import SETTINGS, Source, Video, name_of
from placecat_homes.drawn.ranges import KINDS, LightRanges, PlanRanges
from placecat_homes.plan_parts import apart

CONTENT = read_yaml(SETTINGS / "drawn.yaml")
RANGES = PlanRanges.of(CONTENT["plan"], "plan", arrangements.ALL)
HOMES = st.builds(name_of, st.integers(1, 1000), st.integers(0, 2**32 - 1))
NUMBERS = st.integers(1, 40)


def only(arrangement):
    return PlanRanges.of(CONTENT["plan"] | {"arrangements": {arrangement: 1}}, "plan", arrangements.ALL)


@pytest.mark.parametrize("arrangement", arrangements.ALL)
@given(name=HOMES, number=NUMBERS)
def test_room_sizes_are_in_range_and_rooms_do_not_overlap(arrangement, name, number):
    content = plans.draw(name, number, only(arrangement))
    rooms = plans.read(content).rooms
    assert {room.kind for room in rooms} == {*KINDS, "corridor"}
    for room in rooms:
        area, side = room.size[0] * room.size[1], min(room.size)
        if room.kind in KINDS:
            (least, most), (shortest, longest) = RANGES.areas[room.kind], RANGES.sides[room.kind]
            assert least - 0.2 <= area <= most + 0.2 and shortest - 0.03 <= side <= longest + 0.03, room
        else:
            assert side >= RANGES.corridor[0] - 0.02, room
    floor = {room.name: room.size[0] * room.size[1] for room in rooms}
    assert sum(floor[name] for name in floor if name.startswith("corridor")) <= 0.221 * sum(floor.values())
    for a, b in combinations(rooms, 2):
        assert apart(a.rect, b.rect) >= 0.1, (a, b)


@given(name=HOMES, number=NUMBERS)
def test_doors_connect_all_rooms_and_the_entrance_leads_outside(name, number):
    plan = plans.read(plans.draw(name, number, RANGES))
    reached = {"living_room_1"}
    for _ in plan.rooms:
        for door in plan.doors:
            if len(door.rooms) == 2 and reached & set(door.rooms):
                reached |= set(door.rooms)
    assert reached == {room.name for room in plan.rooms}
    (entrance,) = [door for door in plan.doors if door.kind == "closed"]
    assert entrance.rooms[0].startswith("corridor")
    x, y = plan.doorway(entrance).middle
    step = {"south": (0, -1), "north": (0, 1), "west": (-1, 0), "east": (1, 0)}[entrance.side]
    outside = (x + step[0], y + step[1])
    for room in plan.rooms:
        x0, y0, x1, y1 = room.rect
        assert not (x0 < outside[0] < x1 and y0 < outside[1] < y1), room


@given(name=HOMES, number=NUMBERS, seed=st.integers(1, 40))
def test_every_room_except_corridors_has_a_window(name, number, seed):
    plan = plans.read(plans.draw(name, number, RANGES)).windowed(seed)
    lit = {window.room for window in plan.windows}
    assert {room.name for room in plan.rooms if room.kind in KINDS} <= lit


@given(name=HOMES, number=NUMBERS)
def test_the_plan_depends_only_on_name_and_number(name, number):
    plan = plans.draw(name, number, RANGES)
    plans.draw(name, number + 1, RANGES)
    assert plans.draw(name, number, RANGES) == plan
    assert plans.draw(name, number + 1, RANGES) != plan


def test_arrangements_are_drawn_with_the_odds_in_the_settings():
    """Odds of 0 exclude an arrangement. The others are drawn equally often, although some fail more often."""
    ranges = PlanRanges.of(
        CONTENT["plan"] | {"arrangements": {"two_rows": 1, "around_living_room": 1}}, "plan", arrangements.ALL
    )
    drawn = [plans.draw(name_of(k, 5), 1, ranges) for k in range(1, 121)]
    # Only the arrangement around the living room has a living room with a door to a bathroom or kitchen.
    around = sum(
        any(door["rooms"] == ["living_room_1", "kitchen_1"] for door in plan["doors"]) for plan in drawn
    )
    assert 40 <= around <= 80


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"depth": [4.5, 3.3]}, r"plan depth must be \[minimum, maximum\] between 2.8 and 8, not"),
        ({"height": [2.0, 2.5]}, "plan height"),
        ({"height": 2.5}, r"plan height must be \[minimum, maximum\], not 2.5"),
        ({"dpeth": [3, 4]}, "no setting 'dpeth'; did you mean 'depth'"),
        ({"bedrooms": {4: 1}}, "plan bedrooms needs odds for some of 1, 2, 3: non-negative numbers"),
        ({"bedrooms": {2: 0}}, "plan bedrooms"),
        ({"arrangements": {"tower": 1}}, "plan arrangements"),
        ({"areas": {"kitchen": [8, 14]}}, r"plan areas bedroom must be \[minimum, maximum\], not None"),
        ({"areas": CONTENT["plan"]["areas"] | {"cellar": [1, 2]}}, "no setting 'cellar'"),
    ],
)
def test_invalid_ranges_raise_an_error(changes, message):
    with pytest.raises(SettingError, match=message):
        PlanRanges.of(CONTENT["plan"] | changes, "plan", arrangements.ALL)


def test_invalid_light_raises_an_error():
    with pytest.raises(SettingError, match="light sunny lamps"):
        LightRanges.of(CONTENT["light"] | {"sunny": CONTENT["light"]["sunny"] | {"lamps": [0, 2]}}, "light")
    with pytest.raises(SettingError, match="no setting 'rain'"):
        LightRanges.of({"rain": {}}, "light")


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"width": 641}, "width and height must be even, not 641x360"),
        ({"height": 10}, "height must be a whole number from 90 to 4096, not 10"),
        ({"frames": 100}, "frames must be"),
        ({"fps": 0}, "fps must be"),
    ],
)
def test_an_invalid_video_raises_an_error(changes, message):
    with pytest.raises(SettingError, match=message):
        Video(**CONTENT["video"] | changes)
    with pytest.raises(SettingError, match=message):
        Source.read(**changes)


def test_ranges_that_fit_no_plan_raise_an_error():
    narrow = PlanRanges.of(
        CONTENT["plan"] | {"areas": CONTENT["plan"]["areas"] | {"kitchen": [50, 60]}},
        "plan",
        arrangements.ALL,
    )
    with pytest.raises(ValueError, match="home 1 of seed 1: no plan fits the ranges of sizes; widen"):
        plans.draw(name_of(1, 1), 1, narrow)
