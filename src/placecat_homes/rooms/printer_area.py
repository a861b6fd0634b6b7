"""Printer areas with copiers, printers, paper and waste-paper bins."""

from placecat_homes.furniture.blocks import between, chance, choose
from placecat_homes.furniture.copier import copier
from placecat_homes.furniture.desk import HEIGHT, desk
from placecat_homes.furniture.desk_things import in_tray, loose_papers, paper_stack, pen_cup, small_thing
from placecat_homes.furniture.filing_cabinet import steel_cabinet
from placecat_homes.furniture.paper_stock import paper_boxes, paper_pallet, reams
from placecat_homes.furniture.pigeonholes import pigeonholes
from placecat_homes.furniture.plant import plant
from placecat_homes.furniture.printer import floor_printer, plotter, printer
from placecat_homes.furniture.recycling import paper_bin, recycling, shredder
from placecat_homes.furniture.waste_bin import waste_bin
from placecat_homes.placing.room import Room
from placecat_homes.rooms.institution import notices, strip_lights
from placecat_homes.rooms.windows import dress_windows


def furnish(room: Room) -> None:
    """Furnish a room as a printer area."""
    rng, style = room.rng, room.style
    area = room.width * room.depth
    dress_windows(room, bare=0.5, cloth=0.1)
    first = room.against(copier(rng, style), front=0.7)
    if first is None:
        first = room.against(floor_printer(rng, style), front=0.5)
    if area > 6 and chance(rng, 0.75):
        second = copier(rng, style) if chance(rng, 0.5) else floor_printer(rng, style)
        if first is None or room.beside(first, second, side="left", gap=between(rng, 0.08, 0.3)) is None:
            room.against(second, front=0.6)
    if area > 8 and chance(rng, 0.45):
        room.against(plotter(rng, style), front=0.5)
    _table(room)
    if area > 10:
        _table(room)
    others = [pigeonholes, paper_pallet, steel_cabinet, paper_boxes, shredder]
    weights = [0.5, 0.6, 0.4, 0.8, 0.55]
    for k in rng.permutation(len(others)):
        if chance(rng, weights[k]):
            room.against(others[k](rng, style), front=0.25)
    room.against(choose(rng, (paper_bin, recycling))(rng, style), front=0.2)
    if chance(rng, 0.6):
        room.against(choose(rng, (paper_bin, recycling, waste_bin))(rng, style), front=0.1)
    if chance(rng, 0.2):
        room.against(plant(rng, style), front=0.1, corner=True)
    notices(room, int(rng.integers(1, 4)))
    strip_lights(room)


def _table(room: Room) -> None:
    """Place a table with printers, paper and small objects."""
    rng, style = room.rng, room.style
    for width in (between(rng, 1.2, 1.6), 1.0, 0.8):
        depth = between(rng, 0.6, 0.7)
        placed = room.against(desk(rng, style, width, depth), front=0.5)
        if placed is None:
            continue
        x = -width / 2 + 0.05
        makers = [printer, reams, paper_stack, in_tray, printer, small_thing, loose_papers, pen_cup]
        for k in rng.permutation(len(makers)):
            thing = makers[k](rng, style)
            wide = float(thing.size[0])
            if x + wide > width / 2 - 0.03:
                continue
            back = max(0.02, (depth - float(thing.size[1])) * between(rng, 0.2, 0.5))
            room.on(placed, thing, x - float(thing.low[0]), back - float(thing.low[1]), HEIGHT)
            x += wide + between(rng, 0.03, 0.12)
        return
