"""Desktop printers, floor-standing printers and plotters."""

import math

import numpy as np

from placecat_homes import palette
from placecat_homes.furniture.blocks import between, block, chance, choose
from placecat_homes.materials import Material
from placecat_homes.mesh import Mesh, join
from placecat_homes.parts.outlines import sideways
from placecat_homes.parts.prints import leaf, lying, poster
from placecat_homes.shapes import box, cylinder, quad, sheet, tube
from placecat_homes.style import Style

DARK = Material((0.08, 0.08, 0.09), gloss=0.03)


def printer(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a desktop laser printer, or an inkjet printer with a scanner."""
    skin = _skin(rng)
    return _laser(rng, skin) if chance(rng, 0.6) else _inkjet(rng, skin)


def floor_printer(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a floor-standing printer on a stack of paper drawers with castors."""
    skin = _skin(rng)
    top = _laser(rng, skin, large=True)
    wide, deep = float(top.size[0]), float(top.high[1])
    parts = []
    z = 0.07
    for _ in range(int(rng.integers(2, 4))):
        parts.append(block(skin, (wide, deep - 0.02, 0.15), (0, 0, z)))
        parts.append(block(skin, (wide - 0.01, 0.02, 0.14), (0, deep - 0.02, z + 0.005), 0.004))
        parts.append(block(DARK, (0.18, 0.004, 0.03), (0, deep - 0.001, z + 0.1)))
        z += 0.15
    for x in (-wide / 2 + 0.06, wide / 2 - 0.06):
        for y in (0.06, deep - 0.08):
            parts.append(cylinder(0.034, 0.03, 10).turned(90, "y").moved(x - 0.015, y, 0.035).of(DARK))
    return join(parts, top.moved(z=z))


def plotter(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a large-format plotter on a stand, with a printed sheet hanging out."""
    wide = between(rng, 1.1, 1.6)
    skin, trim = _skin(rng), choose(rng, (DARK, palette.plastic(rng)))
    parts = [
        sideways([(0, 0), (0.42, 0), (0.46, 0.1), (0.38, 0.22), (0.1, 0.24), (0, 0.18)], wide - 0.3)
        .moved(0, 0.1, 0.85)
        .of(skin)
    ]
    for side in (-1, 1):
        end = sideways([(0, 0), (0.44, 0), (0.49, 0.1), (0.4, 0.25), (0.08, 0.27), (0, 0.2)], 0.17)
        parts.append(end.moved(side * (wide / 2 - 0.085), 0.09, 0.84).of(trim if side > 0 else skin))
        x = side * (wide / 2 - 0.12)
        parts.append(block(DARK, (0.06, 0.08, 0.8), (x, 0.25, 0.06)))
        parts.append(block(DARK, (0.07, 0.6, 0.05), (x, 0.0, 0.03), 0.01))
    parts.append(block(DARK, (wide - 0.3, 0.04, 0.05), (0, 0.27, 0.2)))
    roll = cylinder(0.06, wide - 0.34, 14).turned(90, "y").moved(-(wide - 0.34) / 2, 0.08, 1.06)
    parts.append(roll.of(Material((0.94, 0.94, 0.93))))
    print_wide, long = wide - 0.45, between(rng, 0.4, 0.75)

    def hanging(s: np.ndarray, t: np.ndarray) -> tuple[np.ndarray, ...]:
        """Bend the sheet over the front edge."""
        drop = t * long
        return (0.5 - s) * print_wide, 0.575 + 0.04 * np.sin(2.5 * t), 0.93 + 0 * s - (long - drop)

    paper = sheet(hanging, 1, 8, (print_wide, long))
    parts.append(paper.of(poster(rng, print_wide, long)))
    panel = join(
        box(0.16, 0.1, 0.02, 0.004).of(DARK),
        box(0.1, 0.06, 0.002, 0).moved(0.0, 0.02, 0.02).of(Material((0.4, 0.65, 0.85), emission=0.5)),
    )
    parts.append(panel.turned(35, "x").moved(wide / 2 - 0.09, 0.33, 1.11))
    if chance(rng, 0.6):
        cloth = Material((0.2, 0.2, 0.22))
        line = [(-wide / 2 + 0.15, 0.62, 0.35), (wide / 2 - 0.15, 0.62, 0.35)]
        parts.append(tube(line, 0.008, 6).of(DARK))

        def basket(s: np.ndarray, t: np.ndarray) -> tuple[np.ndarray, ...]:
            """Let the sheet sag between the two bars."""
            return (0.5 - s) * (wide - 0.32), 0.3 + 0.32 * t, 0.35 - 0.22 * np.sin(math.pi * t)

        parts.append(sheet(basket, 1, 8).of(cloth))
    return join(parts)


def _skin(rng: np.random.Generator) -> Material:
    tones = ((0.88, 0.88, 0.87), (0.8, 0.78, 0.71), (0.12, 0.12, 0.13), (0.45, 0.47, 0.5), (0.66, 0.67, 0.7))
    return Material(choose(rng, tones, (3, 2, 2, 1, 1)), gloss=0.03, roughness=0.4)


def _laser(rng: np.random.Generator, skin: Material, *, large: bool = False) -> Mesh:
    factor = 1.3 if large else 1.0
    wide, deep = between(rng, 0.36, 0.42) * factor, between(rng, 0.36, 0.42) * factor
    high = between(rng, 0.22, 0.32) * factor
    trim = choose(rng, (DARK, Material(palette.shade(skin.colour, 0.75), gloss=0.03)))
    shelf = [(0, 0), (deep, 0), (deep, high * 0.7), (deep * 0.75, high * 0.75), (0, high * 0.95)]
    parts = [sideways(shelf, wide - 0.08).of(skin)]
    for x in (-wide / 2 + 0.025, wide / 2 - 0.025):
        cheek = [(0, 0), (deep, 0), (deep, high * 0.72), (deep - 0.05, high), (0, high)]
        parts.append(sideways(cheek, 0.05).moved(x).of(skin))
    parts.append(block(trim, (wide - 0.1, deep * 0.12, 0.02), (0, deep * 0.02, high * 0.95)))
    parts.append(block(trim, (wide * 0.8, 0.012, 0.075), (0, deep - 0.006, 0.015), 0.003))
    parts.append(block(DARK, (wide * 0.3, 0.004, 0.015), (0, deep + 0.005, 0.065)))
    if chance(rng, 0.7):
        pages = box(0.21, 0.27, between(rng, 0.002, 0.02), 0).of(leaf(rng, white=0.95))
        slope = math.degrees(math.atan2(high * 0.2, deep * 0.75))
        parts.append(pages.turned(-slope, "x").moved(0, deep * 0.2, high * 0.9))
    panel = block(DARK, (0.044, 0.1, 0.012), (wide / 2 - 0.025, deep - 0.17, high - 0.008))
    green = Material((0.3, 0.9, 0.4), emission=0.7)
    light = block(green, (0.012, 0.012, 0.004), (wide / 2 - 0.03, deep - 0.09, high + 0.003))
    return join(parts, panel, light)


def _inkjet(rng: np.random.Generator, skin: Material) -> Mesh:
    wide, deep, high = between(rng, 0.42, 0.48), between(rng, 0.32, 0.4), between(rng, 0.15, 0.22)
    trim = choose(rng, (DARK, palette.plastic(rng)))
    parts = [
        block(skin, (wide, deep, high - 0.05), (0, 0, 0), 0.01),
        block(trim, (wide, deep, 0.045), (0, 0, high - 0.048), 0.01),
        block(DARK, (wide * 0.6, 0.01, high * 0.3), (0, deep - 0.006, high * 0.2)),
        box(wide * 0.55, 0.16, 0.008, 0).moved(0, deep - 0.01, 0.03).of(trim),
        lying(rng, 0.21, 0.2).moved(0, deep + 0.06, 0.04),
    ]
    back = box(0.24, 0.01, 0.16, 0).turned(14, "x").moved(0, 0.02, high - 0.02)
    parts.append(back.of(trim))
    pages = quad(0.21, 0.2).turned(14, "x").moved(0, 0.032, high)
    parts.append(pages.of(leaf(rng, white=1)))
    panel = join(
        box(0.16, 0.05, 0.01, 0.003).of(DARK),
        box(0.06, 0.035, 0.001, 0).moved(0, 0.007, 0.01).of(Material((0.4, 0.6, 0.9), emission=0.6)),
    )
    parts.append(panel.turned(30, "x").moved(0.1, deep - 0.06, high - 0.03))
    return join(parts)
