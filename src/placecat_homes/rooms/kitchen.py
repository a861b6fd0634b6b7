"""Kitchens with one row of fitted cabinets, or two that meet in a corner, a fridge, and perhaps a table."""

from collections.abc import Sequence

import numpy as np

from placecat_homes.furniture.bar_cart import bar_cart
from placecat_homes.furniture.blocks import between, chance, choose
from placecat_homes.furniture.ceiling_lamp import ceiling_lamp, pendant
from placecat_homes.furniture.china_cabinet import china_cabinet
from placecat_homes.furniture.clock import clock
from placecat_homes.furniture.cookware import hanging_rail
from placecat_homes.furniture.curtain import blind, curtains
from placecat_homes.furniture.dining_set import breakfast_set, dining_set
from placecat_homes.furniture.food import spice_rack
from placecat_homes.furniture.fridge import fridge
from placecat_homes.furniture.island import island
from placecat_homes.furniture.kitchen_shelf import kitchen_shelf
from placecat_homes.furniture.larder import larder, oven_tower
from placecat_homes.furniture.picture import picture, poster
from placecat_homes.furniture.plant import plant
from placecat_homes.furniture.rug import mat
from placecat_homes.furniture.stool import stool
from placecat_homes.furniture.stove import stove
from placecat_homes.furniture.waste_bin import waste_bin
from placecat_homes.mesh import Mesh, join
from placecat_homes.parts.kitchens.base import base
from placecat_homes.parts.kitchens.clutter import worktop_things
from placecat_homes.parts.kitchens.design import Design
from placecat_homes.parts.kitchens.layout import Unit, row, sink_width
from placecat_homes.parts.kitchens.overhead import Window, overhead
from placecat_homes.placing.opening import Span
from placecat_homes.placing.placed import Placed
from placecat_homes.placing.room import Room

DEEP = 0.65
SMALL = 1.2


def furnish(room: Room) -> None:
    """Furnish a room as a kitchen.

    Parameters
    ----------
    room
        An empty room, which is modified in place.
    """
    rng, style = room.rng, room.style
    design = Design.draw(rng, style)
    span = _best_span(room)
    cold: Placed | None = None
    if span is not None:
        start, end = span.start, span.start + span.length
        chill = fridge(rng, style, width=None if span.length > 2.6 else between(rng, 0.55, 0.62))
        cold, start, end = _fridge_at_end(room, chill, span.wall, start, end)
        _rows(room, design, span.wall, start, end, cold)
    if cold is None:
        chill = fridge(rng, style)
        cold = room.against(chill, front=0.6, corner=True) or room.against(
            fridge(rng, style, design="two", width=0.55), front=0.3, corner=True
        )
    if chance(rng, 0.5):
        _opposite(room, design)
    _middle(room, design)
    _walls(room, design)
    _finish(room)


def _best_span(room: Room) -> Span | None:
    """Find a stretch of wall for the main row. It may have windows."""
    return room.span(least=SMALL) or room.span(least=0.9)


def _fridge_at_end(
    room: Room, chill: Mesh, wall: int, start: float, end: float
) -> tuple[Placed | None, float, float]:
    """Place the fridge at one end of a stretch of wall if there is enough wall. Return it and the rest."""
    width = float(chill.size[0])
    if end - start < width + 1.65:
        return None, start, end
    sides = ["start", "end"]
    if chance(room.rng, 0.5):
        sides.reverse()
    for side in sides:
        at = start + width / 2 if side == "start" else end - width / 2
        thing = room.against(chill, wall=wall, at=at, front=0.6)
        if thing is not None:
            gap = width + 0.03
            return (thing, start + gap, end) if side == "start" else (thing, start, end - gap)
    return None, start, end


