"""The upper half of a fitted kitchen: tiles, wall cabinets or shelves, and the range hood."""

from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from placecat_homes.furniture.blocks import between, block, chance, choose
from placecat_homes.furniture.cookware import hanging_rail
from placecat_homes.furniture.dishes import shelf_of_dishes
from placecat_homes.furniture.food import jar, packets, spice_rack
from placecat_homes.furniture.microwave import microwave
from placecat_homes.mesh import Mesh, from_arrays, join
from placecat_homes.parts.arrange import in_a_row
from placecat_homes.parts.kitchens.design import BLACK, SHADOW, STEEL, WHITE, Design
from placecat_homes.parts.kitchens.fronts import doors
from placecat_homes.parts.kitchens.layout import Unit
from placecat_homes.parts.outlines import rectangle, ring, sideways, textured
from placecat_homes.shapes import box, tube
from placecat_homes.style import Style

Window = tuple[float, float, float]
DEPTH = 0.33


def overhead(
    rng: np.random.Generator,
    style: Style,
    design: Design,
    units: tuple[Unit, ...],
    *,
    windows: Sequence[Window] = (),
    ceiling: float = 2.5,
) -> Mesh:
    """Draw everything that hangs on the wall above a row of base cabinets.

    Parameters
    ----------
    rng
        Random number generator.
    style
        Style of the home.
    design
        Design of the kitchen.
    units
        The cabinets below.
    windows
        Left edge, right edge and sill height of each window, in metres.
    ceiling
        Height of the ceiling in metres.

    Returns
    -------
    Mesh
        The upper half at its final height, in the coordinate system of the base cabinets.
    """
    left, right = units[0].left, units[-1].right
    top = min(design.top, ceiling - 0.06)
    cooker = next((unit for unit in units if unit.kind == "cooker"), None)
    blocked = [(a - 0.1, b + 0.1) for a, b, _ in windows]
    parts = [_splash(design, left, right, windows)]
    hooded = cooker is not None and not any(a < cooker.right and cooker.left < b for a, b in blocked)
    if hooded and cooker is not None:
        parts.append(_hood(rng, design, cooker.width, top, ceiling).moved(cooker.x))
        margin = 0.02 if design.overhead in ("cabinets", "glass") else 0.08
        reach = cooker.width / 2 if design.hood in ("box", "flat") else max(0.3, cooker.width / 2) + margin
        blocked.append((cooker.x - reach, cooker.x + reach))
    for start, end in _free(left, right, blocked):
        if end - start < 0.28:
            continue
        parts.append(_stretch(rng, style, design, end - start, top).moved((start + end) / 2))
    return join(parts)


def _free(left: float, right: float, blocked: Sequence[tuple[float, float]]) -> list[tuple[float, float]]:
    free = []
    x = left
    for start, end in sorted(blocked):
        if start > x:
            free.append((x, min(start, right)))
        x = max(x, end)
    if x < right:
        free.append((x, right))
    return free


def _splash(design: Design, left: float, right: float, windows: Sequence[Window]) -> Mesh:
    if design.splash_height == 0:
        return join()
    high = design.height + 0.1 if design.splash_height < 0.2 else design.bottom + 0.01
    material = design.worktop if design.splash_height < 0.2 else design.splash
    edges = sorted(
        {left, right, *(min(max(x, left), right) for a, b, _ in windows for x in (a - 0.02, b + 0.02))}
    )
    parts = []
    for start, end in pairwise(edges):
        middle = (start + end) / 2
        sills = [sill for a, b, sill in windows if a - 0.03 < middle < b + 0.03]
        upper = min([high, *(sill - 0.06 for sill in sills)])
        if upper - design.height > 0.02 and end - start > 0.005:
            piece = textured(box(end - start, 0.01, upper - design.height, 0), u=start + 10)
            parts.append(piece.moved(middle, 0, design.height).of(material))
    return join(parts)


