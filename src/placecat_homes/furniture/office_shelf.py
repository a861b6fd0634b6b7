"""Office shelves full of binders, books, journals and boxes."""

import numpy as np

from placecat_homes import palette
from placecat_homes.furniture.blocks import between, block, chance, choose
from placecat_homes.materials import Material
from placecat_homes.mesh import Mesh, join
from placecat_homes.parts.drawers import surface
from placecat_homes.parts.prints import ink, leaf
from placecat_homes.shapes import box, lathe, quad
from placecat_homes.style import Style

LABEL = Material((0.93, 0.93, 0.9))
BLACK = Material((0.03, 0.03, 0.03))
CARD = Material((0.66, 0.52, 0.36))
"""Corrugated cardboard."""


def office_shelf(
    rng: np.random.Generator, style: Style, width: float | None = None, height: float | None = None
) -> Mesh:
    """Draw a full office bookcase, sometimes with doors at the bottom.

    Parameters
    ----------
    rng, style
        Random number generator and style of the home.
    width, height
        Size in metres; 0.75 to 1.25 by 1.1 to 2.2 if None.
    """
    width = width or between(rng, 0.75, 1.25)
    height = height or choose(rng, (between(rng, 1.1, 1.3), between(rng, 1.75, 2.2)), (0.3, 0.7))
    depth = between(rng, 0.31, 0.38)
    case = surface(rng, style)
    steel = chance(rng, 0.2)
    if steel:
        case = Material((between(rng, 0.4, 0.85),) * 3, gloss=0.03)
    thick = 0.02 if not steel else 0.008
    levels = max(3, round(height / 0.37))
    step = (height - thick - 0.06) / levels
    closed = 2 if height > 1.6 and chance(rng, 0.3) else 0
    parts = _case(rng, style, width, depth, height, thick, case, steel)
    colours = [ink(rng) for _ in range(int(rng.integers(1, 5)))]
    if chance(rng, 0.5):
        colours += [(0.07, 0.07, 0.08), (0.4, 0.42, 0.45)]
    inner = width - 2 * thick - 0.01
    for level in range(levels):
        z = 0.06 + level * step
        parts.append(block(case, (inner + 0.01, depth - 0.01, thick), (0, 0.005, z)))
        if level < closed:
            continue
        content = shelf_row(rng, inner, min(step - thick, 0.36), depth - 0.04, colours, style)
        parts.append(content.moved(0, 0.02, z + thick))
    if closed:
        front = case if chance(rng, 0.6) else palette.paint(rng)
        tall = closed * step
        for side in (-1, 1):
            door = block(
                front, (width / 2 - 0.004, 0.018, tall - 0.01), (side * width / 4, depth, 0.065), 0.003
            )
            parts.append(door)
            grip = block(style.metal, (0.012, 0.02, 0.1), (side * 0.04, depth + 0.018, tall * 0.75))
            parts.append(grip)
    if height < 1.75 and chance(rng, 0.7):
        parts.append(_on_top(rng, width, colours).moved(0, 0.03, height))
    return join(parts)


def shelf_row(
    rng: np.random.Generator,
    width: float,
    height: float,
    depth: float,
    colours: list[tuple[float, float, float]],
    style: Style,
) -> Mesh:
    """Fill one shelf with binders, books, journals and boxes.

    Parameters
    ----------
    rng, style
        Random number generator and style of the home.
    width, height, depth
        Free space on the shelf in metres.
    colours
        Colours of the binders.
    """
    parts: list[Mesh] = []
    x = -width / 2 + 0.005
    high = min(height - 0.02, 0.32)
    while x < width / 2 - 0.06:
        kind = choose(rng, ("binders", "books", "files", "box", "stack", "gap"), (3, 2.5, 1, 0.8, 0.8, 0.7))
        room = width / 2 - x
        if kind == "binders" and high > 0.29:
            wide = choose(rng, (0.075, 0.052))
            colour = choose(rng, colours)
            for _ in range(min(int(room / wide), int(rng.integers(2, 8)))):
                if chance(rng, 0.25):
                    colour = choose(rng, colours)
                parts.append(_binder(rng, wide - 0.003, high, depth, colour).moved(x + wide / 2))
                x += wide
        elif kind == "books" or (kind == "binders"):
            for _ in range(int(rng.integers(4, 16))):
                wide = between(rng, 0.012, 0.055)
                if x + wide > width / 2 - 0.005:
                    break
                tall = min(high, between(rng, 0.17, 0.31))
                book = box(wide - 0.001, min(depth, tall * 0.72), tall, 0)
                back = depth - min(depth, tall * 0.72) - between(rng, 0.0, 0.03)
                parts.append(book.moved(x + wide / 2, max(back, 0.0)).of(Material(ink(rng), gloss=0.02)))
                if chance(rng, 0.4):
                    sign = quad(wide * 0.7, tall * 0.3).moved(x + wide / 2, depth + 0.001, tall * 0.55)
                    if back > 0 and depth - min(depth, tall * 0.72) - back < 0.002:
                        parts.append(sign.of(LABEL))
                x += wide
        elif kind == "files" and room > 0.1:
            colour = choose(rng, colours)
            for _ in range(min(int(room / 0.085), int(rng.integers(1, 5)))):
                case = Material(colour, gloss=0.02)
                parts.append(block(case, (0.08, depth - 0.03, high * 0.8), (x + 0.042, 0.02, 0)))
                parts.append(block(leaf(rng), (0.06, depth - 0.06, high * 0.86), (x + 0.042, 0.025, 0.01)))
                x += 0.085
        elif kind == "box" and room > 0.36:
            parts.append(_archive_box(rng, 0.33, depth, min(high, 0.27)).moved(x + 0.17))
            x += 0.35
        elif kind == "stack" and room > 0.25:
            tall = between(rng, 0.03, 0.6 * high)
            z = 0.0
            while z < tall:
                thick = between(rng, 0.006, 0.04)
                body = leaf(rng) if chance(rng, 0.6) else Material(ink(rng))
                wide = between(rng, 0.19, 0.22)
                parts.append(block(body, (wide, min(0.28, depth - 0.02), thick), (x + 0.115, 0.015, z)))
                z += thick
            x += 0.24
        else:
            x += between(rng, 0.03, 0.18)
    return join(parts)


