"""A complete building, with furnished rooms, walls, doors, windows and radiators."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy import ndimage

from placecat import lookup
from placecat.errors import PlacecatError
from placecat.seeds import derive
from placecat_homes import palette
from placecat_homes.doorways import doorway
from placecat_homes.floorplan import FloorPlan
from placecat_homes.heating import heat
from placecat_homes.mesh import Mesh, join
from placecat_homes.placing.lattice import CELL, drawn, room_for_person
from placecat_homes.placing.placed import Placed
from placecat_homes.placing.room import Room
from placecat_homes.plan_parts import SIDES, WindowPlan
from placecat_homes.shell import Finish, glaze, shell
from placecat_homes.style import Style
from placecat_homes.walking.ground import DOORWAY, Ground

ROOMS = "placecat_homes.rooms"

_MARGIN = 0.4
_LARGE = 0.45


@dataclass(frozen=True, eq=False)
class Building:
    """A furnished building.

    Attributes
    ----------
    mesh
        The complete building, in the frame of the plan.
    plan
        The plan with all windows.
    rooms
        Rooms in the order of the plan, each in its own frame.
    leaves
        (4, 2) footprints of open door leaves.
    things
        The objects placed in each room.
    """

    mesh: Mesh
    plan: FloorPlan
    rooms: tuple[Room, ...]
    leaves: tuple[NDArray[np.float64], ...]
    things: tuple[tuple[Placed, ...], ...]

    def ground(self) -> Ground:
        """Work out where people can walk.

        Raises
        ------
        PlacecatError
            If a door cannot be reached.
        """
        rects = tuple(room.rect for room in self.plan.rooms)
        bounds = np.array(rects)
        origin = (float(bounds[:, 0].min()) - _MARGIN, float(bounds[:, 1].min()) - _MARGIN)
        nx, ny = np.ceil((bounds[:, 2:].max(axis=0) + _MARGIN - origin) / CELL).astype(int)
        index = np.full((nx, ny), -1, np.int16)
        ways = [way for way in self.plan.doors if way.kind != "closed"]
        places = [self.plan.doorway(way) for way in ways]
        for place in places:
            index[_inside(place.rect, origin, index.shape)] = DOORWAY
        for k, rect in enumerate(rects):
            index[_inside(rect, origin, index.shape)] = k
        solid = index == -1
        for plan, room in zip(self.plan.rooms, self.rooms, strict=True):
            for thing in room.blocking:
                solid |= drawn(thing.corners() + plan.rect[:2], origin, index.shape)
        for leaf in self.leaves:
            solid |= drawn(leaf, origin, index.shape)
        labels, _ = ndimage.label(room_for_person(solid))
        cells = [tuple(int((c - o) / CELL) for c, o in zip(p.middle, origin, strict=True)) for p in places]
        numbers = [int(labels[cell]) for cell in cells]
        main = max(set(numbers) - {0}, key=numbers.count, default=0)
        for way, number in zip(ways, numbers, strict=True):
            if number != main or main == 0:
                raise PlacecatError(f"{self.plan.name}: the door {' - '.join(way.rooms)} cannot be reached")
        order = {room.name: k for k, room in enumerate(self.plan.rooms)}
        return Ground(
            cell=CELL,
            origin=origin,
            free=labels == main,
            room=index,
            names=tuple(room.name for room in self.plan.rooms),
            kinds=tuple(room.label for room in self.plan.rooms),
            rects=rects,
            doors=tuple(
                (order[way.rooms[0]], order[way.rooms[1]], *place.middle)
                for way, place in zip(ways, places, strict=True)
            ),
            windows=tuple(
                (order[window.room], *_window_middle(self.plan, window)) for window in self.plan.windows
            ),
            items=tuple(
                (k, *_middle(thing, plan.rect[:2]))
                for k, (plan, things) in enumerate(zip(self.plan.rooms, self.things, strict=True))
                for thing in things
                if _worth_looking_at(thing, plan_height=self.plan.height)
            ),
        )


def build(plan: FloorPlan, seed: int, *, unfurnished: bool = False) -> Building:
    """Furnish all rooms of a plan and build their walls.

    Parameters
    ----------
    plan
        Plan of the building.
    seed
        Seed of the building. Each room derives its own seed, so that changing one room leaves the others
        unchanged.
    unfurnished
        Leave a room empty if there is no furniture for its kind, instead of raising an error.

    Returns
    -------
    Building
        The building in the frame of the plan.

    Raises
    ------
    PlacecatError
        If there is no furniture for a kind of room.
    """
    plan = plan.windowed(seed)
    furnished = lookup.names(ROOMS, "furnish")
    missing = sorted({room.kind for room in plan.rooms} - set(furnished))
    if missing and not unfurnished:
        raise PlacecatError(f"{plan.name}: no furniture is defined for rooms of kind {', '.join(missing)}")
    style = Style.draw(_rng(plan, seed, "style"))
    rng = _rng(plan, seed, "finish")
    common = palette.flooring(rng), palette.wall(rng)
    rooms, things, finishes, parts = [], [], {}, []
    for room_plan in plan.rooms:
        name = room_plan.name
        openings = plan.openings(name, seed)
        size = (*room_plan.size, plan.height)
        room = Room(room_plan.kind, name, size, openings, style, _rng(plan, seed, "furniture", name))
        if room.kind not in missing:
            lookup.module(ROOMS, room.kind, "the kind of room", "furnish").furnish(room)
        things.append(tuple(room.placed))
        heat(room, derive("radiators", plan.name, seed), _rng(plan, seed, "heating", name))
        finish = Finish.draw(_rng(plan, seed, "finish", name), *common)
        finishes[name] = finish
        x, y = room_plan.rect[:2]
        inside = join(
            room.mesh(),
            shell(room, finish, (x, y)),
            glaze(room, derive("windows", plan.name, seed)),
        )
        parts.append(inside.moved(x, y))
        rooms.append(room)
    leaves = []
    for way in plan.doors:
        mesh, leaf = doorway(plan, way, style, finishes, seed)
        parts.append(mesh)
        if leaf is not None:
            leaves.append(leaf)
    return Building(join(parts), plan, tuple(rooms), tuple(leaves), tuple(things))


def _rng(plan: FloorPlan, seed: int, *names: str) -> np.random.Generator:
    return np.random.default_rng(derive("building", plan.name, seed, *names))


def _inside(
    rect: tuple[float, float, float, float], origin: tuple[float, float], shape: tuple[int, ...]
) -> tuple[slice, slice]:
    """Return the cells whose centres lie in a rectangle."""
    low = [round((rect[k] - origin[k]) / CELL) for k in (0, 1)]
    high = [round((rect[k + 2] - origin[k]) / CELL) for k in (0, 1)]
    return slice(max(low[0], 0), min(high[0], shape[0])), slice(max(low[1], 0), min(high[1], shape[1]))


def _window_middle(plan: FloorPlan, window: WindowPlan) -> tuple[float, float]:
    x0, y0, x1, y1 = plan.room(window.room).rect
    middle = (window.start + window.end) / 2
    return ((middle, y0), (x1, middle), (middle, y1), (x0, middle))[SIDES.index(window.side)]


def _middle(thing: Placed, corner: tuple[float, ...]) -> tuple[float, float, float]:
    b = thing.box()
    x, y, z = (b[0] + b[2]) / 2, (b[1] + b[3]) / 2, (b[4] + b[5]) / 2
    return float(x + corner[0]), float(y + corner[1]), float(z)


def _worth_looking_at(thing: Placed, plan_height: float) -> bool:
    b = thing.box()
    flat_or_hanging = b[5] < 0.1 or thing.z >= plan_height - 0.05
    return not flat_or_hanging and bool(max(b[2] - b[0], b[3] - b[1], b[5] - b[4]) > _LARGE)
