"""University and home offices."""

import numpy as np

from placecat_homes.furniture.blocks import backed, between, chance, choose
from placecat_homes.furniture.bookshelf import wall_shelf
from placecat_homes.furniture.box import cardboard, pile
from placecat_homes.furniture.ceiling_lamp import ceiling_lamp
from placecat_homes.furniture.clock import clock
from placecat_homes.furniture.coat_stand import coat_stand
from placecat_homes.furniture.computer import tower, workstation
from placecat_homes.furniture.desk import HEIGHT, desk
from placecat_homes.furniture.desk_things import clutter, loose_papers, mug
from placecat_homes.furniture.filing_cabinet import filing_cabinet, steel_cabinet
from placecat_homes.furniture.meeting_table import meeting_table
from placecat_homes.furniture.office_chair import office_chair, visitor_chair
from placecat_homes.furniture.office_shelf import office_shelf
from placecat_homes.furniture.picture import picture
from placecat_homes.furniture.plant import plant
from placecat_homes.furniture.printer import printer
from placecat_homes.furniture.rug import rug
from placecat_homes.furniture.waste_bin import waste_bin
from placecat_homes.furniture.whiteboard import whiteboard
from placecat_homes.mesh import Mesh
from placecat_homes.placing.placed import Placed
from placecat_homes.placing.room import Room
from placecat_homes.rooms.institution import notices, strip_lights
from placecat_homes.rooms.windows import dress_windows


def furnish(room: Room) -> None:
    """Furnish a room as an office."""
    rng, style = room.rng, room.style
    area = room.width * room.depth
    campus = chance(rng, 0.55)
    dress_windows(room, bare=0.3, cloth=0.2 if campus else 0.5)
    seats = 1 if area < 9.5 else (2 if area < 15 and chance(rng, 0.65) else int(rng.integers(1, 4)))
    desks = [placed for _ in range(seats) if (placed := _workplace(room)) is not None]
    _cases(room, area)
    if area > 15 and chance(rng, 0.45):
        _meeting(room)
    for _ in range(int(rng.integers(0, 2 if area < 10 else 3))):
        chair = backed(visitor_chair(rng, style).turned(between(rng, -25, 25)))
        room.against(chair, front=0.3)
    if desks:
        side = choose(rng, ("left", "right"))
        if room.beside(desks[0], waste_bin(rng, style), side=side, gap=0.06) is None:
            room.against(waste_bin(rng, style), front=0.1)
    if chance(rng, 0.45):
        room.against(coat_stand(rng, style), front=0.2, corner=True)
    for _ in range(int(rng.integers(0, 3))):
        room.against(plant(rng, style), front=0.1, corner=True)
    if chance(rng, 0.35):
        room.against((pile if chance(rng, 0.4) else cardboard)(rng, style), front=0.1)
    _walls(room, desks, campus)
    if not campus and chance(rng, 0.4):
        room.floor(rug(rng, style, between(rng, 1.2, 2.0)))
    if campus:
        strip_lights(room)
    else:
        room.ceiling(ceiling_lamp(rng, style))


def _workplace(room: Room) -> Placed | None:
    """Place a desk with everything on it and a chair in front of it."""
    rng, style = room.rng, room.style
    for width in (between(rng, 1.4, 1.8), between(rng, 1.2, 1.4), 1.0):
        model = desk(rng, style, width)
        depth = float(model.size[1])
        placed = room.against(model, front=0.85)
        if placed is None:
            continue
        machine = workstation(rng, style, width, depth)
        room.on(placed, machine, 0.0, 0.0, HEIGHT)
        middle = min(1.0, float(np.ptp(machine.vertices[:, 0])) + 0.06)
        things = clutter(rng, style, width, depth, middle=min(middle, width - 0.5), amount=style.clutter)
        if len(things.triangles):
            room.on(placed, things, 0.0, 0.0, HEIGHT)
        if chance(rng, 0.75):
            case = tower(rng, style)
            x = _gap_below(rng, model, case)
            if x is not None:
                room.on(placed, case, x, 0.12, 0.0)
            else:
                room.beside(placed, case, side=choose(rng, ("left", "right")), gap=0.04)
        seat = backed(office_chair(rng, style).turned(float(rng.normal(0, 22))))
        for distance in (between(rng, 0.0, 0.2), 0.02):
            if room.facing(placed, seat, distance=distance) is not None:
                break
        return placed
    return None


