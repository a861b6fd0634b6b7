"""The lower half of a fitted kitchen: cabinets, appliances and worktop."""

import numpy as np

from placecat_homes.furniture.blocks import block, chance, choose
from placecat_homes.furniture.cookware import pan, pot
from placecat_homes.furniture.dishes import bottle, bowls, plates
from placecat_homes.furniture.stove import stove
from placecat_homes.mesh import Mesh, join
from placecat_homes.parts.arrange import centred, in_a_row
from placecat_homes.parts.kitchens.cooker import hob, oven_front
from placecat_homes.parts.kitchens.design import BLACK, SHADOW, STEEL, WHITE, Design
from placecat_homes.parts.kitchens.fronts import door, doors, drawer
from placecat_homes.parts.kitchens.layout import Unit
from placecat_homes.parts.kitchens.sink import sink, washing_up
from placecat_homes.parts.outlines import textured
from placecat_homes.shapes import box, tube
from placecat_homes.style import Style

PLINTH = 0.1
OVERHANG = 0.025

Hole = tuple[float, float, float, float]


def base(
    rng: np.random.Generator, style: Style, design: Design, units: tuple[Unit, ...], *, cook: bool = True
) -> Mesh:
    """Draw a row of base cabinets with a worktop, a sink and a hob.

    Parameters
    ----------
    rng
        Random number generator.
    style
        Style of the home.
    design
        Design of the kitchen.
    units
        The cabinets in the row.
    cook
        Whether pots may be placed on the hob.

    Returns
    -------
    Mesh
        A row with its back at y = 0.
    """
    parts: list[Mesh] = []
    holes: list[Hole] = []
    gaps: list[tuple[float, float]] = []
    body = design.height - design.thickness
    for unit in units:
        if unit.kind == "cooker" and design.cooker == "range":
            gaps.append((unit.left, unit.right))
            shell = design.appliance if chance(rng, 0.7) else None
            machine = stove(rng, style, width=unit.width - 0.006, height=design.height + 0.005, body=shell)
            parts.append(machine.moved(unit.x, -0.005))
        else:
            parts.append(_cabinet(rng, style, design, unit, body))
        if unit.kind == "cooker":
            if design.cooker == "oven":
                width = min(unit.width - 0.03, 0.8)
                plate = hob(rng, design.hob, width, 0.5, knobs=design.hob == "gas")
                parts.append(plate.moved(unit.x, 0.055, design.height))
            if cook:
                parts.append(
                    _cooking(rng, style).moved(unit.x, 0.3, design.height + 0.05 * (design.hob == "gas"))
                )
        if unit.kind == "sink":
            basin, hole = sink(rng, design.sink, design.metal, unit.width - 0.06, design.depth)
            parts.append(basin.moved(unit.x, 0, design.height))
            holes.append((hole[0] + unit.x, hole[1] + unit.x, hole[2], hole[3]))
            side = choose(rng, (-1, 1))
            x = unit.x + side * min(0.3, unit.width / 2 - 0.05)
            things = washing_up(rng, style)
            things = things.mirrored() if side > 0 else things
            parts.append(things.moved(x, 0.07, design.height + 0.004))
    parts.append(_worktop(design, units, holes, gaps))
    return join(parts)


def _cabinet(rng: np.random.Generator, style: Style, design: Design, unit: Unit, body: float) -> Mesh:
    w, depth = unit.width, design.depth
    height = body - PLINTH
    back = depth - 0.022
    parts = [block(design.plinth, (w, depth - 0.05, PLINTH))]
    if unit.kind == "open":
        return join(parts, _open(rng, style, design, w, height).moved(z=PLINTH)).moved(unit.x)
    drop = 0.17 if unit.kind == "sink" and design.sink != "belfast" else 0.0
    drop = 0.225 if unit.kind == "sink" and design.sink == "belfast" else drop
    skin = block(design.side, (w - 0.002, back, height - drop), (0, 0, PLINTH))
    shadow = block(SHADOW, (w - 0.012, 0.003, height - drop - 0.006), (0, back, PLINTH + 0.003))
    parts += [skin, shadow]
    if drop and design.sink != "belfast":
        for side in (-1, 1):
            parts.append(block(design.side, (0.016, back, drop), (side * (w / 2 - 0.009), 0, body - drop)))
        parts.append(block(design.side, (w, 0.016, drop), (0, back - 0.016, body - drop)))
    low = PLINTH
    if design.handle == "none":
        height -= 0.022
    faces: list[Mesh] = []
    if unit.kind == "cooker":
        face = 0.595
        rest = height - face
        shell = design.appliance
        faces.append(oven_front(rng, style, shell, w, face).moved(z=low + rest))
        if rest > 0.05:
            faces.append(drawer(design, w, rest).moved(z=low))
    elif unit.kind == "dishwasher":
        faces.append(_dishwasher(rng, design, w, height).moved(z=low))
    elif unit.kind == "corner":
        faces.append(block(design.fronts, (w - 0.004, 0.018, height), (0, 0, low)))
    elif unit.kind == "sink":
        leaf = height - drop if design.sink == "belfast" else height
        faces.append(doors(design, w, leaf).moved(z=low))
    elif unit.kind == "doors":
        faces.append(doors(design, w, height, hinge=choose(rng, (-1, 1))).moved(z=low))
    else:
        drawers = 1 if unit.kind == "mixed" else int(rng.integers(3, 5))
        if unit.kind == "mixed":
            top = 0.16
            faces.append(doors(design, w, height - top, hinge=choose(rng, (-1, 1))).moved(z=low))
            faces.append(drawer(design, w, top).moved(z=low + height - top))
        else:
            shares = np.array([1.6, 1.6, 1.0]) if drawers == 3 else np.ones(4)
            z = low
            for share in shares / shares.sum() * height:
                faces.append(drawer(design, w, float(share)).moved(z=z))
                z += float(share)
    return join(parts, join(faces).moved(y=back)).moved(unit.x)


