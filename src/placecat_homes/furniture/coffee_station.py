"""Coffee machines and coffee stations for offices."""

import numpy as np

from placecat_homes import palette
from placecat_homes.furniture.blocks import between, block, chance, choose, legs
from placecat_homes.furniture.desk_things import mug
from placecat_homes.materials import Material
from placecat_homes.mesh import Mesh, join
from placecat_homes.parts.prints import ink
from placecat_homes.shapes import box, cylinder, lathe, tube
from placecat_homes.style import Style

DARK = Material((0.05, 0.05, 0.055), gloss=0.04, roughness=0.2)
STEEL = Material((0.65, 0.66, 0.67), gloss=0.4, roughness=0.5)


def coffee_machine(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a bean-to-cup coffee machine, a filter machine with a glass jug, or an espresso machine."""
    kind = choose(rng, ("automatic", "jug", "espresso"))
    return {"automatic": _automatic, "jug": _jug, "espresso": _espresso}[kind](rng)


def coffee_station(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a low cabinet or table with a coffee machine, mugs, stacks of paper cups, and tins."""
    wide, deep, high = between(rng, 0.75, 1.1), between(rng, 0.42, 0.5), between(rng, 0.8, 0.92)
    skin = choose(rng, (style.any_wood(rng), palette.paint(rng)))
    if chance(rng, 0.65):
        parts = [block(skin, (wide, deep - 0.02, high - 0.03), (0, 0, 0), 0.003)]
        for side in (-1, 1):
            parts.append(
                block(
                    skin, (wide / 2 - 0.006, 0.018, high - 0.12), (side * wide / 4, deep - 0.02, 0.08), 0.003
                )
            )
            parts.append(block(style.metal, (0.012, 0.018, 0.1), (side * 0.04, deep - 0.002, high * 0.65)))
    else:
        parts = [legs("square", wide, deep, high - 0.03, style.metal, 0.035)]
        parts.append(block(skin, (wide - 0.06, deep - 0.06, 0.02), (0, 0.03, high * 0.35)))
    parts.append(block(skin, (wide + 0.01, deep, 0.03), (0, 0, high - 0.03), 0.005))
    machine = coffee_machine(rng, style)
    x = wide * between(rng, -0.2, 0.2)
    parts.append(machine.moved(x, 0.04, high))
    half = float(machine.size[0]) / 2
    for side in (-1, 1):
        room = wide / 2 - side * x - half
        for k in range(int(room / 0.13)):
            place = x + side * (half + 0.08 + 0.13 * k)
            kind = rng.random()
            if kind < 0.35:
                paper = cylinder(0.04, between(rng, 0.1, 0.3), 12).of(Material((0.92, 0.9, 0.86)))
                parts.append(paper.moved(place, 0.12, high))
            elif kind < 0.6:
                parts.append(
                    cylinder(0.05, 0.14, 14).of(Material(ink(rng), gloss=0.04)).moved(place, 0.12, high)
                )
            parts.append(mug(rng, style).moved(place, 0.29, high))
    return join(parts)


def _automatic(rng: np.random.Generator) -> Mesh:
    wide, deep, high = between(rng, 0.27, 0.34), between(rng, 0.38, 0.44), between(rng, 0.36, 0.5)
    skin = choose(rng, (DARK, STEEL, Material((0.88, 0.88, 0.87), gloss=0.04)))
    front = choose(rng, (DARK, STEEL))
    parts = [
        block(skin, (wide, deep * 0.55, high), (0, 0, 0), 0.012),
        block(skin, (wide, deep, high * 0.4), (0, 0, high * 0.6), 0.012),
        block(front, (wide, deep, 0.05), (0, 0, 0), 0.01),
        block(STEEL, (wide * 0.6, deep * 0.35, 0.006), (0, deep * 0.6, 0.049)),
        block(DARK, (0.07, 0.06, 0.1), (0, deep * 0.75, high * 0.6 - 0.08), 0.008),
        block(Material((0.4, 0.65, 0.9), emission=0.6), (wide * 0.35, 0.003, 0.05), (0, deep, high * 0.78)),
    ]
    for k in range(4):
        key = cylinder(0.012, 0.006, 10, 0).turned(-90, "x")
        parts.append(key.moved((k - 1.5) * wide * 0.2, deep - 0.001, high * 0.68).of(STEEL))
    hopper = Material((0.35, 0.25, 0.18), gloss=0.05, opacity=0.8)
    parts.append(block(hopper, (wide * 0.6, deep * 0.4, 0.08), (0, 0.05, high), 0.01))
    cup = lathe([(0, 0), (0.03, 0), (0.038, 0.08), (0.034, 0.08), (0, 0.02)], 12)
    if chance(rng, 0.6):
        parts.append(cup.moved(0, deep * 0.78, 0.055).of(Material((0.92, 0.92, 0.9), gloss=0.05)))
    return join(parts)


def _jug(rng: np.random.Generator) -> Mesh:
    skin = choose(rng, (DARK, palette.plastic(rng), Material((0.9, 0.9, 0.88), gloss=0.04)))
    coffee = Material((0.12, 0.06, 0.03), gloss=0.06)
    glass = Material((0.6, 0.5, 0.42), gloss=0.08, opacity=0.35)
    handle = [(0, 0.29, 0.14), (0, 0.33, 0.13), (0, 0.335, 0.07), (0, 0.295, 0.05)]
    line = [(0, 0), (0.06, 0), (0.075, 0.05), (0.065, 0.1), (0.05, 0.13)]
    return join(
        block(skin, (0.2, 0.1, 0.33), (0, 0, 0), 0.012),
        block(skin, (0.2, 0.28, 0.035), (0, 0, 0), 0.01),
        block(skin, (0.2, 0.24, 0.09), (0, 0, 0.24), 0.015),
        lathe([(0, 0.002), (0.055, 0.002), (0.068, 0.05), (0.064, 0.075), (0, 0.075)], 14)
        .moved(0, 0.19, 0.037)
        .of(coffee),
        lathe(line, 16).moved(0, 0.19, 0.037).of(glass),
        cylinder(0.055, 0.02, 14).moved(0, 0.19, 0.165).of(skin),
        tube([(x, y - 0.02, z + 0.02) for x, y, z in handle], 0.009, 6).of(skin),
    )


def _espresso(rng: np.random.Generator) -> Mesh:
    skin = STEEL if chance(rng, 0.6) else palette.plastic(rng)
    wide = between(rng, 0.26, 0.36)
    parts = [
        block(skin, (wide, 0.16, 0.34), (0, 0, 0), 0.01),
        block(skin, (wide, 0.32, 0.06), (0, 0, 0), 0.008),
        block(skin, (wide, 0.3, 0.1), (0, 0, 0.26), 0.01),
        block(DARK, (wide * 0.8, 0.14, 0.005), (0, 0.17, 0.059)),
        cylinder(0.035, 0.05, 14).moved(0, 0.23, 0.21).of(STEEL),
        tube([(0, 0.24, 0.225), (0, 0.38, 0.215)], 0.013, 6).of(DARK),
        tube([(wide * 0.4, 0.22, 0.27), (wide * 0.42, 0.28, 0.2), (wide * 0.42, 0.28, 0.12)], 0.006, 6).of(
            STEEL
        ),
        cylinder(0.03, 0.012, 14)
        .turned(-90, "x")
        .moved(-wide * 0.3, 0.298, 0.31)
        .of(Material((0.95, 0.95, 0.95))),
    ]
    for k in range(3):
        cup = lathe([(0, 0), (0.02, 0), (0.032, 0.055), (0.029, 0.055), (0, 0.01)], 10)
        white = Material((0.93, 0.93, 0.92), gloss=0.05)
        parts.append(cup.moved((k - 1) * 0.08, 0.12, 0.36).of(white))
    parts.append(box(wide * 0.2, 0.003, 0.02, 0).moved(wide * 0.25, 0.3, 0.3).of(DARK))
    return join(parts)
