"""Recycling bins and paper shredders."""

import numpy as np

from placecat_homes import palette
from placecat_homes.furniture.blocks import between, block, chance
from placecat_homes.materials import Material
from placecat_homes.mesh import Mesh, join
from placecat_homes.parts.prints import ink, leaf
from placecat_homes.shapes import box, cylinder, lathe, slab
from placecat_homes.style import Style

DARK = Material((0.06, 0.06, 0.065), gloss=0.03)


def recycling(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw two or three bins side by side, with signs and differently coloured lids."""
    body = palette.plastic(rng) if chance(rng, 0.6) else style.metal
    wide, deep, high = between(rng, 0.28, 0.36), between(rng, 0.3, 0.4), between(rng, 0.6, 0.85)
    parts = []
    count = int(rng.integers(2, 4))
    for k in range(count):
        x = (k - (count - 1) / 2) * (wide + 0.01)
        lid = Material(ink(rng), gloss=0.04)
        parts.append(block(body, (wide, deep, high), (x, 0, 0), 0.012))
        parts.append(block(lid, (wide, deep, 0.05), (x, 0, high), 0.012))
        parts.append(block(DARK, (wide * 0.6, deep * 0.18, 0.002), (x, deep * 0.4, high + 0.0495)))
        parts.append(block(lid, (wide * 0.5, 0.002, wide * 0.5), (x, deep, high * 0.6)))
        arrows = Material((0.95, 0.95, 0.95))
        for turn in (0, 120, 240):
            arm = box(wide * 0.2, 0.002, wide * 0.05, 0).moved(0, 0, wide * 0.1).turned(turn, "y")
            parts.append(arm.of(arrows).moved(x, deep + 0.001, high * 0.6 + wide * 0.25))
    return join(parts)


def paper_bin(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a large open box or wheeled bin full of waste paper."""
    skin = palette.plastic(rng) if chance(rng, 0.6) else Material((0.66, 0.52, 0.36))
    wide, deep, high = between(rng, 0.38, 0.5), between(rng, 0.36, 0.48), between(rng, 0.5, 0.75)
    t = 0.012
    parts = [
        block(skin, (wide, t, high), (0, 0, 0.03)),
        block(skin, (wide, t, high), (0, deep - t, 0.03)),
        block(skin, (t, deep, high), (wide / 2 - t / 2, 0, 0.03)),
        block(skin, (t, deep, high), (-wide / 2 + t / 2, 0, 0.03)),
        block(skin, (wide, deep, t), (0, 0, 0.02)),
    ]
    for x in (-wide / 2 + 0.05, wide / 2 - 0.05):
        for y in (0.05, deep - 0.05):
            parts.append(cylinder(0.025, 0.02, 8).turned(90, "y").moved(x - 0.01, y, 0.025).of(DARK))
    level = high * between(rng, 0.75, 1.0)
    parts.append(slab(wide - 2 * t, deep - 2 * t).moved(0, t, level - 0.03).of(leaf(rng)))
    for _ in range(12):
        page = box(0.21, 0.29, 0.002, 0).moved(y=-0.145)
        page = page.turned(float(np.clip(rng.normal(0, 9), -18, 18)), "x").turned(between(rng, 0, 360))
        x, y = between(rng, -0.15, 0.15) * wide, deep * between(rng, 0.42, 0.58)
        parts.append(page.scaled(0.75, 0.75, 1).of(leaf(rng)).moved(x, y, level + between(rng, 0.0, 0.07)))
    return join(parts)


def shredder(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a paper shredder on top of its bin, with shreds visible through a window."""
    wide, deep, high = between(rng, 0.35, 0.45), between(rng, 0.26, 0.36), between(rng, 0.5, 0.75)
    skin, head = palette.plastic(rng), palette.plastic(rng) if chance(rng, 0.4) else DARK
    window = (wide * 0.5, 0.003, high * 0.3)
    parts = [
        block(skin, (wide - 0.02, deep - 0.02, high - 0.16), (0, 0.01, 0.03), 0.01),
        block(DARK, (wide - 0.04, deep - 0.04, 0.03), (0, 0.02, 0)),
        block(head, (wide, deep, 0.13), (0, 0, high - 0.13), 0.02),
        block(Material((0.01, 0.01, 0.01)), (wide * 0.65, 0.018, 0.002), (0, deep * 0.45, high - 0.001)),
        block(Material((0.85, 0.85, 0.83)), window, (0, deep - 0.011, 0.12)),
        lathe([(0.012, 0), (0.012, 0.004), (0, 0.004)], 10)
        .moved(wide * 0.35, deep * 0.8, high - 0.001)
        .of(Material((0.2, 0.85, 0.3), emission=0.6)),
    ]
    for _ in range(14):
        strip = box(0.003, 0.002, between(rng, 0.05, 0.12), 0).turned(between(rng, -60, 60), "y")
        place = between(rng, -0.2, 0.2) * wide, deep - 0.0085, 0.12 + high * 0.15
        parts.append(strip.of(leaf(rng, white=0.7)).moved(*place))
    if chance(rng, 0.5):
        page = box(0.21, 0.001, 0.15, 0).turned(5, "x").moved(0, deep * 0.45 + 0.009, high - 0.01)
        parts.append(page.of(leaf(rng)))
    return join(parts)
