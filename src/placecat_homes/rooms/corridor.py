"""Home corridors."""

from placecat_homes import palette
from placecat_homes.furniture.blocks import between, chance, choose
from placecat_homes.furniture.bookshelf import bookshelf
from placecat_homes.furniture.box import basket
from placecat_homes.furniture.ceiling_lamp import ceiling_lamp
from placecat_homes.furniture.clock import clock
from placecat_homes.furniture.coat_rack import coat_rack, hall_wardrobe
from placecat_homes.furniture.coat_stand import coat_stand
from placecat_homes.furniture.console_table import console_table
from placecat_homes.furniture.mirror import mirror
from placecat_homes.furniture.picture import group, picture
from placecat_homes.furniture.plant import plant
from placecat_homes.furniture.rug import mat
from placecat_homes.furniture.shoe_rack import shoe_cabinet, shoe_rack, shoes_on_floor
from placecat_homes.furniture.umbrella_stand import umbrella_stand
from placecat_homes.placing.placed import Placed
from placecat_homes.placing.room import Room
from placecat_homes.rooms.windows import dress_windows
from placecat_homes.shapes import box


def furnish(room: Room) -> None:
    """Furnish a room as a home corridor."""
    rng, style = room.rng, room.style
    longer, shorter = max(room.width, room.depth), min(room.width, room.depth)
    dress_windows(room, bare=0.4, cloth=0.5)
    _coats(room)
    _shoes(room)
    if chance(rng, 0.65):
        _console(room)
    elif chance(rng, 0.6):
        room.hang(mirror(rng, style, None, between(rng, 1.2, 1.6)), bottom=between(rng, 0.35, 0.6))
    if chance(rng, 0.55):
        room.against(umbrella_stand(rng, style), front=0.1)
    if shorter > 1.5 and chance(rng, 0.25):
        room.against(bookshelf(rng, style, between(rng, 0.6, 1.0)), front=0.5)
    if chance(rng, 0.4):
        room.against(plant(rng, style), front=0.1, corner=True)
    if chance(rng, 0.2):
        room.against(basket(rng, style), front=0.1)
    if longer > 5 and chance(rng, 0.4):
        _coats(room)
    for _ in range(int(rng.integers(1, 3 + int(longer / 2)))):
        maker = group if chance(rng, 0.2) else picture
        room.hang(maker(rng, style), bottom=between(rng, 1.2, 1.5))
    if chance(rng, 0.2):
        room.hang(clock(rng, style), bottom=1.8)
    if chance(rng, 0.65):
        _runner(room, longer, shorter)
    doors = [door for door in room.doors if door.passage]
    if doors and chance(rng, 0.6):
        door = doors[int(rng.integers(len(doors)))]
        place = room.point(door.wall, door.middle, 0.12)
        room.placed.append(Placed(mat(rng, style, min(0.75, door.width)), *place, 0.002, 90.0 * door.wall))
    _lamps(room, longer)


def _coats(room: Room) -> None:
    """Hang coats on a wall, or add a coat stand or a hall wardrobe."""
    rng, style = room.rng, room.style
    kinds = ["hooks", "hooks", "unit", "stand"]
    for kind in rng.permutation(kinds):
        if kind == "hooks":
            rack = coat_rack(rng, style)
            top = between(rng, 1.68, 1.85)
            # The board is near the top of the rack, regardless of what hangs from it.
            if room.hang(rack, bottom=max(0.3, top - float(rack.high[2]))) is not None:
                return
        elif kind == "unit":
            if room.against(hall_wardrobe(rng, style), front=0.4) is not None:
                return
        elif room.against(coat_stand(rng, style), front=0.2, corner=True) is not None:
            return
    room.hang(coat_rack(rng, style, 0.5), bottom=0.6)


def _shoes(room: Room) -> None:
    rng, style = room.rng, room.style
    maker = choose(rng, (shoe_rack, shoe_cabinet, shoe_cabinet))
    placed = room.against(maker(rng, style), front=0.3) if chance(rng, 0.8) else None
    if placed is not None and maker is shoe_cabinet and chance(rng, 0.6):
        _mirror_over(room, placed)
    if placed is None or chance(rng, 0.4):
        room.against(shoes_on_floor(rng, style), front=0.05)


def _console(room: Room) -> None:
    rng, style = room.rng, room.style
    for width in (between(rng, 0.8, 1.2), 0.6):
        placed = room.against(console_table(rng, style, width), front=0.4)
        if placed is not None:
            _mirror_over(room, placed)
            return


def _mirror_over(room: Room, placed: Placed) -> None:
    rng, style = room.rng, room.style
    wide = min(float(placed.model.size[0]), between(rng, 0.45, 0.8))
    if chance(rng, 0.7):
        room.hang(mirror(rng, style, wide, between(rng, 0.55, 0.8)), bottom=1.3, above=placed)
    else:
        room.hang(picture(rng, style, wide), bottom=1.35, above=placed)


def _runner(room: Room, longer: float, shorter: float) -> None:
    rng, style = room.rng, room.style
    length = min(longer - 0.6, between(rng, 1.8, 3.6))
    wide = min(shorter - 0.4, between(rng, 0.6, 0.85))
    if wide < 0.4 or length < 1:
        return
    cloth = palette.rug(rng, length, wide) if chance(rng, 0.6) else style.any_fabric(rng)
    room.floor(box(length, wide, 0.01, 0.003).of(cloth))


def _lamps(room: Room, longer: float) -> None:
    """Hang one or more identical lamps along the corridor."""
    lamp = ceiling_lamp(room.rng, room.style)
    count = 1 if longer < 3.6 else (2 if longer < 6.5 else 3)
    for k in range(count):
        along = (k + 0.5) * longer / count
        if room.width >= room.depth:
            room.ceiling(lamp, x=along, y=room.depth / 2)
        else:
            room.ceiling(lamp, x=room.width / 2, y=along)