def _open(rng: np.random.Generator, style: Style, design: Design, w: float, height: float) -> Mesh:
    depth, board = design.depth - 0.03, 0.018
    parts = [block(design.side, (board, depth, height), (side * (w - board) / 2, 0, 0)) for side in (-1, 1)]
    parts.append(block(design.side, (w, 0.008, height)))
    levels = [0.0, height * 0.48]
    for z in levels:
        parts.append(block(design.side, (w - 2 * board, depth, board), (0, 0, z)))
        makers = choose(rng, ((bottle,), (pot, pot, pan), (plates, bowls), (pot, bottle)))
        things = [choose(rng, makers)(rng, style) for _ in range(6)]
        things = [
            thing for thing in things if float(thing.size[2]) < height * 0.45 and float(thing.size[1]) < depth
        ]
        parts.append(in_a_row(rng, things, w - 0.06, depth=depth - 0.05).moved(0, 0.05, z + board))
    return join(parts)


def _dishwasher(rng: np.random.Generator, design: Design, w: float, height: float) -> Mesh:
    if chance(rng, 0.4):
        return door(design, w, height)
    shell = choose(rng, (design.appliance, WHITE, STEEL))
    strip = 0.11
    parts = [
        box(w - 0.004, 0.024, height - strip - 0.003, 0.004).of(shell),
        box(w - 0.004, 0.022, strip, 0.004).moved(z=height - strip).of(shell),
        block(SHADOW, (0.22, 0.003, 0.04), (0, 0.022, height - 0.07)),
    ]
    for k in range(5):
        parts.append(
            block(
                BLACK if shell != BLACK else STEEL,
                (0.014, 0.003, 0.014),
                (0.15 + 0.025 * k, 0.022, height - 0.055),
            )
        )
    if chance(rng, 0.5):
        z = height - strip - 0.05
        bar = tube([(-0.2, 0.02, z), (-0.2, 0.055, z), (0.2, 0.055, z), (0.2, 0.02, z)], 0.007, 6)
        parts.append(bar.of(STEEL))
    return join(parts)


def _cooking(rng: np.random.Generator, style: Style) -> Mesh:
    parts = []
    places = [(-0.15, -0.12), (0.15, -0.12), (-0.15, 0.1), (0.15, 0.1)]
    for k in rng.permutation(4)[: int(rng.choice([0, 1, 1, 2, 2]))]:
        thing = pot(rng, style) if chance(rng, 0.65) else pan(rng, style, radius=0.11)
        x, y = places[int(k)]
        parts.append(centred(thing).moved(x, y, 0.01))
    return join(parts)


def _worktop(
    design: Design, units: tuple[Unit, ...], holes: list[Hole], gaps: list[tuple[float, float]]
) -> Mesh:
    start, end = units[0].left, units[-1].right
    front = design.depth + OVERHANG
    stretches = []
    x = start
    for left, right in sorted(gaps):
        if left - x > 0.02:
            stretches.append((x, left))
        x = right
    if end - x > 0.02:
        stretches.append((x, end))
    parts = []
    for left, right in stretches:
        x = left
        for hole in sorted(holes):
            if hole[1] <= left or hole[0] >= right:
                continue
            parts.append(_piece(design, x, hole[0], 0.0, front))
            parts.append(_piece(design, hole[0], hole[1], 0.0, hole[2]))
            if hole[3] < front - 0.01:
                parts.append(_piece(design, hole[0], hole[1], hole[3], front))
            x = hole[1]
        parts.append(_piece(design, x, right, 0.0, front))
    return join(parts)


def _piece(design: Design, left: float, right: float, back: float, front: float) -> Mesh:
    if right - left < 0.002:
        return join()
    piece = box(right - left, front - back, design.thickness, 0).moved((left + right) / 2, back)
    return textured(piece, u=left + 10).moved(z=design.height - design.thickness).of(design.worktop)