def _gap_below(rng: np.random.Generator, model: Mesh, case: Mesh) -> float | None:
    """Find a place for a computer case under a desk that leaves enough knee room, or return None."""
    corners = model.vertices[model.triangles]
    low, high = corners.min(axis=1), corners.max(axis=1)
    half = float(case.size[0]) / 2 + 0.01
    edge = float(model.size[0]) / 2 - half - 0.03
    inside = (
        (low[:, 2] < float(case.high[2])) & (high[:, 1] > 0.12) & (low[:, 1] < 0.12 + float(case.high[1]))
    )
    for x in rng.permutation([-edge, edge, -edge + 0.08, edge - 0.08, -edge + 0.45, edge - 0.45]):
        if not np.any(inside & (low[:, 0] < x + half) & (high[:, 0] > x - half)):
            return float(x)
    return None


def _cases(room: Room, area: float) -> None:
    """Place shelves and cabinets against the walls, and perhaps a printer on a low cabinet."""
    rng, style = room.rng, room.style
    width = between(rng, 0.75, 1.2)
    count = int(rng.integers(1, 3)) if area < 11 else int(rng.integers(2, 5))
    first: Placed | None = None
    for k in range(count):
        high = None if chance(rng, 0.6) else between(rng, 1.8, 2.15)
        model = office_shelf(rng, style, width if chance(rng, 0.7) else None, high)
        placed = (
            room.beside(first, model, side="left", gap=0.01)
            if first is not None and chance(rng, 0.6)
            else None
        )
        if placed is None:
            placed = room.against(model, front=0.45)
        if placed is None and k == 0:
            placed = room.against(office_shelf(rng, style, 0.65, high), front=0.3)
        first = placed or first
    for maker, probability in ((filing_cabinet, 0.5), (steel_cabinet, 0.35)):
        if not chance(rng, probability):
            continue
        placed = room.against(maker(rng, style), front=0.4)
        if placed is not None and float(placed.model.high[2]) < 1.1 and chance(rng, 0.6):
            device = printer(rng, style)
            if float(device.size[0]) < float(placed.model.size[0]) + 0.02:
                room.on(placed, device, 0.0, 0.0, float(placed.model.high[2]))


def _meeting(room: Room) -> None:
    """Place a free-standing table with chairs."""
    rng, style = room.rng, room.style
    placed = room.middle(meeting_table(rng, style), clearance=0.75, turn=0.0)
    if placed is None:
        return
    middle = float(placed.model.size[1]) / 2
    chair = visitor_chair(rng, style)
    reach = middle + between(rng, 0.05, 0.2) + 0.25
    for angle in (0, 90, 180, 270):
        if chance(rng, 0.75):
            spot = chair.moved(y=-0.27).turned(180).moved(y=reach).turned(angle + float(rng.normal(0, 8)))
            room.on(placed, spot, 0.0, middle, 0.0)
    for thing in (mug(rng, style), loose_papers(rng, style)):
        room.on(placed, thing, between(rng, -0.2, 0.2), middle + between(rng, -0.2, 0.2), HEIGHT)


def _walls(room: Room, desks: list[Placed], campus: bool) -> None:
    """Hang a whiteboard, notices, pictures or shelves."""
    rng, style = room.rng, room.style
    if chance(rng, 0.75 if campus else 0.3):
        for width in (None, 1.0):
            if room.hang(whiteboard(rng, style, width), bottom=between(rng, 0.85, 1.0)) is not None:
                break
    for placed in desks:
        if chance(rng, 0.3):
            room.hang(wall_shelf(rng, style), bottom=between(rng, 1.4, 1.6), above=placed)
    if campus:
        notices(room, int(rng.integers(1, 4)))
    else:
        for _ in range(int(rng.integers(1, 4))):
            room.hang(picture(rng, style), bottom=between(rng, 1.2, 1.5))
        if chance(rng, 0.5):
            notices(room, 1)
        if chance(rng, 0.3):
            room.hang(clock(rng, style), bottom=1.75)
