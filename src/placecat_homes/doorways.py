"""Doors in their openings."""

import math
from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from placecat.seeds import derive
from placecat_homes.floorplan import FloorPlan
from placecat_homes.furniture.door import door, frame, leaf_corners
from placecat_homes.materials import Material
from placecat_homes.mesh import Mesh, join
from placecat_homes.placing.placed import rotation
from placecat_homes.plan_parts import DoorPlan
from placecat_homes.shapes import box
from placecat_homes.shell import Finish, passage
from placecat_homes.style import Style


def doorway(
    plan: FloorPlan, way: DoorPlan, style: Style, finishes: Mapping[str, Finish], seed: int
) -> tuple[Mesh, NDArray[np.float64] | None]:
    """Build everything that belongs in a door opening.

    Parameters
    ----------
    plan
        Plan of the building.
    way
        The door.
    style
        Style of the building.
    finishes
        Finishes of the rooms, by name.
    seed
        Seed of the building.

    Returns
    -------
    tuple
        The mesh in the frame of the plan, and the (4, 2) footprint of the leaf, or None if there is no leaf.
    """
    place = plan.doorway(way)
    wall, room = place.walls[-1], plan.room(way.rooms[-1])
    x0, y0, x1, y1 = place.rect
    x, y = place.middle
    thick = (y1 - y0) if wall % 2 == 0 else (x1 - x0)
    if wall % 2 == 0:
        y = room.rect[1] if wall == 0 else room.rect[3]
    else:
        x = room.rect[2] if wall == 1 else room.rect[0]
    design = derive("doors", plan.name, seed)
    hinge = plan.hinge(way, seed)
    finish = finishes[room.name]
    floor = finishes[way.rooms[0]].floor
    leaf = None
    if way.kind == "closed":
        mesh = shut(way.width, way.height, style, design, hinge)
    elif way.kind == "open":
        framed = np.random.default_rng(design).random() < 0.5
        mesh = passage(way.width, way.height, thick, None if framed else finish.walls[wall], floor)
        if framed:
            mesh = join(mesh, frame(style, way.width, way.height, thick))
    else:
        rng = np.random.default_rng(derive("angle", plan.name, seed, *way.rooms))
        free = max(plan.corner(way, seed) - 0.12, 0.0) / way.width
        angle = min(float(rng.uniform(84, 97)), 90.0 + math.degrees(math.asin(min(free, 1.0))))
        size = (way.width, way.height, thick)
        made = door(np.random.default_rng(design), style, *size, angle, hinge, way.kind == "glass")
        mesh = join(made, passage(*size, None, floor))
        leaf = leaf_corners(way.width, angle, hinge) @ rotation(90.0 * wall).T + (x, y)
    return mesh.turned(90.0 * wall).moved(x, y), leaf


def shut(width: float, height: float, style: Style, design: int, hinge: str) -> Mesh:
    """Build a closed door with a dark surface behind its gaps.

    Parameters
    ----------
    width, height
        Width and height of the opening in metres.
    style
        Style of the building.
    design
        Seed of the design that all doors of the building share.
    hinge
        "left" or "right".

    Returns
    -------
    Mesh
        The door, in the frame that `door` uses.
    """
    made = door(np.random.default_rng(design), style, width, height, 0.1, 0.0, hinge)
    back = box(width, 0.02, height, 0.0).moved(0, -0.12).of(Material((0.05, 0.05, 0.05)))
    return join(made, back, passage(width, height, 0.1, None, style.trim))
