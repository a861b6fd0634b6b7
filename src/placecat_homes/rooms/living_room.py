"""Living rooms."""

import numpy as np

from placecat_homes.furniture.armchair import armchair
from placecat_homes.furniture.blocks import backed, between, chance, choose
from placecat_homes.furniture.bookshelf import bookshelf, wall_shelf, wall_unit
from placecat_homes.furniture.box import basket
from placecat_homes.furniture.ceiling_lamp import ceiling_lamp, pendant
from placecat_homes.furniture.clock import clock
from placecat_homes.furniture.coffee_table import coffee_table
from placecat_homes.furniture.fireplace import fireplace
from placecat_homes.furniture.floor_lamp import floor_lamp
from placecat_homes.furniture.piano import piano
from placecat_homes.furniture.picture import group, picture
from placecat_homes.furniture.plant import plant
from placecat_homes.furniture.rug import rug
from placecat_homes.furniture.side_table import side_table
from placecat_homes.furniture.sofa import corner_sofa, footstool, sofa
from placecat_homes.furniture.television import speaker, stereo, tv_bench, wall_television
from placecat_homes.furniture.toys import toys
from placecat_homes.mesh import Mesh
from placecat_homes.placing.placed import Placed
from placecat_homes.placing.room import Room
from placecat_homes.rooms.windows import dress_windows


def furnish(room: Room) -> None:
    """Furnish a room as a living room."""
    rng, style = room.rng, room.style
    area = room.width * room.depth
    dress_windows(room, bare=0.1, cloth=0.75)
    television = _television(room, area)
    seat = _sofa(room, television, area)
    if seat is not None:
        _before(room, seat)
    for _ in range(int(rng.integers(1, 3)) if area > 12 else int(rng.integers(0, 2))):
        chair = armchair(rng, style)
        if chance(rng, 0.5):
            chair = backed(chair.turned(between(rng, -30, 30)))
        placed = room.against(chair, front=0.4, corner=chance(rng, 0.6))
        if placed is not None and chance(rng, 0.15):
            room.facing(placed, footstool(rng, style), distance=0.12)
    if seat is not None:
        for side in ("left", "right"):
            if chance(rng, 0.6):
                maker = choose(rng, (side_table, side_table, floor_lamp))
                room.beside(seat, maker(rng, style), side=side, gap=0.05)
    _cases(room, area)
    if chance(rng, 0.65):
        room.against(floor_lamp(rng, style), front=0.2, corner=True)
    for _ in range(int(rng.integers(1, 4))):
        room.against(plant(rng, style), front=0.1, corner=chance(rng, 0.7))
    if chance(rng, 0.25):
        room.against(basket(rng, style), front=0.1)
    if chance(rng, 0.3 * style.clutter):
        room.against(toys(rng, style), front=0.1)
    _walls(room, seat)
    lamp = pendant if room.height > 2.6 and chance(rng, 0.4) else ceiling_lamp
    room.ceiling(lamp(rng, style))


def _television(room: Room, area: float) -> Placed | None:
    rng, style = room.rng, room.style
    longest = max(room.width, room.depth)
    if area > 14 and chance(rng, 0.3):
        unit = wall_unit(rng, style, min(between(rng, 2.0, 3.2), longest - 1.0), screen=True)
        placed = room.against(unit, front=1.2)
        if placed is not None:
            return placed
    hung = chance(rng, 0.25)
    for width in (between(rng, 1.3, 2.0), between(rng, 1.0, 1.3), 0.9):
        placed = room.against(tv_bench(rng, style, min(width, longest - 0.8), hung), front=1.0)
        if placed is None:
            continue
        if hung:
            room.hang(wall_television(rng, style), bottom=between(rng, 0.85, 1.05), above=placed)
        tower = speaker(rng, style, between(rng, 0.75, 1.05))
        if chance(rng, 0.25) and room.beside(placed, tower, side="left", gap=0.08) is not None:
            room.beside(placed, tower, side="right", gap=0.08)
        return placed
    return None


