"""Home bathrooms."""

import numpy as np

from placecat_homes import palette
from placecat_homes.furniture.bath_mat import bath_mat, pedestal_mat, scales
from placecat_homes.furniture.bathroom_mirror import bathroom_mirror
from placecat_homes.furniture.bathroom_shelf import bathroom_cabinet, bathroom_shelf, bathroom_wall_shelf
from placecat_homes.furniture.bathtub import bathtub
from placecat_homes.furniture.ceiling_lamp import ceiling_lamp
from placecat_homes.furniture.laundry_basket import laundry_basket, laundry_heap
from placecat_homes.furniture.picture import picture
from placecat_homes.furniture.plant import plant
from placecat_homes.furniture.shower import shower
from placecat_homes.furniture.toilet import toilet, toilet_brush
from placecat_homes.furniture.toilet_paper import toilet_paper, toilet_paper_pile, toilet_paper_stand
from placecat_homes.furniture.towel import towel, towel_radiator
from placecat_homes.furniture.wardrobe import hanging_clothes
from placecat_homes.furniture.washbasin import washbasin
from placecat_homes.furniture.washing_machine import washing_machine
from placecat_homes.materials import Material
from placecat_homes.mesh import Mesh, join
from placecat_homes.placing.placed import Placed
from placecat_homes.placing.room import Room
from placecat_homes.rooms.wall_tiles import tile_walls
from placecat_homes.rooms.windows import dress_windows


def furnish(room: Room) -> None:
    """Furnish a room as a bathroom."""
    rng, style = room.rng, room.style
    area = room.width * room.depth
    ceramic, tiles = palette.ceramic(rng), palette.tiles(rng)
    _tile(room, tiles)
    tub = _bath(room, ceramic, tiles, area)
    toilet_place = _toilet(room, ceramic)
    basin = _basin(room, ceramic)
    if area > 6.0 and rng.random() < 0.5 and tub is not None and float(tub.model.size[0]) > 1.3:
        room.against(shower(rng, style, ceramic=ceramic, tiles=tiles, width=0.9), front=0.5, corner=True)
    dress_windows(room, bare=0.4, cloth=0.35)
    if rng.random() < 0.25 + 0.04 * area:
        room.against(washing_machine(rng, style), front=0.5, corner=True)
    _towels(room)
    _storage(room, area)
    _small(room, tub, toilet_place, basin)
    room.ceiling(ceiling_lamp(rng, style))


def _tile(room: Room, tiles: Material) -> None:
    """Tile all walls to about half their height, higher than that, or up to the ceiling."""
    rng = room.rng
    border = palette.paint(rng) if rng.random() < 0.35 else None
    low, high = ((1.1, 1.5), (1.8, 2.2), (2.2, 3.0))[int(rng.choice(3, p=[0.25, 0.4, 0.35]))]
    tile_walls(room, tiles, min(rng.uniform(low, high), room.height - 0.02), border=border)


def _bath(room: Room, ceramic: Material, tiles: Material, area: float) -> Placed | None:
    """Place a bathtub or shower in a corner."""
    rng, style = room.rng, room.style
    if rng.random() < 0.6:
        kind = None if area > 5.0 else "built-in"
        for length in (None, 1.6, 1.5, 1.4):
            for wall_height in (2.0, 0.0):
                model = bathtub(
                    rng,
                    style,
                    ceramic=ceramic,
                    tiles=tiles,
                    kind=kind,
                    length=length,
                    wall_height=wall_height,
                    screen=None if wall_height else "none",
                )
                placed = room.against(model, front=0.5, corner=True)
                if placed is not None:
                    return placed
    for width, shower_kind in ((None, None), (0.9, None), (0.8, "cabin"), (0.75, "curtain")):
        model = shower(rng, style, ceramic=ceramic, tiles=tiles, width=width, kind=shower_kind)
        placed = room.against(model, front=0.45, corner=True)
        if placed is not None:
            return placed
    return None


def _toilet(room: Room, ceramic: Material) -> Placed | None:
    """Place the toilet, with toilet paper on the wall beside it if there is space."""
    rng, style = room.rng, room.style
    for kind, front in ((None, 0.5), (None, 0.45), ("close-coupled", 0.4), ("close-coupled", 0.3)):
        model = toilet(rng, style, ceramic=ceramic, kind=kind)
        side = float(rng.choice((-1, 1)))
        reach = float(model.high[0])
        paper = toilet_paper(rng, style).moved(side * (reach + 0.12), 0, 0.62)
        brush = toilet_brush(rng, style).moved(-side * (reach + 0.08), 0.05)
        alternatives: tuple[Mesh, ...] = (join(model, paper, brush), join(model, paper), model)
        for alternative in alternatives:
            placed = room.against(alternative, front=front)
            if placed is not None:
                if alternative is model:
                    stand = toilet_paper_stand(rng, style)
                    for where in ("left", "right"):
                        if room.beside(placed, stand, side=where) is not None:
                            break
                return placed
    return None


