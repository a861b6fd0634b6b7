import itertools

import numpy as np
import pytest
from example_room import example

from placecat_homes.placing.opening import Opening
from placecat_homes.placing.placed import Placed
from placecat_homes.placing.room import Room
from placecat_homes.shapes import box

KINDS = ("bedroom", "bathroom", "kitchen", "living_room", "dining_room", "corridor", "office", "closet")


def overlap(a: Placed, b: Placed) -> float:
    p, q = a.box(), b.box()
    sides = np.minimum(p[[2, 3, 5]], q[[2, 3, 5]]) - np.maximum(p[[0, 1, 4]], q[[0, 1, 4]])
    return float(sides.min())


def fill(room: Room) -> list[Placed | None]:
    bed = room.against(box(1.4, 2.0, 0.5), front=0.3)
    chest = room.against(box(0.9, 0.45, 1.1), corner=True)
    tall = room.against(box(1.2, 0.6, 2.1))
    table = room.middle(box(0.8, 0.8, 0.75), clearance=0.4)
    things = [bed, chest, tall, table]
    if bed is not None:
        things += [room.beside(bed, box(0.4, 0.4, 0.5), side=side) for side in ("left", "right")]
        things.append(room.hang(box(0.8, 0.03, 0.5), bottom=1.3, above=bed))
    if chest is not None:
        things.append(room.facing(chest, box(0.5, 0.5, 0.9), distance=0.8))
    things += [room.hang(box(0.6, 0.03, 0.5), bottom=1.4) for _ in range(4)]
    return things


@pytest.mark.parametrize("kind", KINDS)
def test_nothing_overlaps_and_doors_stay_reachable(kind: str) -> None:
    for seed in range(4):
        room = example(kind, seed)
        things = [thing for thing in fill(room) if thing is not None]
        assert things
        assert room.walkable()
        for a, b in itertools.combinations(things, 2):
            assert overlap(a, b) < 0.011
        for thing in things:
            low, high = thing.mesh().low, thing.mesh().high
            assert low.min() > -0.011
            assert high[0] < room.width + 0.011 and high[1] < room.depth + 0.011 and high[2] < room.height


def plain(*openings: Opening) -> Room:
    model = example("bedroom", 0)
    return Room("bedroom", "bedroom_1", (4.0, 3.0, 2.5), openings, model.style, np.random.default_rng(0))


@pytest.mark.parametrize("wall", range(4))
def test_an_object_at_a_wall_faces_into_the_room(wall: int) -> None:
    room = plain()
    thing = room.against(box(0.6, 0.4, 1.0), wall=wall, at=0.5)
    assert thing is not None
    x0, y0, x1, y1 = thing.box()[:4]
    # 0.5 m from the left end of the wall, as seen from inside.
    middle = ((3.5, 0.22), (3.78, 2.5), (0.5, 2.78), (0.22, 0.5))[wall]
    assert ((x0 + x1) / 2, (y0 + y1) / 2) == pytest.approx(middle, abs=1e-6)


def test_only_low_objects_stand_in_front_of_windows() -> None:
    room = plain(Opening(0, 1.0, 3.0, 0.9, 2.1))
    assert room.against(box(1.0, 0.4, 2.0), wall=0, at=2.0) is None
    assert room.hang(box(3.0, 0.03, 0.5), bottom=1.4) is not None
    assert room.against(box(1.0, 0.4, 0.8), wall=0, at=2.0) is not None


def test_an_object_cannot_cut_off_a_door() -> None:
    door = {"sill": 0.0, "top": 2.05, "kind": "door", "passage": True}
    room = plain(Opening(1, 0.3, 1.15, **door), Opening(3, 0.3, 1.15, **door))
    assert room.against(box(2.7, 0.4, 0.8), wall=0, at=2.0) is not None
    # The gap between this object and the first one would be too narrow.
    assert room.against(box(1.0, 2.3, 0.8), wall=2, at=2.0, front=0.0) is None


def test_span_ends_at_doors_and_windows() -> None:
    room = plain(Opening(0, 1.0, 1.9, 0.0, 2.05, "door", False, "left", True), Opening(2, 0.5, 1.5, 0.9, 2.1))
    assert room.span().length == pytest.approx(4.0)
    assert room.span(tall=True).length == pytest.approx(3.0)
    assert room.span(least=4.1) is None


def test_objects_on_a_table_are_placed_in_its_frame() -> None:
    room = plain()
    table = room.against(box(1.0, 0.6, 0.7), wall=1, at=1.0)
    assert table is not None
    cup = room.on(table, box(0.1, 0.1, 0.1), 0.2, 0.3, 0.7)
    assert (cup.x, cup.y, cup.z) == pytest.approx((table.x - 0.3, table.y + 0.2, 0.7))
