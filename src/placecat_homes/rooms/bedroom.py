"""Bedrooms."""

import numpy as np

from placecat_homes.furniture.armchair import armchair
from placecat_homes.furniture.bed import bed
from placecat_homes.furniture.bookshelf import bookshelf, wall_shelf
from placecat_homes.furniture.ceiling_lamp import ceiling_lamp, pendant
from placecat_homes.furniture.chair import chair
from placecat_homes.furniture.clock import clock
from placecat_homes.furniture.dresser import bed_bench, dresser, tall_mirror, vanity_table
from placecat_homes.furniture.floor_lamp import floor_lamp
from placecat_homes.furniture.laundry_basket import heap, laundry_basket, laundry_heap
from placecat_homes.furniture.nightstand import nightstand
from placecat_homes.furniture.picture import group, picture
from placecat_homes.furniture.plant import plant
from placecat_homes.furniture.rug import rug
from placecat_homes.furniture.toys import toys
from placecat_homes.furniture.wardrobe import clothes_rail, hanging_clothes, wardrobe
from placecat_homes.mesh import Mesh, join
from placecat_homes.placing.placed import Placed
from placecat_homes.placing.room import Room
from placecat_homes.rooms.windows import dress_windows


def furnish(room: Room) -> None:
    """Furnish a room as a bedroom."""
    rng, style = room.rng, room.style
    area = room.width * room.depth
    single = bool(rng.random() < (0.5 if area < 10 else 0.2))
    place = _bed(room, single)
    _nightstands(room, place, single)
    closet = _wardrobe(room, area)
    dress_windows(room, bare=0.04, cloth=0.85)
    if closet is None or rng.random() < 0.6:
        for width in (None, 0.9, 0.6):
            if room.against(dresser(rng, style, width=width), front=0.6) is not None:
                break
    if place is not None and rng.random() < 0.25:
        room.facing(
            place, bed_bench(rng, style, width=min(1.3, float(place.model.size[0]) * 0.75)), distance=0.03
        )
    if rng.random() < 0.3 and not single:
        room.against(vanity_table(rng, style), front=0.3)
    _extras(room, area, single)
    _rug(room, place)
    _walls(room, place)
    lamp = pendant if room.height > 2.6 and rng.random() < 0.4 else ceiling_lamp
    room.ceiling(lamp(rng, style))


def _bed(room: Room, single: bool) -> Placed | None:
    """Place the bed, a double usually in the middle of a wall and a single in a corner."""
    rng, style = room.rng, room.style
    widths = (0.9, 1.0, 1.2) if single else (1.4, 1.6, 1.8)
    width = float(rng.choice(widths))
    model = bed(rng, style, width=width)
    if not single and rng.random() < 0.75:
        for wall in (int(k) for k in rng.permutation(4)):
            at = room.length(wall) / 2 + rng.normal(0, 0.12)
            placed = room.against(model, front=0.6, wall=wall, at=at)
            if placed is not None:
                return placed
    for narrower, front in ((width, 0.6), (min(width, 1.4), 0.5), (0.9, 0.4), (0.8, 0.2)):
        placed = room.against(
            bed(rng, style, width=narrower), front=front, corner=bool(narrower < 1.3 and rng.random() < 0.8)
        )
        if placed is not None:
            return placed
    return None


def _nightstands(room: Room, place: Placed | None, single: bool) -> None:
    if place is None:
        return
    rng, style = room.rng, room.style
    seed = int(rng.integers(1 << 30))
    sides = ["left", "right"]
    rng.shuffle(sides)
    wanted = 1 if single or rng.random() < 0.2 else 2
    for side in sides:
        if wanted == 0:
            return
        if (
            room.beside(place, nightstand(rng, style, seed=seed), side=side, gap=rng.uniform(0.03, 0.1))
            is not None
        ):
            wanted -= 1


def _wardrobe(room: Room, area: float) -> Placed | None:
    rng, style = room.rng, room.style
    kind: str | None = None
    for widest in (2.4 if area > 12 else 1.9, 1.4, 1.0, 0.8):
        width = widest * rng.uniform(0.75, 1.0)
        height = min(room.height - 0.12, rng.uniform(1.95, 2.3))
        if kind is None and width < 1.4:
            kind = "hinged" if rng.random() < 0.75 else "open"
        model = wardrobe(rng, style, width=width, kind=kind, height=height)
        placed = room.against(model, front=0.6, corner=bool(rng.random() < 0.75))
        if placed is not None:
            return placed
    return None


