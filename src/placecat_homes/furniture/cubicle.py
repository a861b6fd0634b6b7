"""Lavatory cubicles."""

import numpy as np

from placecat_homes import palette
from placecat_homes.furniture.dispenser import paper_dispenser
from placecat_homes.furniture.toilet import toilet, toilet_brush
from placecat_homes.materials import Material
from placecat_homes.mesh import Mesh, join
from placecat_homes.shapes import box, cylinder, tube
from placecat_homes.style import Style


def cubicle(
    rng: np.random.Generator,
    style: Style,
    *,
    count: int = 2,
    width: float | None = None,
    depth: float | None = None,
    ceramic: Material | None = None,
) -> Mesh:
    """Draw a row of cubicles, each with a toilet and a door that is shut or ajar.

    Parameters
    ----------
    rng
        Random number generator.
    style
        Style of the building.
    count
        Number of cubicles.
    width, depth
        Width and depth of each cubicle in metres; chosen at random if None.
    ceramic
        Material of the toilets; chosen at random if None.

    Returns
    -------
    Mesh
        Cubicles 2 m high, open at the top and raised 0.15 m off the floor.
    """
    width, depth = width or rng.uniform(0.88, 1.0), depth or rng.uniform(1.35, 1.55)
    ceramic = ceramic or palette.ceramic(rng)
    board = (style.fronts, palette.paint(rng), palette.wood(rng), palette.plastic(rng))[int(rng.integers(4))]
    door_material = board if rng.random() < 0.6 else palette.paint(rng)
    metal = style.metal
    low, high, thick = 0.15, 2.0, 0.03
    total = count * width
    kind = str(rng.choice(("close-coupled", "wall-hung", "low")))
    parts = []
    for k in range(count + 1):
        x = k * width - total / 2
        x = min(max(x, -total / 2 + thick / 2), total / 2 - thick / 2)
        parts.append(box(thick, depth - 0.02, high - low, bevel=0.0).moved(x, 0, low).of(board))
        parts.append(tube([(x, depth - 0.06, 0), (x, depth - 0.06, low)], 0.02, 8).of(metal))
        parts.append(
            box(0.12, thick, high - low, bevel=0.0).moved(_inside(x, total), depth - thick, low).of(board)
        )
    parts.append(box(total, 0.04, 0.05, bevel=0.003).moved(0, depth - 0.035, high).of(metal))
    for k in range(count):
        x = (k + 0.5) * width - total / 2
        leaf = width - 0.13
        ajar = 0.0 if rng.random() < 0.2 else float(rng.uniform(45, 88))
        side = float(rng.choice((-1, 1)))
        door = _door(leaf, high - low - 0.03, door_material, metal, side, ajar == 0.0)
        hinge = side * leaf / 2
        door = door.moved(-hinge).turned(ajar * side).moved(x + hinge, depth - thick, low + 0.01)
        parts.append(door)
        bowl = toilet(rng, style, ceramic=ceramic, kind=kind)
        parts.append(bowl.moved(x))
        holder = paper_dispenser(rng, style).turned(-90)
        parts.append(holder.moved(x - width / 2 + thick / 2, min(0.75, depth - 0.3), 0.7))
        parts.append(toilet_brush(rng, style).moved(x + width / 2 - 0.16, 0.03))
    return join(parts)


def grab_rails(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a pair of fold-down grab rails for an accessible toilet. The floor is at z = 0."""
    material = style.metal if rng.random() < 0.5 else palette.WHITE
    path = [(0, 0, 0.88), (0, 0.68, 0.88), (0, 0.74, 0.84), (0, 0.74, 0.78), (0, 0.68, 0.74), (0, 0, 0.74)]
    rail = tube(path, 0.017, 8)
    foot = box(0.1, 0.015, 0.24, bevel=0.003).moved(0, 0, 0.69)
    one = join(rail, foot)
    return join(one.moved(-0.36), one.moved(0.36)).of(material)


def _inside(x: float, total: float) -> float:
    """Clamp x so that a post 12 cm wide stays within the row."""
    return min(max(x, -total / 2 + 0.06), total / 2 - 0.06)


def _door(
    width: float, height: float, material: Material, metal: Material, side: float, locked: bool
) -> Mesh:
    """Draw a door leaf with a knob, a lock, and hinges on the -x or +x side (`side` is -1 or 1)."""
    free = -side * (width / 2 - 0.06)
    sign = Material((0.75, 0.1, 0.1) if locked else (0.1, 0.55, 0.2))
    parts = [
        box(width, 0.028, height, bevel=0.003).of(material),
        cylinder(0.03, 0.012, 12).turned(-90, "x").moved(free, 0.028, 0.92).of(metal),
        box(0.03, 0.004, 0.012, bevel=0.0).moved(free, 0.039, 0.915).of(sign),
        tube([(free, 0.028, 0.82), (free, 0.07, 0.82), (free + side * 0.1, 0.07, 0.82)], 0.01, 6).of(metal),
    ]
    parts += [
        cylinder(0.012, 0.09, 8).moved(side * width / 2, 0.03, z).of(metal) for z in (0.15, height - 0.25)
    ]
    return join(parts)