def _rows(room: Room, design: Design, wall: int, start: float, end: float, cold: Placed | None) -> None:
    """Build the main row and perhaps a second row around a corner."""
    rng = room.rng
    limit = between(rng, 2.6, 4.2)
    whole = room.length(wall)
    at_start, at_end = start < 0.03, end > whole - 0.03
    if end - start > limit:
        if at_start or (not at_end and chance(rng, 0.5)):
            end = start + limit
        else:
            start = end - limit
        at_start, at_end = start < 0.03, end > whole - 0.03
    length = end - start
    corner = _corner(room, wall, at_start, at_end) if length >= 1.5 and chance(rng, 0.65) else None
    first: list[tuple[str, float]] = [("sink", sink_width(rng, length))]
    second: list[tuple[str, float]] = []
    cooker = ("cooker", 0.9 if design.cooker == "range" and length > 3.3 and chance(rng, 0.4) else 0.6)
    hidden = 0.62 if corner is not None else 0.0
    if corner is not None and (length - hidden < 1.5 or chance(rng, 0.45)):
        second.append(("cooker", 0.6))
    else:
        first.append(cooker)
    if length - hidden > 2.3 and chance(rng, 0.6):
        first.append(("dishwasher", 0.6))
    placed = _row(room, design, wall, start, end, first, None if corner is None else corner[0])
    if placed is None:
        _shorter(room, design, wall, start, end)
        return
    if corner is None:
        return
    side, neighbour, free = corner
    reach = min(free, between(rng, 1.2, 2.6))
    done = None
    while reach >= 0.6 and done is None:
        # The second row starts where the first row ends, at the edge of the worktop.
        deep = float(placed.model.high[1]) + 0.03
        total = room.length(neighbour)
        a, b = (total - deep - reach, total - deep) if side == "start" else (deep, deep + reach)
        fixed = second if reach >= 0.6 else []
        done = _row(room, design, neighbour, a, b, fixed, None)
        reach -= 0.3
    if done is None and second:
        _stove_anywhere(room)


def _shorter(room: Room, design: Design, wall: int, start: float, end: float) -> None:
    """Build the longest row that fits into a stretch of wall or, failing that, one against another wall."""
    stretches = [(wall, start, end)]
    span = room.span(least=0.9)
    if span is not None:
        stretches.append((span.wall, span.start, span.start + span.length))
    for number, low, high in stretches:
        for length in np.arange(min(high - low, 3.6), 0.99, -0.25):
            fixed = [("sink", sink_width(room.rng, float(length))), ("cooker", 0.6)]
            if length < 1.1:
                fixed = [("sink", 0.45), ("cooker", 0.5)]
            for at in (low, high - float(length)):
                if _row(room, design, number, at, at + float(length), fixed, None) is not None:
                    return


def _stove_anywhere(room: Room) -> None:
    room.against(stove(room.rng, room.style, width=0.6), front=0.6)


def _corner(room: Room, wall: int, at_start: bool, at_end: bool) -> tuple[str, int, float] | None:
    """Find a wall for a second row.

    Return the end of the main row that it adjoins, its number and its free length.
    """
    found = []
    for side, touching in (("start", at_start), ("end", at_end)):
        if not touching:
            continue
        # The left end of each wall meets the right end of the next one.
        neighbour = (wall + 1) % 4 if side == "start" else (wall - 1) % 4
        total = room.length(neighbour)
        free = total - DEEP
        for opening in room.openings:
            if opening.wall != neighbour or (opening.kind == "window" and opening.sill >= 0.88):
                continue
            near = total - opening.end if side == "start" else opening.start
            free = min(free, near - DEEP - 0.15)
        if free >= 0.9:
            found.append((side, neighbour, free))
    return choose(room.rng, found) if found else None


def _row(
    room: Room,
    design: Design,
    wall: int,
    start: float,
    end: float,
    fixed: Sequence[tuple[str, float]],
    corner: str | None,
) -> Placed | None:
    """Build one row and everything that hangs above it."""
    rng, style = room.rng, room.style
    length, middle = end - start, (start + end) / 2
    windows: list[Window] = []
    for window in room.windows:
        if window.wall == wall and window.start < end and window.end > start:
            windows.append((middle - window.end, middle - window.start, window.sill))
    sink_at = None
    if windows and chance(rng, 0.75):
        sink_at = float(np.clip((windows[0][0] + windows[0][1]) / 2, -length / 2, length / 2))
    corners = () if corner is None else ((1,) if corner == "start" else (-1,))
    units: tuple[Unit, ...] = row(rng, length, fixed, sink_at=sink_at, corners=corners)
    lower = base(rng, style, design, units)
    things = worktop_things(rng, style, design, units)
    front = 0.0 if corner is not None else 0.6
    placed = room.against(join(lower, things), wall=wall, at=middle, front=front)
    if placed is None:
        placed = room.against(lower, wall=wall, at=middle, front=front)
    if placed is None:
        return None
    upper = overhead(rng, style, design, units, windows=windows, ceiling=room.height)
    if len(upper.triangles):
        room.on(placed, upper, 0.0, 0.0, 0.0)
    return placed


