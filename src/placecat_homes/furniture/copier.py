"""Floor-standing office copiers."""

import numpy as np

from placecat_homes import palette
from placecat_homes.furniture.blocks import between, block, chance, choose
from placecat_homes.materials import Material
from placecat_homes.mesh import Mesh, join
from placecat_homes.parts.forming import board
from placecat_homes.parts.outlines import sideways
from placecat_homes.parts.prints import leaf, lying
from placecat_homes.shapes import box, quad, tube
from placecat_homes.style import Style

DARK = Material((0.1, 0.1, 0.11), gloss=0.03)


def copier(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a copier with paper trays, an output tray, a control panel, and a lid with a document feeder.

    Parameters
    ----------
    rng, style
        Random number generator and style of the home.
    """
    body = _shell(rng)
    trim = choose(
        rng, (DARK, Material(palette.shade(body.colour, 0.75), gloss=0.03), _accent(rng)), (2, 2, 1)
    )
    wide, deep = between(rng, 0.58, 0.68), between(rng, 0.6, 0.68)
    trays = int(rng.integers(2, 5))
    low = 0.06 + 0.145 * trays
    slot = between(rng, 0.14, 0.2)
    scan = low + 0.12 + slot
    parts = [block(DARK, (wide - 0.04, deep - 0.06, 0.06), (0, 0.02, 0))]
    for k in range(trays):
        z = 0.06 + 0.145 * k
        parts.append(block(body, (wide, deep - 0.02, 0.145), (0, 0, z)))
        parts.append(block(body, (wide - 0.012, 0.022, 0.133), (0, deep - 0.022, z + 0.006), 0.004))
        parts.append(block(trim, (wide * 0.35, 0.004, 0.035), (0, deep - 0.001, z + 0.085), 0))
        mark = block(Material((0.9, 0.9, 0.9)), (0.035, 0.002, 0.035), (wide * 0.4, deep, z + 0.08))
        parts.append(mark)
    parts.append(block(body, (wide, deep, 0.12), (0, 0, low), 0.006))
    parts.append(block(body, (wide, deep * 0.32, slot), (0, 0, low + 0.12)))
    side = choose(rng, (-1, 1))
    parts.append(block(body, (0.13, deep - 0.03, slot), (side * (wide / 2 - 0.065), 0, low + 0.12)))
    sheets = box(0.3, 0.22, between(rng, 0.004, 0.02), 0).of(leaf(rng, white=0.95))
    parts.append(sheets.turned(-8, "x").moved(-side * 0.08, deep * 0.4, low + 0.165))
    parts.append(block(body, (wide, deep, 0.1), (0, 0, scan), 0.008))
    parts.append(_panel(rng, trim).moved(side * 0.1, deep - 0.03, scan + 0.075))
    if chance(rng, 0.2):
        parts.append(_open_lid(rng, body, trim, wide, deep).moved(z=scan + 0.1))
    else:
        parts.append(_lid(rng, body, trim, wide, deep).moved(z=scan + 0.1))
    if chance(rng, 0.4):
        parts.append(_finisher(rng, body, deep, low + 0.2).moved(-side * (wide / 2 + 0.17), 0.06))
    if chance(rng, 0.5):
        rest = sideways([(0, 0), (0.3, 0.09), (0.3, 0.1), (0, 0.02)], 0.3).turned(90 * side)
        parts.append(rest.of(trim).moved(side * wide / 2, deep * 0.55, low + 0.02))
    whole = join(parts)
    return whole.moved(-float(whole.low[0] + whole.high[0]) / 2, -float(whole.low[1]))


def _shell(rng: np.random.Generator) -> Material:
    tones = ((0.87, 0.86, 0.83), (0.9, 0.91, 0.92), (0.72, 0.73, 0.75), (0.2, 0.2, 0.21), (0.8, 0.78, 0.7))
    return Material(choose(rng, tones, (3, 3, 1.5, 1, 1.5)), gloss=0.03, roughness=0.4)


def _accent(rng: np.random.Generator) -> Material:
    return Material(palette.colour(rng, 0.7, 0.25, 0.7), gloss=0.03)


def _panel(rng: np.random.Generator, trim: Material) -> Mesh:
    wide = between(rng, 0.34, 0.42)
    parts = [box(wide, 0.14, 0.05, 0.008).of(trim)]
    display = Material((0.35, 0.6, 0.85), emission=0.5)
    parts.append(box(0.15, 0.09, 0.003, 0).moved(0.06, 0.025, 0.0495).of(display))
    parts.append(
        box(0.12, 0.015, 0.003, 0).moved(0.06, 0.08, 0.051).of(Material((0.9, 0.9, 0.9), emission=0.4))
    )
    keys = Material((0.75, 0.76, 0.78))
    for i in range(3):
        for j in range(4):
            parts.append(
                box(0.014, 0.012, 0.006, 0).moved(-0.06 - 0.022 * i, 0.03 + 0.022 * j, 0.049).of(keys)
            )
    green = Material((0.1, 0.7, 0.25), emission=0.3)
    parts.append(box(0.025, 0.025, 0.006, 0).moved(-0.14, 0.08, 0.049).of(green))
    return join(parts).turned(-28, "x")


def _lid(rng: np.random.Generator, body: Material, trim: Material, wide: float, deep: float) -> Mesh:
    parts = [block(body, (wide - 0.02, deep - 0.08, 0.03), (0, 0.01, 0.004), 0.008)]
    feeder = sideways(
        [(0.0, 0.0), (0.26, 0.0), (0.26, 0.05), (0.2, 0.1), (0.05, 0.11), (0, 0.08)], deep - 0.1
    )
    parts.append(feeder.turned(-90).moved(-wide / 2 + 0.02, deep / 2 - 0.04, 0.03).of(body))
    tray = box(wide * 0.52, deep * 0.55, 0.01, 0.002).turned(-9, "y").moved(wide * 0.13, deep * 0.14, 0.1)
    parts.append(tray.of(trim))
    if chance(rng, 0.6):
        paper = lying(rng, 0.3, 0.21).turned(-9, "y").moved(wide * 0.1, deep * 0.4, 0.112)
        parts.append(paper)
    return join(parts)


def _open_lid(rng: np.random.Generator, body: Material, trim: Material, wide: float, deep: float) -> Mesh:
    glass = board(wide * 0.75, deep * 0.62, 0.002, 0.01, 2).moved(0, 0.12).of(palette.BLACK_GLASS)
    lid = join(
        block(body, (wide - 0.02, deep - 0.08, 0.05), (0, 0, 0), 0.008),
        block(Material((0.95, 0.95, 0.94)), (wide * 0.8, deep * 0.7, 0.01), (0, 0.08, -0.01)),
    )
    page = lying(rng).moved(0.05, deep * 0.5, 0.003)
    return join(glass, page, lid.turned(between(rng, 50, 70), "x").moved(0, 0.03, 0.02))


def _finisher(rng: np.random.Generator, body: Material, deep: float, high: float) -> Mesh:
    parts = [block(body, (0.3, deep - 0.12, high), (0, 0, 0), 0.006)]
    for k in range(2):
        shelf = box(0.32, deep - 0.18, 0.01, 0).turned(-12, "y").moved(0, 0.03, high + 0.03 + 0.1 * k)
        parts.append(shelf.of(Material(palette.shade(body.colour, 0.8))))
        paper = box(0.28, 0.22, 0.012, 0).turned(-12, "y").moved(0, 0.08, high + 0.042 + 0.1 * k)
        parts.append(paper.of(leaf(rng, white=0.9)))
    parts.append(block(body, (0.02, deep - 0.14, 0.3), (0.14, 0, high)))
    door = quad(0.26, high * 0.7).moved(0, deep - 0.119, high * 0.1)
    parts.append(door.of(Material(palette.shade(body.colour, 0.93))))
    grip = tube([(-0.1, deep - 0.11, high * 0.5), (-0.1, deep - 0.11, high * 0.65)], 0.008, 6)
    return join(parts, grip.of(DARK))
