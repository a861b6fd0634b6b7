"""University hallways."""

import numpy as np

from placecat_homes.furniture.bench import bench
from placecat_homes.furniture.blocks import between, chance, choose
from placecat_homes.furniture.door_sign import door_sign
from placecat_homes.furniture.exit_sign import exit_sign
from placecat_homes.furniture.fire_extinguisher import fire_extinguisher
from placecat_homes.furniture.notice_board import notice_board
from placecat_homes.furniture.office_chair import visitor_chair
from placecat_homes.furniture.plant import plant
from placecat_homes.furniture.recycling import recycling
from placecat_homes.furniture.shut_door import shut_door
from placecat_homes.furniture.vending_machine import vending_machine, water_dispenser
from placecat_homes.furniture.waste_bin import waste_bin
from placecat_homes.placing.opening import Opening
from placecat_homes.placing.room import Room
from placecat_homes.rooms.institution import notices, strip_lights
from placecat_homes.rooms.windows import dress_windows


def furnish(room: Room) -> None:
    """Furnish a hallway with doors, signs, notices and seats."""
    rng, style = room.rng, room.style
    longer = max(room.width, room.depth)
    dress_windows(room, bare=0.8, cloth=0.1)
    for opening in room.doors:
        _sign(room, opening)
    _shut_doors(room)
    for _ in range(1 + int(longer / 9)):
        room.hang(fire_extinguisher(rng, style), bottom=between(rng, 0.45, 0.7))
    for _ in range(max(1, round(longer / between(rng, 4, 7)))):
        room.hang(notice_board(rng, style, between(rng, 0.9, 1.6)), bottom=between(rng, 0.95, 1.1))
    for _ in range(int(rng.integers(1, 2 + int(longer / 4)))):
        kind = choose(rng, ("bench", "bench", "chair", "plant", "bin", "recycling", "water", "vending"))
        if kind == "bench":
            room.against(bench(rng, style), front=0.3)
        elif kind == "chair":
            placed = room.against(visitor_chair(rng, style), front=0.3)
            if placed is not None:
                room.beside(placed, placed.model, side="left", gap=0.05)
        elif kind == "plant":
            room.against(plant(rng, style), front=0.1)
        elif kind == "bin":
            room.against(waste_bin(rng, style), front=0.1)
        elif kind == "recycling":
            room.against(recycling(rng, style), front=0.2)
        elif kind == "water":
            room.against(water_dispenser(rng, style), front=0.4)
        elif longer > 6:
            room.against(vending_machine(rng, style), front=0.6)
    notices(room, round(longer / 3))
    _exits(room, longer)
    strip_lights(room, apart=between(rng, 2.2, 3.2))


def _sign(room: Room, opening: Opening) -> None:
    """Hang a sign beside a door, on the handle side."""
    right = opening.hinge == "left"
    sign = door_sign(room.rng, room.style)
    half = float(sign.size[0]) / 2 + 0.14
    at = opening.end + half if right else opening.start - half
    room.against(sign, wall=opening.wall, at=at, z=1.62 - float(sign.high[2]), front=0.0)


def _shut_doors(room: Room) -> None:
    """Add closed doors with signs along long walls, at some distance from other doors."""
    rng, style = room.rng, room.style
    apart = between(rng, 2.6, 4.2)
    seed = int(rng.integers(1 << 30))
    for wall in range(4):
        length = room.length(wall)
        present = [door.middle for door in room.doors if door.wall == wall]
        if length < 4 or chance(rng, 0.15):
            continue
        for k in range(int(length / apart)):
            at = (k + 0.5) * length / int(length / apart) + between(rng, -0.3, 0.3)
            if any(abs(at - other) < 1.7 for other in present):
                continue
            leaf = shut_door(np.random.default_rng(seed), style)
            placed = room.against(leaf, wall=wall, at=at, front=0.4)
            if placed is not None:
                sign = door_sign(rng, style)
                beside = at + float(leaf.size[0]) / 2 + 0.07 + float(sign.size[0]) / 2
                room.against(sign, wall=wall, at=beside, z=1.62 - float(sign.high[2]), front=0.0)


def _exits(room: Room, longer: float) -> None:
    """Hang illuminated exit signs across the hallway and above a door."""
    rng, style = room.rng, room.style
    if chance(rng, 0.8):
        sign = exit_sign(rng, style, hanging=True)
        along = longer * between(rng, 0.25, 0.75)
        if room.width >= room.depth:
            room.ceiling(sign.turned(90), x=along, y=room.depth / 2)
        else:
            room.ceiling(sign, x=room.width / 2, y=along)
    doors = [door for door in room.doors if door.passage]
    if doors:
        door = doors[int(rng.integers(len(doors)))]
        sign = exit_sign(rng, style)
        if room.height > door.top + 0.35:
            room.against(sign, wall=door.wall, at=door.middle, z=door.top + 0.1, front=0.0)