def _opposite(room: Room, design: Design) -> None:
    """Build another row of cabinets against a free wall if people can still walk past it."""
    rng = room.rng
    span = room.span(least=0.8)
    if span is None:
        return
    length = min(span.length, between(rng, 0.9, 2.2))
    at_start = span.start < 0.03 or chance(rng, 0.5)
    start = span.start if at_start else span.start + span.length - length
    _row(room, design, span.wall, start, start + length, [], None)


def _walls(room: Room, design: Design) -> None:
    """Put kitchen furniture against walls that are still bare, and hang shelves and rails on them."""
    rng, style = room.rng, room.style
    for _ in range(choose(rng, (1, 1, 2))):
        kind = rng.random()
        if kind < 0.3:
            room.against(oven_tower(rng, style, design=design), front=0.5, corner=True)
        elif kind < 0.6:
            room.against(larder(rng, style), front=0.3)
        elif kind < 0.75:
            room.against(china_cabinet(rng, style, width=between(rng, 0.75, 1.1)), front=0.3)
    for _ in range(choose(rng, (1, 2, 2, 3))):
        kind = rng.random()
        if kind < 0.55:
            shelf = kitchen_shelf(rng, style)
            if room.hang(shelf, bottom=between(rng, 1.3, 1.45)) is None:
                room.hang(kitchen_shelf(rng, style, width=0.55), bottom=1.4)
        elif kind < 0.85:
            room.hang(hanging_rail(rng, style), bottom=between(rng, 1.25, 1.4))
        else:
            room.hang(spice_rack(rng, style), bottom=between(rng, 1.3, 1.45))


def _middle(room: Room, design: Design) -> None:
    """Put a table or an island in the room if there is enough space."""
    rng, style = room.rng, room.style
    kind = rng.random()
    if kind < 0.2 and _island(room, design):
        return
    if kind < 0.5:
        small = dining_set(rng, style, seats=choose(rng, (2, 4)), laid=0.2)
        if room.middle(small, clearance=0.7) is not None:
            return
    if kind < 0.85:
        for seats in (3, 2):
            placed = room.against(breakfast_set(rng, style, seats=seats), front=0.3)
            if placed is not None:
                if chance(rng, 0.5):
                    room.hang(picture(rng, style, width=between(rng, 0.3, 0.5)), bottom=1.35, above=placed)
                return
    if chance(rng, 0.25):
        room.against(bar_cart(rng, style), front=0.3)


def _island(room: Room, design: Design) -> bool:
    rng, style = room.rng, room.style
    width = between(rng, 1.1, 1.8)
    block = island(rng, style, width=width, design=design)
    seat = stool(rng, style, height=0.65)
    number = int(width / 0.55)
    places = [seat.moved((k - (number - 1) / 2) * 0.5, -between(rng, 0.0, 0.15)) for k in range(number)]
    group = join(block, places) if chance(rng, 0.8) else block
    low = float(group.low[1])
    return room.middle(group.moved(y=-low), clearance=0.75) is not None


def _finish(room: Room) -> None:
    """Hang a lamp, a clock, pictures and curtains, and add a bin and plants."""
    rng, style = room.rng, room.style
    lamp = pendant(rng, style) if chance(rng, 0.15) else ceiling_lamp(rng, style)
    room.ceiling(lamp)
    if chance(rng, 0.55):
        room.against(waste_bin(rng, style), front=0.0, corner=True)
    for window in room.windows:
        covered = any(
            thing.wall == window.wall and thing.z < 0.1 and float(thing.model.high[2]) > 0.7
            for thing in room.placed
        )
        if chance(rng, 0.35):
            height = between(rng, 0.3, 0.6)
            room.dress(window, blind(rng, style, width=window.width + 0.06, height=height))
        elif not covered and chance(rng, 0.4):
            room.dress(
                window, curtains(rng, style, width=window.width + 0.3, height=window.top - window.sill + 0.3)
            )
    if chance(rng, 0.5):
        room.hang(clock(rng, style), bottom=1.75)
    for _ in range(int(rng.integers(0, 3))):
        sheet = poster(rng, style) if chance(rng, 0.3) else picture(rng, style, width=between(rng, 0.25, 0.5))
        room.hang(sheet, bottom=between(rng, 1.3, 1.5))
    if chance(rng, 0.25):
        room.against(plant(rng, style), front=0.0, corner=True)
    if chance(rng, 0.3):
        room.floor(mat(rng, style, width=between(rng, 0.8, 1.4), depth=between(rng, 0.5, 0.7)))
