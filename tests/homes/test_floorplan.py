import pytest
import yaml

from placecat.errors import PlacecatError
from placecat_homes.building import build
from placecat_homes.floorplan import FloorPlan
from placecat_homes.render import SETTINGS

PLANS = SETTINGS / "plan"
NAMES = sorted(path.stem for path in PLANS.glob("*.yaml"))
HOME = {"kitchen", "bathroom", "living_room", "dining_room", "bedroom", "corridor"}


def read(name: str) -> FloorPlan:
    content = yaml.safe_load((PLANS / f"{name}.yaml").read_text(encoding="utf-8"))
    return FloorPlan.from_dict(name, content)


def test_plans_have_the_expected_rooms() -> None:
    homes = [name for name in NAMES if name.startswith("home_")]
    apartments = [name for name in NAMES if name.startswith("apartment_")]
    assert len(homes) == 6 and len(apartments) == 3
    for name in homes:
        assert {room.label for room in read(name).rooms} == HOME
    for name in apartments:
        assert {room.label for room in read(name).rooms} == HOME | {"office", "closet"}
    for site, parts in (("north", {"part2", "part4"}), ("south", {"part2", "part3"})):
        plan = read(f"university_{site}")
        kitchens = {room.part for room in plan.rooms if room.label == "kitchen"}
        assert kitchens == ({"part4"} if site == "north" else set())
        for part in parts:
            labels = {room.label for room in plan.rooms if room.part == part}
            assert labels >= {"corridor", "office", "printer_area", "bathroom"}


@pytest.mark.parametrize(
    "name", [pytest.param(name, marks=[] if name == "home_5" else pytest.mark.slow) for name in NAMES]
)
def test_every_room_of_a_plan_is_reachable(name: str) -> None:
    plan = read(name)
    # In empty rooms, walls, doors and door leaves must leave a way through. Room checks the furniture.
    empty = FloorPlan(
        plan.name, plan.height, tuple(_unfurnished(plan)), plan.doors, plan.windows, plan.windowless
    )
    ground = build(empty, 3, unfurnished=True).ground()
    assert ground.names == tuple(room.name for room in plan.rooms)
    for k in range(len(ground.names)):
        assert (ground.free & (ground.room == k)).any()


def _unfurnished(plan: FloorPlan):
    return [type(room)(room.name, "empty", room.rect, room.label, room.part) for room in plan.rooms]


@pytest.mark.parametrize("name", NAMES)
def test_windows_are_in_outer_walls(name: str) -> None:
    plan = read(name).windowed(5)
    for window in plan.windows:
        x0, y0, x1, y1 = plan.room(window.room).rect
        along = (window.start + window.end) / 2
        beyond = {
            "south": (along, y0 - 0.5),
            "north": (along, y1 + 0.5),
            "west": (x0 - 0.5, along),
            "east": (x1 + 0.5, along),
        }[window.side]
        for room in plan.rooms:
            a0, b0, a1, b1 = room.rect
            assert not (a0 <= beyond[0] <= a1 and b0 <= beyond[1] <= b1)


ROOMS = {
    "a": {"kind": "kitchen", "rect": [0, 0, 3, 3]},
    "b": {"kind": "bedroom", "rect": [3.12, 0, 6, 3]},
}
FAR = {"kind": "office", "rect": [9, 0, 12, 3]}


def plan(rooms=None, doors=None) -> dict:
    doors = [{"rooms": ["a", "b"]}] if doors is None else doors
    return {"height": 2.5, "rooms": rooms or ROOMS, "doors": doors}


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (plan({**ROOMS, "c": {"kind": "office", "rect": [2, 1, 4, 2.5]}}), "overlap"),
        (plan(doors=[]), "no door leads to b"),
        (plan({**ROOMS, "c": FAR}, [{"rooms": ["a", "c"]}]), "share no wall"),
        (plan(doors=[{"rooms": ["a", "b"], "kind": "gate"}]), "kind must be one of"),
        (plan(doors=[{"rooms": ["a", "b"], "widht": 1}]), "widht"),
        (plan(doors=[{"rooms": ["a", "x"]}]), "no room 'x'"),
    ],
)
def test_invalid_plans_raise_an_error(content: dict, message: str) -> None:
    with pytest.raises(PlacecatError, match=message):
        FloorPlan.from_dict("home", content)