def _basin(room: Room, ceramic: Material) -> Placed | None:
    """Place the washbasin with a mirror above it. Only leave out the mirror if there is no space for both."""
    rng, style = room.rng, room.style
    choices: tuple[tuple[str | None, float | None, float], ...] = (
        (None, None, 0.55),
        (None, 0.7, 0.5),
        ("pedestal", 0.55, 0.45),
        ("wall", 0.5, 0.4),
        ("wall", 0.4, 0.3),
    )
    alone: list[tuple[Mesh, float]] = []
    for kind, width, front in choices:
        basin = washbasin(rng, style, ceramic=ceramic, kind=kind, width=width)
        alone.append((basin, front))
        wide = float(np.clip(float(basin.size[0]) * rng.uniform(0.7, 1.0), 0.38, 1.3))
        mirror = bathroom_mirror(rng, style, width=wide)
        bottom = max(rng.uniform(1.1, 1.25), float(basin.high[2]) + 0.03)
        if bottom + float(mirror.high[2]) < room.height - 0.1:
            placed = room.against(join(basin, mirror.moved(z=bottom)), front=front)
            if placed is not None:
                return placed
    for basin, front in alone:
        placed = room.against(basin, front=front)
        if placed is not None:
            return placed
    return None


def _towels(room: Room) -> None:
    rng, style = room.rng, room.style
    if rng.random() < 0.45:
        room.hang(towel_radiator(rng, style), bottom=rng.uniform(0.25, 0.5))
    for _ in range(int(rng.integers(1, 4))):
        model = towel(rng, style)
        top = rng.uniform(1.35, 1.7)
        if room.hang(model, bottom=top - float(model.high[2])) is None:
            small = towel(rng, style, kind="ring")
            room.hang(small, bottom=1.45 - float(small.high[2]))
    if rng.random() < 0.25:
        robe = hanging_clothes(rng, style)
        room.hang(robe, bottom=max(0.3, 1.75 - float(robe.high[2])))


def _storage(room: Room, area: float) -> None:
    rng, style = room.rng, room.style
    makers = (bathroom_shelf, bathroom_cabinet, bathroom_wall_shelf)
    for _ in range(int(rng.integers(1, 3 if area < 5.5 else 4))):
        maker = makers[int(rng.integers(3))]
        if maker is bathroom_wall_shelf:
            room.hang(maker(rng, style), bottom=rng.uniform(1.15, 1.4))
        else:
            room.against(maker(rng, style), front=0.35, corner=rng.random() < 0.6)


def _small(room: Room, tub: Placed | None, seat: Placed | None, basin: Placed | None) -> None:
    """Add mats, baskets, scales, spare rolls, a plant and a picture."""
    rng, style = room.rng, room.style
    if tub is not None and rng.random() < 0.65:
        mat = bath_mat(rng, style)
        room.on(tub, mat, rng.uniform(-0.2, 0.2), float(tub.model.high[1]) + 0.04, 0.003)
    elif basin is not None:
        room.on(basin, bath_mat(rng, style), 0.0, float(basin.model.high[1]) + 0.03, 0.003)
    if seat is not None and rng.random() < 0.22:
        room.on(seat, pedestal_mat(rng, style), 0.0, float(seat.model.high[1]) - 0.27, 0.003)
    if rng.random() < 0.65:
        room.against(laundry_basket(rng, style), front=0.2, corner=True)
    if rng.random() < 0.35:
        room.against(toilet_paper_pile(rng, style), front=0.2)
    if rng.random() < 0.35:
        room.against(scales(rng, style), front=0.1)
    if rng.random() < 0.3 * style.clutter:
        room.against(laundry_heap(rng, style), front=0.1)
    if rng.random() < 0.3:
        room.against(plant(rng, style, rng.uniform(0.3, 0.8)), front=0.1, corner=True)
    if rng.random() < 0.35:
        room.hang(picture(rng, style, rng.uniform(0.2, 0.4)), bottom=1.45)