def _case(
    rng: np.random.Generator,
    style: Style,
    width: float,
    depth: float,
    height: float,
    thick: float,
    case: Material,
    steel: bool,
) -> list[Mesh]:
    parts = [block(case, (width, depth, 0.025), (0, 0, height - 0.025), 0.002)]
    if steel:
        for x in (-width / 2 + 0.02, width / 2 - 0.02):
            for y in (0.0, depth - 0.03):
                parts.append(block(case, (0.03, 0.03, height), (x, y, 0)))
    else:
        for x in (-width / 2 + thick / 2, width / 2 - thick / 2):
            parts.append(block(case, (thick, depth, height - 0.025), (x, 0, 0), 0.002))
        parts.append(block(case, (width - 2 * thick, depth - 0.04, 0.06), (0, 0.02, 0)))
    if not steel or chance(rng, 0.4):
        back = case if chance(rng, 0.6) else Material((0.88, 0.87, 0.84))
        parts.append(block(back, (width - 0.01, 0.006, height - 0.03), (0, 0, 0.02)))
    return parts


def _binder(
    rng: np.random.Generator, wide: float, high: float, depth: float, colour: tuple[float, float, float]
) -> Mesh:
    deep = min(depth, 0.29)
    y = depth - deep
    skin = Material(colour, gloss=0.02)
    parts = [block(skin, (wide, deep, high), (0, y, 0))]
    tall = high * between(rng, 0.4, 0.55)
    parts.append(quad(wide * 0.75, tall).moved(0, y + deep + 0.001, high * 0.38).of(LABEL))
    if chance(rng, 0.8):
        stripe = Material(ink(rng)) if chance(rng, 0.4) else BLACK
        parts.append(quad(wide * 0.5, tall * 0.08).moved(0, y + deep + 0.002, high * 0.72).of(stripe))
    hole = lathe([(wide * 0.22, 0), (0, 0.0005)], 8).turned(-90, "x")
    parts.append(hole.moved(0, y + deep + 0.0015, high * 0.17).of(BLACK))
    return join(parts)


def _archive_box(rng: np.random.Generator, wide: float, deep: float, high: float) -> Mesh:
    skin = CARD if chance(rng, 0.6) else Material(ink(rng))
    return join(
        block(skin, (wide, deep - 0.01, high), (0, 0, 0)),
        block(skin, (wide + 0.008, deep - 0.002, high * 0.25), (0, 0, high * 0.76)),
        quad(wide * 0.4, high * 0.25).moved(0, deep - 0.008, high * 0.4).of(LABEL),
    )


def _on_top(rng: np.random.Generator, width: float, colours: list[tuple[float, float, float]]) -> Mesh:
    parts = []
    x = -width / 2 + 0.2
    while x < width / 2 - 0.18:
        if chance(rng, 0.4):
            parts.append(_archive_box(rng, 0.32, 0.26, between(rng, 0.15, 0.26)).moved(x))
        elif chance(rng, 0.4):
            parts.append(_binder(rng, 0.075, 0.32, 0.29, choose(rng, colours)).moved(x))
            parts.append(_binder(rng, 0.075, 0.32, 0.29, choose(rng, colours)).moved(x + 0.08))
        x += 0.36
    return join(parts)