def _worn(room: Room) -> Mesh:
    """Draw a chair with a heap of clothes on its seat."""
    rng, style = room.rng, room.style
    model = chair(rng, style, armrests=False)
    cloth = style.any_fabric(rng)
    middle = (model.low + model.high) / 2
    seat = heap(rng, cloth, 0.4, 0.14).moved(float(middle[0]), float(middle[1]), 0.46)
    return join(model, seat)


def _extras(room: Room, area: float, single: bool) -> None:
    rng, style = room.rng, room.style
    if rng.random() < 0.4 * style.clutter + 0.1:
        room.against(_worn(room), front=0.2)
    elif area > 13 and rng.random() < 0.35:
        room.against(armchair(rng, style), front=0.4, corner=True)
    if single and rng.random() < 0.45:
        room.against(bookshelf(rng, style), front=0.4)
        if rng.random() < 0.6:
            room.against(toys(rng, style), front=0.1)
    if rng.random() < 0.3:
        room.against(tall_mirror(rng, style), front=0.3)
    if rng.random() < 0.12:
        room.against(clothes_rail(rng, style), front=0.3)
    if rng.random() < 0.35:
        room.against(laundry_basket(rng, style), front=0.2, corner=True)
    if rng.random() < 0.35 * style.clutter:
        room.against(laundry_heap(rng, style), front=0.05)
    if rng.random() < 0.4:
        room.against(plant(rng, style), front=0.1, corner=True)
    if rng.random() < 0.2:
        room.against(floor_lamp(rng, style), front=0.2, corner=True)


def _rug(room: Room, place: Placed | None) -> None:
    """Lay a rug partly under the bed, beside the bed, or on a clear area of floor."""
    rng, style = room.rng, room.style
    choice = rng.random()
    if place is not None and choice < 0.4:
        wide = float(place.model.size[0]) + rng.uniform(0.9, 1.4)
        deep = rng.uniform(1.4, 1.9)
        if np.isclose(place.turn % 180, 0.0):
            wide = min(wide, room.width - 0.3)
        else:
            wide = min(wide, room.depth - 0.3)
        room.on(
            place,
            rug(rng, style, wide, deep),
            0.0,
            float(place.model.high[1]) - deep + rng.uniform(0.2, 0.5),
            0.002,
        )
    elif place is not None and choice < 0.65:
        model = rug(rng, style, rng.uniform(0.6, 0.8), rng.uniform(1.1, 1.5))
        side = float(rng.choice((-1, 1)))
        x = side * (float(place.model.size[0]) / 2 + float(model.size[0]) / 2 + 0.05)
        here = model.moved(x, 0.6).turned(place.turn).moved(place.x, place.y)
        if _within(room, here):
            room.on(place, model, x, 0.6, 0.002)
    elif choice < 0.9:
        room.floor(rug(rng, style))


def _within(room: Room, mesh: Mesh) -> bool:
    low, high = mesh.low, mesh.high
    return bool(low[0] > 0 and low[1] > 0 and high[0] < room.width and high[1] < room.depth)


def _walls(room: Room, place: Placed | None) -> None:
    rng, style = room.rng, room.style
    if place is not None and rng.random() < 0.7:
        choice = rng.random()
        if choice < 0.45:
            art = picture(rng, style, rng.uniform(0.6, 1.1))
        elif choice < 0.8:
            art = group(rng, style)
        else:
            art = wall_shelf(rng, style)
        room.hang(art, bottom=max(1.35, float(place.model.high[2]) + 0.15), above=place)
    for _ in range(int(rng.integers(0, 4))):
        room.hang(picture(rng, style), bottom=rng.uniform(1.25, 1.5))
    if rng.random() < 0.15:
        room.hang(clock(rng, style), bottom=1.7)
    if rng.random() < 0.3:
        robe = hanging_clothes(rng, style)
        room.hang(robe, bottom=max(0.3, 1.75 - float(robe.high[2])))