def _sofa(room: Room, television: Placed | None, area: float) -> Placed | None:
    rng, style = room.rng, room.style
    models = []
    if area > 15 and chance(rng, 0.4):
        models.append(corner_sofa(rng, style))
    seats = 3 if area > 13 and chance(rng, 0.7) else 2
    models += [sofa(rng, style, seats), sofa(rng, style, 2)]
    for model in models:
        placed = _opposite(room, television, model) if television is not None else None
        if placed is None:
            placed = room.against(model, front=0.9)
        if placed is not None:
            return placed
    return None


def _opposite(room: Room, television: Placed, model: Mesh) -> Placed | None:
    """Place a sofa facing the television, against the far wall or, in a large room, away from the walls."""
    across = room.depth if television.wall in (0, 2) else room.width
    gap = across - float(television.model.high[1]) - float(model.size[1]) - 0.04
    distances = [gap] if gap < 4.2 else []
    distances += [float(d) for d in room.rng.permutation([2.2, 2.5, 2.9])]
    for distance in distances:
        if 1.3 <= distance <= gap + 0.01:
            placed = room.facing(television, model, distance=distance)
            if placed is not None:
                return placed
    return None


def _before(room: Room, seat: Placed) -> None:
    """Place a rug and a coffee table in front of a sofa."""
    rng, style = room.rng, room.style
    far = seat.model.vertices[seat.model.vertices[:, 1] > 1.25]
    table: Placed | None = None
    for width in (between(rng, 0.85, 1.2), 0.75, 0.6):
        model = coffee_table(rng, style, width)
        if len(far):
            # Put the table inside the corner of an L-shaped sofa.
            side = -float(np.sign(far[:, 0].mean()))
            x = side * (float(seat.model.size[0]) / 2 - 0.25 - float(model.size[0]) / 2)
            table = room.on(seat, model, x, 1.3, 0.0)
        else:
            table = room.facing(seat, model, distance=between(rng, 0.32, 0.42))
        if table is not None:
            break
    if chance(rng, 0.8):
        wide = min(float(seat.model.size[0]) * between(rng, 0.8, 1.15), 2.6)
        cloth = rug(rng, style, wide, wide * between(rng, 0.6, 0.75))
        room.floor(cloth, under=table if table is not None else seat)


def _cases(room: Room, area: float) -> None:
    """Place bookshelves and perhaps a fireplace, piano or stereo against the walls."""
    rng, style = room.rng, room.style
    if area > 13 and chance(rng, 0.25):
        placed = room.against(fireplace(rng, style), front=0.8)
        if placed is not None:
            room.hang(picture(rng, style, between(rng, 0.5, 0.9)), bottom=1.5, above=placed)
    if area > 14 and chance(rng, 0.15):
        room.against(piano(rng, style), front=0.5)
    if chance(rng, 0.15):
        room.against(stereo(rng, style), front=0.3)
    for _ in range(int(rng.integers(1, 3 if area > 12 else 2))):
        span = room.span(tall=True, least=0.6)
        if span is None:
            break
        wide = min(between(rng, 0.6, 2.2), span.length - 0.1)
        model = bookshelf(rng, style, wide)
        at = span.start + (float(model.size[0]) / 2 if chance(rng, 0.5) else span.length / 2)
        if room.against(model, wall=span.wall, at=at, front=0.4) is None:
            room.against(bookshelf(rng, style, 0.7), front=0.4)


def _walls(room: Room, seat: Placed | None) -> None:
    """Hang pictures, a shelf and a clock."""
    rng, style = room.rng, room.style
    if seat is not None and seat.wall is not None and chance(rng, 0.8):
        maker = group if chance(rng, 0.45) else picture
        room.hang(maker(rng, style), bottom=between(rng, 1.15, 1.4), above=seat)
    for _ in range(int(rng.integers(2, 5))):
        model = group(rng, style) if chance(rng, 0.25) else picture(rng, style, between(rng, 0.4, 1.0))
        if room.hang(model, bottom=between(rng, 1.1, 1.4)) is None:
            room.hang(picture(rng, style), bottom=between(rng, 1.2, 1.5))
    if chance(rng, 0.25):
        room.hang(wall_shelf(rng, style), bottom=between(rng, 1.2, 1.5))
    if chance(rng, 0.3):
        room.hang(clock(rng, style), bottom=1.7)
