"""Office kitchenettes with a short fitted kitchen, a fridge, a small table and notices."""

from placecat_homes.furniture.blocks import between, chance, choose
from placecat_homes.furniture.chair import chair
from placecat_homes.furniture.coffee_station import coffee_machine, coffee_station
from placecat_homes.furniture.desk_things import mug
from placecat_homes.furniture.dining_table import small_table
from placecat_homes.furniture.fridge import fridge
from placecat_homes.furniture.kitchen_run import kitchen_run
from placecat_homes.furniture.microwave import microwave
from placecat_homes.furniture.plant import plant
from placecat_homes.furniture.recycling import recycling
from placecat_homes.furniture.vending_machine import vending_machine, water_dispenser
from placecat_homes.furniture.waste_bin import waste_bin
from placecat_homes.mesh import Mesh, join
from placecat_homes.placing.placed import Placed
from placecat_homes.placing.room import Room
from placecat_homes.rooms.institution import notices, strip_lights
from placecat_homes.rooms.windows import dress_windows


def furnish(room: Room) -> None:
    """Furnish a room as a kitchenette."""
    rng, style = room.rng, room.style
    area = room.width * room.depth
    dress_windows(room, bare=0.5, cloth=0.2)
    run = _run(room)
    cold = fridge(rng, style)
    if run is None or room.beside(run, cold, side=choose(rng, ("left", "right")), gap=0.02) is None:
        room.against(cold, front=0.6)
    seats = 0 if area < 6 else (1 if area < 12 else int(rng.integers(1, 3)))
    for _ in range(max(seats, int(area > 5))):
        _table(room)
    others = [coffee_station, water_dispenser, recycling, vending_machine, plant]
    weights = [0.5, 0.35, 0.4, 0.25 if area > 8 else 0.0, 0.3]
    for k in rng.permutation(len(others)):
        if chance(rng, weights[k]):
            room.against(others[k](rng, style), front=0.4)
    room.against(waste_bin(rng, style), front=0.1)
    notices(room, int(rng.integers(1, 4)))
    strip_lights(room)


def _run(room: Room) -> Placed | None:
    """Fit a short kitchen onto the longest free stretch of wall."""
    rng, style = room.rng, room.style
    want = between(rng, 1.6, 2.7)
    for tall, shrink in ((True, 1.0), (True, 0.7), (False, 1.0), (False, 0.7)):
        span = room.span(tall=tall, least=1.2)
        if span is None:
            continue
        length = min(max(want * shrink, 1.2), span.length - 0.04)
        if length < 1.15:
            continue
        model = kitchen_run(
            rng,
            style,
            length=length,
            ceiling=room.height,
            wall_cabinets=tall,
            cooker=chance(rng, 0.5),
        )
        end = (
            span.start + length / 2 + 0.02
            if chance(rng, 0.5)
            else span.start + span.length - length / 2 - 0.02
        )
        for at in (end, span.start + span.length / 2):
            placed = room.against(model, wall=span.wall, at=at, front=0.8)
            if placed is not None:
                _top(room, placed, length)
                return placed
    return None


def _top(room: Room, run: Placed, length: float) -> None:
    """Put a microwave oven and a coffee machine on free parts of the worktop."""
    rng, style = room.rng, room.style
    for maker, probability in ((microwave, 0.4), (coffee_machine, 0.8)):
        if not chance(rng, probability):
            continue
        thing = maker(rng, style)
        x = _free(run.model, thing, length)
        if x is not None:
            room.on(run, thing, x, 0.03, 0.905)
            run = Placed(_with(run.model, thing, x), run.x, run.y, run.z, run.turn, run.wall)


def _with(model: Mesh, thing: Mesh, x: float) -> Mesh:
    return join(model, thing.moved(x, 0.03, 0.905))


def _free(model: Mesh, thing: Mesh, length: float) -> float | None:
    """Find a free spot for an object on a worktop."""
    corners = model.vertices[model.triangles]
    low, high = corners.min(axis=1), corners.max(axis=1)
    above = (high[:, 2] > 0.93) & (low[:, 2] < 0.9 + float(thing.high[2])) & (high[:, 1] > 0.05)
    half = float(thing.size[0]) / 2 + 0.02
    x = -length / 2 + half
    while x < length / 2 - half:
        if not (above & (low[:, 0] < x + half) & (high[:, 0] > x - half)).any():
            return x
        x += 0.05
    return None


def _table(room: Room) -> None:
    """Place a small table with chairs in the middle of the room or against a wall."""
    rng, style = room.rng, room.style
    model = small_table(rng, style)
    seat = chair(rng, style)
    placed = room.middle(model, clearance=0.75) if chance(rng, 0.4) else None
    for width, front in ((None, 0.55), (0.75, 0.45), (0.65, 0.2)):
        if placed is None:
            model = model if width is None else small_table(rng, style, width=width)
            placed = room.against(model, front=front)
    if placed is None:
        return
    wide, deep = float(model.size[0]), float(model.size[1])
    middle = float(model.low[1]) + deep / 2
    room.facing(placed, seat, distance=between(rng, -0.1, 0.1))
    for side in (-1, 1):
        if chance(rng, 0.7):
            x = side * (wide / 2 + between(rng, -0.12, 0.1))
            spot = seat.turned(90 * side).moved(side * float(seat.size[1]), middle)
            spot = spot.moved(x)
            inside = Placed(spot, placed.x, placed.y, 0.0, placed.turn).box()
            if min(inside[0], inside[1]) > 0 and inside[2] < room.width and inside[3] < room.depth:
                room.on(placed, spot, 0.0, 0.0, 0.0)
    top = float(model.high[2])
    for _ in range(int(rng.integers(0, 3))):
        cup = mug(rng, style)
        room.on(placed, cup, between(rng, -0.3, 0.3) * wide, middle + between(rng, -0.25, 0.25) * deep, top)
