"""Lavatories in public buildings."""

from placecat_homes import palette
from placecat_homes.furniture.basin_row import basin_row
from placecat_homes.furniture.ceiling_lamp import ceiling_lamp
from placecat_homes.furniture.cubicle import cubicle, grab_rails
from placecat_homes.furniture.dispenser import (
    hand_dryer,
    paper_dispenser,
    soap_box,
    towel_bin,
    towel_dispenser,
)
from placecat_homes.furniture.toilet import toilet, toilet_brush
from placecat_homes.furniture.urinal import urinal
from placecat_homes.materials import Material
from placecat_homes.mesh import join
from placecat_homes.placing.placed import Placed
from placecat_homes.placing.room import Room
from placecat_homes.rooms.wall_tiles import tile_walls


def furnish(room: Room) -> None:
    """Furnish a room as a lavatory with cubicles, urinals, washbasins and accessories."""
    rng, style = room.rng, room.style
    ceramic = palette.ceramic(rng)
    if rng.random() < 0.8:
        tile_walls(room, palette.tiles(rng), min(rng.uniform(1.3, 2.2), room.height - 0.1))
    basins = _basins(room, ceramic)
    area = room.width * room.depth
    if area < 9.0 and rng.random() < 0.55:
        _free_toilet(room, ceramic)
    else:
        _cubicles(room, ceramic, area)
    if rng.random() < 0.6:
        for count in (3, 2, 1):
            if room.against(urinal(rng, style, count=count, ceramic=ceramic), front=0.6) is not None:
                break
    dryer = hand_dryer if rng.random() < 0.5 else towel_dispenser
    for maker, bottom in ((towel_dispenser, 1.15), (dryer, 1.1), (soap_box, 1.05)):
        model = maker(rng, style)
        if basins is not None or maker is not soap_box:
            room.hang(model, bottom=bottom)
    for _ in range(int(rng.integers(1, 3))):
        room.against(towel_bin(rng, style), front=0.2, corner=True)
    room.ceiling(ceiling_lamp(rng, style))


def _free_toilet(room: Room, ceramic: Material) -> Placed | None:
    """Place a toilet without a cubicle, usually with toilet paper and grab rails."""
    rng, style = room.rng, room.style
    kind = str(rng.choice(("close-coupled", "wall-hung", "low")))
    model = toilet(rng, style, ceramic=ceramic, kind=kind)
    reach = max(float(model.high[0]), 0.36)
    paper = paper_dispenser(rng, style).moved(reach + 0.18, 0, 0.75)
    brush = toilet_brush(rng, style).moved(-reach - 0.1, 0.05)
    whole = join(model, paper, brush)
    if rng.random() < 0.6:
        whole = join(whole, grab_rails(rng, style).moved(0, max(0.0, float(model.size[1]) - 0.72)))
    for alternative in (whole, model):
        placed = room.against(alternative, front=0.5)
        if placed is not None:
            return placed
    return None


def _cubicles(room: Room, ceramic: Material, area: float) -> Placed | None:
    """Place as many cubicles as will fit, or a toilet without a cubicle if none fits."""
    rng, style = room.rng, room.style
    most = 4 if area > 14 else 3 if area > 10 else 2
    for count, width, depth, front in (
        (4, 0.9, None, 1.0),
        (3, 0.9, None, 0.9),
        (2, None, None, 0.8),
        (2, 0.88, 1.3, 0.7),
        (1, None, None, 0.7),
        (1, 0.86, 1.25, 0.5),
    ):
        if count > most:
            continue
        model = cubicle(rng, style, count=count, width=width, depth=depth, ceramic=ceramic)
        placed = room.against(model, front=front, corner=True)
        if placed is not None:
            return placed
    return _free_toilet(room, ceramic)


def _basins(room: Room, ceramic: Material) -> Placed | None:
    rng, style = room.rng, room.style
    for count, mirror, front in (
        (3, True, 0.8),
        (2, True, 0.7),
        (2, False, 0.6),
        (1, True, 0.5),
        (1, False, 0.4),
    ):
        if count == 3 and rng.random() < 0.4:
            continue
        placed = room.against(basin_row(rng, style, count=count, ceramic=ceramic, mirror=mirror), front=front)
        if placed is not None:
            return placed
    return None
