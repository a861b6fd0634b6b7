"""Dining rooms with a large table, chairs, a lamp above the table, a sideboard and a china cabinet."""

from placecat_homes.furniture.bar_cart import bar_cart
from placecat_homes.furniture.blocks import between, chance, choose
from placecat_homes.furniture.ceiling_lamp import ceiling_lamp, pendant
from placecat_homes.furniture.chair import high_chair
from placecat_homes.furniture.china_cabinet import china_cabinet
from placecat_homes.furniture.clock import clock
from placecat_homes.furniture.curtain import blind, curtains
from placecat_homes.furniture.dining_set import dining_set
from placecat_homes.furniture.floor_lamp import floor_lamp
from placecat_homes.furniture.picture import group, picture
from placecat_homes.furniture.plant import plant
from placecat_homes.furniture.rug import rug
from placecat_homes.furniture.sideboard import sideboard
from placecat_homes.placing.placed import Placed
from placecat_homes.placing.room import Room


def furnish(room: Room) -> None:
    """Furnish a room as a dining room.

    Parameters
    ----------
    room
        An empty room, which is modified in place.
    """
    rng, style = room.rng, room.style
    table = _table(room)
    if table is not None:
        room.ceiling(pendant(rng, style), above=table)
        if chance(rng, 0.35):
            size = sorted((float(table.model.size[0]), float(table.model.size[1])))
            wide = (size[0] + between(rng, 0.1, 0.5), size[1] + between(rng, 0.1, 0.5))
            room.floor(rug(rng, style, width=max(wide), depth=min(wide)), under=table)
    else:
        room.ceiling(ceiling_lamp(rng, style))
    _cabinets(room)
    _finish(room)


def _table(room: Room) -> Placed | None:
    """Place the largest dining set that fits in the middle of the room."""
    rng, style = room.rng, room.style
    area = room.width * room.depth
    largest = 8 if area > 16 else (6 if area > 10.5 else 4)
    for clearance in (0.6, 0.5):
        for seats in (8, 6, 4):
            if seats <= largest:
                placed = room.middle(dining_set(rng, style, seats=seats, laid=0.55), clearance=clearance)
                if placed is not None:
                    return placed
    small = dining_set(rng, style, seats=4, width=1.0, depth=0.8)
    return room.middle(small, clearance=0.35) or room.middle(
        dining_set(rng, style, seats=2, width=0.8, depth=0.75, shape="rectangle"), clearance=0.3
    )


def _cabinets(room: Room) -> None:
    """Place a sideboard, a china cabinet, or both against the walls if there is space."""
    rng, style = room.rng, room.style
    order = ["china", "board"]
    if chance(rng, 0.5):
        order.reverse()
    done = 0
    for kind in order:
        if done and chance(rng, 0.3):
            continue
        widths = sorted((between(rng, 0.75, 1.9) for _ in range(3)), reverse=True)
        for width in widths:
            model = (
                china_cabinet(rng, style, width=min(width, 1.35))
                if kind == "china"
                else sideboard(rng, style, width=width)
            )
            placed = room.against(model, front=0.4)
            if placed is not None:
                done += 1
                if kind == "board" and chance(rng, 0.8):
                    art = (
                        group(rng, style)
                        if chance(rng, 0.25)
                        else picture(rng, style, width=between(rng, 0.5, 1.1))
                    )
                    room.hang(art, bottom=between(rng, 1.35, 1.5), above=placed)
                break


def _finish(room: Room) -> None:
    """Hang curtains, pictures and a clock, and add plants and lamps."""
    rng, style = room.rng, room.style
    for window in room.windows:
        kind = rng.random()
        if kind < 0.6:
            high = window.top + 0.12
            height = high - 0.03 if chance(rng, 0.6) else high - window.sill + 0.15
            room.dress(window, curtains(rng, style, width=window.width + 0.4, height=height))
        elif kind < 0.75:
            room.dress(window, blind(rng, style, width=window.width + 0.06, height=between(rng, 0.3, 0.8)))
    for _ in range(int(rng.integers(1, 4))):
        art = picture(rng, style, width=between(rng, 0.35, 0.9))
        room.hang(art, bottom=between(rng, 1.3, 1.5))
    if chance(rng, 0.3):
        room.against(bar_cart(rng, style), front=0.2)
    if chance(rng, 0.55):
        room.against(plant(rng, style), front=0.0, corner=True)
    if chance(rng, 0.2):
        room.against(floor_lamp(rng, style), front=0.0, corner=True)
    if chance(rng, 0.35):
        room.hang(clock(rng, style), bottom=choose(rng, (1.6, 1.75)))
    if chance(rng, 0.06):
        room.against(high_chair(rng, style), front=0.2)
