"""Walk-in closets."""

from placecat_homes.furniture.blocks import backed, between, chance
from placecat_homes.furniture.box import basket, pile
from placecat_homes.furniture.ceiling_lamp import ceiling_lamp
from placecat_homes.furniture.clothes import shoes
from placecat_homes.furniture.clothes_rail import clothes_rail, coat_hooks
from placecat_homes.furniture.ironing_board import ironing_board
from placecat_homes.furniture.mirror import mirror
from placecat_homes.furniture.rug import mat
from placecat_homes.furniture.suitcase import suitcase
from placecat_homes.furniture.wardrobe_shelf import low_shelf, shoe_rack, wall_board, wardrobe_shelf
from placecat_homes.placing.room import Room
from placecat_homes.rooms.windows import dress_windows


def furnish(room: Room) -> None:
    """Furnish a room as a walk-in closet."""
    rng, style = room.rng, room.style
    dress_windows(room, cloth=0.3)
    height = min(between(rng, 1.95, 2.3), room.height - 0.15)
    for k in range(3):
        span = room.span(tall=True, least=0.7)
        if span is None:
            break
        for share in (1.0, 0.8, 0.6, 0.45):
            width = min(span.length * share - 0.06, 3.0)
            if width < 0.6:
                break
            rail = k > 0 and chance(rng, 0.35)
            model = (
                clothes_rail(rng, style, min(width, 1.4))
                if rail
                else wardrobe_shelf(rng, style, width, height)
            )
            left = span.start + float(model.size[0]) / 2 + 0.03
            ends = [
                left,
                span.start + span.length - float(model.size[0]) / 2 - 0.03,
                span.start + span.length / 2,
            ]
            places = (room.against(model, wall=span.wall, at=at, front=0.45) for at in ends)
            if any(place is not None for place in places):
                break
        else:
            break
    for _ in range(int(rng.integers(1, 3))):
        maker = low_shelf if chance(rng, 0.6) else shoe_rack
        if room.against(maker(rng, style), front=0.2) is None:
            room.against(maker(rng, style, 0.5), front=0.1)
    if chance(rng, 0.5):
        room.against(ironing_board(rng, style, folded_up=chance(rng, 0.75)), front=0.1)
    for _ in range(int(rng.integers(0, 3))):
        room.against(suitcase(rng, style), front=0.05, corner=True)
    if chance(rng, 0.4):
        room.against(pile(rng, style, int(rng.integers(1, 4))), front=0.05, corner=True)
    if chance(rng, 0.35):
        room.against(basket(rng, style), front=0.05)
    _walls(room)
    if chance(rng, 0.4):
        room.against(backed(shoes(rng, style).turned(180)), front=0.0)
    if chance(rng, 0.5):
        room.floor(mat(rng, style, between(rng, 0.6, 0.9), between(rng, 0.45, 0.6)))
    room.ceiling(ceiling_lamp(rng, style))


def _walls(room: Room) -> None:
    """Hang up coats and whatever else fits in the remaining wall space."""
    rng, style = room.rng, room.style
    if chance(rng, 0.4):
        board = wall_board(rng, style)
        room.hang(board, bottom=max(1.85 - float(board.high[2]), 0.1))
    for width in (between(rng, 0.7, 1.0), 0.5, 0.35):
        hooks = coat_hooks(rng, style, width)
        hung = room.hang(hooks, bottom=max(1.75 - float(hooks.high[2]), 0.1))
        if hung is not None and chance(rng, 0.6):
            break
    if chance(rng, 0.7):
        room.hang(mirror(rng, style), bottom=0.4)