def _hood(rng: np.random.Generator, design: Design, width: float, top: float, ceiling: float) -> Mesh:
    w = max(0.6, min(width, 0.9))
    low = max(design.bottom, 1.5)
    steel = choose(rng, (STEEL, design.appliance, design.appliance))
    if design.hood == "chimney":
        shape = rng.random()
        parts = []
        if shape < 0.5:
            parts.append(box(w, 0.5, 0.05, 0.004).moved(0, 0, low))
            rings = [
                ring([(x, y + 0.25) for x, y in rectangle(w, 0.5)], low + 0.05),
                ring([(x, y + 0.14) for x, y in rectangle(0.25, 0.28)], low + 0.3),
            ]
            parts.append(_flat_sided(rings))
        else:
            parts.append(box(w, 0.48, 0.07, 0.005).moved(0, 0, low))
        rise = max(ceiling - 0.01, low + 0.5) - low - 0.06
        parts.append(box(0.25, 0.28, rise, 0.003).moved(0, 0, low + 0.06))
        body = join(parts).of(steel)
        knobs = [
            block(BLACK if steel != BLACK else STEEL, (0.014, 0.003, 0.014), (0.03 * k, 0.5, low + 0.018))
            for k in (-1, 0, 1)
        ]
        lamps = block(WHITE, (0.3, 0.04, 0.003), (0, 0.36, low - 0.003))
        return join(body, knobs if shape < 0.5 else [], lamps)
    if design.hood == "slant":
        outline = [(0, low), (0.12, low), (0.42, low + 0.42), (0.38, low + 0.47), (0, low + 0.47)]
        body = sideways(outline, w).of(BLACK if chance(rng, 0.6) else STEEL)
        shaft = box(0.24, 0.24, max(ceiling - low - 0.48, 0.05), 0.003).moved(0, 0, low + 0.47).of(steel)
        return join(body, shaft)
    height = top - low - 0.1
    cabinet = join()
    if height > 0.2:
        leaf = doors(design, w, height, upper=True)
        shell = block(design.side, (w - 0.002, DEPTH - 0.02, height))
        cabinet = join(shell, leaf.moved(y=DEPTH - 0.02)).moved(z=low + 0.1)
    if design.hood == "flat":
        body = box(w - 0.004, DEPTH - 0.01, 0.1, 0.003).moved(z=low).of(steel)
        lip = box(w - 0.004, 0.05, 0.045, 0.004).moved(0, DEPTH - 0.01, low).of(steel)
        return join(cabinet, body, lip)
    outline = [(0, low), (0.5, low), (0.5, low + 0.04), (DEPTH, low + 0.1), (0, low + 0.1)]
    body = sideways(outline, w - 0.004).of(steel)
    keys = [
        block(BLACK if steel != BLACK else WHITE, (0.02, 0.003, 0.012), (0.15 + 0.03 * k, 0.499, low + 0.014))
        for k in range(3)
    ]
    return join(cabinet, body, keys)


def _flat_sided(rings: list[np.ndarray]) -> Mesh:
    lower, upper = rings
    parts = []
    for k in range(4):
        following = (k + 1) % 4
        pair = [np.stack([lower[k], lower[following]]), np.stack([upper[k], upper[following]])]
        points = np.concatenate([pair[0], pair[1][::-1]])
        parts.append(from_arrays(points, np.array([[0, 1, 2], [0, 2, 3]]), uv=points[:, [0, 2]]))
    return join(parts)


def _stretch(rng: np.random.Generator, style: Style, design: Design, length: float, top: float) -> Mesh:
    """Draw whatever hangs on a free stretch of wall, centred on x = 0."""
    kind = design.overhead
    if kind in ("cabinets", "glass") and chance(rng, 0.12):
        kind = "shelves"
    if kind == "none":
        if length < 0.5 or chance(rng, 0.3):
            return join()
        if chance(rng, 0.6):
            rail = hanging_rail(rng, style, width=min(length - 0.1, between(rng, 0.5, 1.0)))
            return rail.moved(0, 0.012, design.bottom + 0.22 - float(rail.size[2]))
        return spice_rack(rng, style).moved(0, 0.012, design.bottom - 0.1)
    if kind == "shelves":
        return _shelves(rng, style, design, length, top)
    number = max(1, round(length / between(rng, 0.45, 0.65)))
    width = length / number
    height = top - design.bottom
    parts = []
    for k in range(number):
        x = -length / 2 + width * (k + 0.5)
        what = rng.random()
        if kind == "glass" and what < 0.6:
            cabinet = _glazed(rng, style, design, width, height)
        elif what > 0.9 and width > 0.5:
            cabinet = _niche(rng, style, design, width, height)
        else:
            cabinet = _closed(design, width, height, choose(rng, (-1, 1)))
        parts.append(cabinet.moved(x, 0, design.bottom))
    if chance(rng, 0.3):
        moulding = box(length, DEPTH + 0.015, 0.03, 0.006).moved(z=top - 0.001).of(design.upper_fronts)
        parts.append(moulding)
    return join(parts)


def _closed(design: Design, width: float, height: float, hinge: int) -> Mesh:
    shell = block(design.side, (width - 0.002, DEPTH - 0.024, height))
    shadow = block(SHADOW, (width - 0.012, 0.003, height - 0.012), (0, DEPTH - 0.024, 0.006))
    leaf = doors(design, width, height, hinge=hinge, upper=True)
    return join(shell, shadow, leaf.moved(y=DEPTH - 0.022))


def _case(design: Design, width: float, height: float, levels: Sequence[float]) -> Mesh:
    board = 0.018
    parts = [
        block(design.side, (board, DEPTH - 0.022, height), (side * (width - board) / 2, 0, 0))
        for side in (-1, 1)
    ]
    parts.append(block(design.side, (width, 0.008, height)))
    for z in levels:
        parts.append(block(design.side, (width - 2 * board, DEPTH - 0.026, board), (0, 0, z)))
    return join(parts)


def _glazed(rng: np.random.Generator, style: Style, design: Design, width: float, height: float) -> Mesh:
    number = 2 if height < 0.75 else 3
    pitch = (height - 0.018) / number
    parts = [_case(design, width, height, [pitch * k for k in range(number + 1)])]
    for k in range(number):
        dishes = shelf_of_dishes(rng, style, width=width - 0.05, depth=DEPTH - 0.06, height=pitch - 0.02)
        parts.append(dishes.moved(0, 0.015, pitch * k + 0.018))
    leaf = doors(design, width, height, hinge=choose(rng, (-1, 1)), upper=True, glass=True)
    return join(parts, leaf.moved(y=DEPTH - 0.022))


def _niche(rng: np.random.Generator, style: Style, design: Design, width: float, height: float) -> Mesh:
    """Draw an open compartment for a microwave oven, or for jars and dishes."""
    space = 0.36
    if height < space + 0.2:
        return _closed(design, width, height, 1)
    upper = _closed(design, width, height - space, choose(rng, (-1, 1))).moved(z=space)
    case = _case(design, width, space, (0.0,))
    if chance(rng, 0.6) and width > 0.52:
        machine = microwave(rng, style, width=min(0.5, width - 0.06))
        filling = machine.scaled(1, 0.95, 1)
    else:
        things = [jar(rng, style) for _ in range(5)]
        filling = in_a_row(rng, things, width - 0.06, depth=DEPTH - 0.08)
    return join(upper, case, filling.moved(0, 0.01, 0.018))


def _shelves(rng: np.random.Generator, style: Style, design: Design, length: float, top: float) -> Mesh:
    depth, board = between(rng, 0.2, 0.28), choose(rng, (0.02, 0.03, 0.04))
    parts: list[Mesh] = []
    z = design.bottom - 0.02
    width = length - 0.06
    while z < top - 0.2:
        parts.append(box(width, depth, board, 0.003).moved(0, 0, z).of(design.shelf))
        for x in (-width / 2 + 0.08, width / 2 - 0.08):
            bracket = tube([(x, 0.005, z - 0.1), (x, 0.02, z - 0.02), (x, depth - 0.04, z - 0.004)], 0.006, 6)
            parts.append(bracket.of(design.metal))
        pitch = between(rng, 0.3, 0.38)
        if chance(rng, 0.65):
            row = shelf_of_dishes(rng, style, width=width - 0.04, depth=depth - 0.01, height=pitch - 0.04)
        else:
            count = int(width / 0.14)
            things = [packets(rng, style) if chance(rng, 0.33) else jar(rng, style) for _ in range(count)]
            row = in_a_row(rng, [t for t in things if t.size[2] < pitch - 0.03], width - 0.04, depth=depth)
        parts.append(row.moved(0, 0.004, z + board))
        z += pitch
    if chance(rng, 0.4) and length > 0.7:
        rail = hanging_rail(rng, style, width=min(width - 0.2, 0.9))
        parts.append(rail.moved(0, 0.012, design.bottom - 0.06 - float(rail.size[2])))
    return join(parts)
