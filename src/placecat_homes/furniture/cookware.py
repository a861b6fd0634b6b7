"""Pots, pans and cooking utensils."""

import math

import numpy as np

from placecat_homes import palette
from placecat_homes.materials import Material
from placecat_homes.mesh import Mesh, join
from placecat_homes.parts.arrange import grounded
from placecat_homes.parts.outlines import frontal, sideways
from placecat_homes.shapes import box, cylinder, lathe, tube
from placecat_homes.style import Style

BLACK = Material(colour=(0.05, 0.05, 0.055), gloss=0.04, roughness=0.5)
COPPER = Material(colour=(0.78, 0.45, 0.28), gloss=0.6, roughness=0.25)


def _pot_metal(rng: np.random.Generator) -> Material:
    kind = rng.random()
    if kind < 0.45:
        return Material(colour=(0.75, 0.75, 0.76), gloss=0.6, roughness=0.2)
    if kind < 0.6:
        return BLACK
    if kind < 0.7:
        return COPPER
    return palette.plastic(rng)


def pot(rng: np.random.Generator, style: Style, *, radius: float | None = None) -> Mesh:
    """Draw a pot with two handles and usually a lid, or a saucepan with one long handle."""
    metal = _pot_metal(rng)
    r = radius or float(rng.uniform(0.085, 0.125))
    height = r * float(rng.uniform(0.8, 1.4))
    body = lathe(
        [
            (0, 0),
            (r - 0.008, 0),
            (r, 0.008),
            (r, height),
            (r + 0.004, height),
            (r - 0.003, height),
            (r - 0.004, 0.01),
            (0, 0.008),
        ],
        18,
    ).of(metal)
    parts = [body]
    dark = BLACK if rng.random() < 0.6 else metal
    if rng.random() < 0.3:
        parts.append(tube([(r - 0.005, 0, 0.85 * height), (r + 0.18, 0, 0.95 * height)], 0.009, 8).of(dark))
    else:
        for side in (-1, 1):
            path = [
                (side * (r - 0.003), -0.035, 0.82 * height),
                (side * (r + 0.03), -0.03, 0.85 * height),
                (side * (r + 0.03), 0.03, 0.85 * height),
                (side * (r - 0.003), 0.035, 0.82 * height),
            ]
            parts.append(tube(path, 0.006, 6).of(dark))
    if rng.random() < 0.75:
        lid = lathe(
            [(r + 0.003, height), (r + 0.003, height + 0.004), (0.5 * r, height + 0.02), (0, height + 0.026)],
            18,
        ).of(metal)
        knob = cylinder(0.016, 0.022, 10, 0.005).moved(z=height + 0.024).of(dark)
        parts += [lid, knob]
    return grounded(join(parts).turned(float(rng.uniform(0, 360))))


def pan(rng: np.random.Generator, style: Style, *, radius: float | None = None) -> Mesh:
    """Draw a frying pan."""
    r = radius or float(rng.uniform(0.1, 0.145))
    metal = BLACK if rng.random() < 0.6 else _pot_metal(rng)
    body = lathe(
        [(0, 0), (0.8 * r, 0), (r, 0.045), (r - 0.004, 0.046), (0.78 * r, 0.006), (0, 0.005)], 18
    ).of(metal)
    handle = tube([(0.95 * r, 0, 0.035), (1.3 * r, 0, 0.06), (r + 0.2, 0, 0.065)], 0.01, 8).of(BLACK)
    return grounded(join(body, handle).turned(float(rng.uniform(0, 360))))


def utensil_jar(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a jar of spoons, whisks and spatulas."""
    r, height = float(rng.uniform(0.048, 0.062)), float(rng.uniform(0.13, 0.17))
    jar = lathe([(0, 0), (r, 0), (1.03 * r, height), (0.95 * r, height), (0.9 * r, 0.03), (0, 0.02)], 14)
    parts = [jar.of(palette.ceramic(rng) if rng.random() < 0.6 else style.metal)]
    wooden = palette.wood(rng)
    for k in range(int(rng.integers(4, 8))):
        angle = 2 * math.pi * (k + float(rng.uniform(-0.3, 0.3))) / 6
        lean = float(rng.uniform(0.5, 1.0)) * r
        foot = (-0.4 * r * math.cos(angle), -0.4 * r * math.sin(angle), 0.03)
        top = height + float(rng.uniform(0.06, 0.14))
        tip = (1.3 * lean * math.cos(angle), 1.3 * lean * math.sin(angle), top)
        material = (wooden, style.metal, BLACK)[int(rng.integers(3))]
        parts.append(tube([foot, tip], 0.005, 6).of(material))
        head = rng.random()
        if head < 0.45:
            spoon = lathe([(0, 0), (0.024, 0.02), (0.026, 0.045), (0.012, 0.07), (0, 0.072)], 8)
            spoon = spoon.scaled(1.0, 0.35, 1.0)
        elif head < 0.75:
            spoon = box(0.06, 0.006, 0.085, 0.0).moved(y=-0.003)
        else:
            spoon = lathe([(0, 0), (0.02, 0.03), (0.03, 0.06), (0.02, 0.085), (0, 0.095)], 6)
        parts.append(
            spoon.turned(float(rng.uniform(0, 180))).moved(tip[0], tip[1], tip[2] - 0.01).of(material)
        )
    return grounded(parts)


def knife_block(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a slanted knife block with handles sticking out."""
    wooden = style.wood if rng.random() < 0.5 else (palette.wood(rng) if rng.random() < 0.7 else BLACK)
    block = sideways([(0, 0), (0.14, 0), (0.19, 0.13), (0.12, 0.22), (0.0, 0.1)], 0.1).of(wooden)
    parts = [block]
    direction = np.array([0.0, 0.75, 0.66])
    for row in range(2):
        for column in range(3):
            base = np.array([-0.03 + 0.03 * column, 0.175 - 0.04 * row, 0.15 + 0.045 * row])
            tip = base + direction * (0.11 - 0.015 * row)
            parts.append(tube([tuple(base - 0.02 * direction), tuple(tip)], 0.0085, 6).of(BLACK))
    return grounded(join(parts).turned(float(rng.uniform(-30, 30))))


def cutting_board(rng: np.random.Generator, style: Style, *, leaning: bool | None = None) -> Mesh:
    """Draw a cutting board, either lying flat or leaning against the wall."""
    width, height = float(rng.uniform(0.24, 0.36)), float(rng.uniform(0.28, 0.42))
    wooden = palette.wood(rng)
    if leaning if leaning is not None else rng.random() < 0.6:
        outline = [(-width / 2, 0), (width / 2, 0), (width / 2, height - 0.03), (width / 2 - 0.03, height)]
        outline += [(0.03, height), (0.025, height + 0.08), (-0.025, height + 0.08), (-0.03, height)]
        outline += [(-width / 2 + 0.03, height), (-width / 2, height - 0.03)]
        outline = [(0.0, 0.0), *outline[1:], outline[0]]
        return grounded(frontal(outline, 0.02).of(wooden).turned(8, "x"))
    return grounded(box(height, width, 0.022, 0.004).of(wooden).turned(float(rng.uniform(-12, 12))))


def hanging_rail(rng: np.random.Generator, style: Style, *, width: float | None = None) -> Mesh:
    """Draw a wall rail with ladles, spatulas and pans hanging from hooks. Its lowest point is at z = 0."""
    length = width or float(rng.uniform(0.5, 0.9))
    parts = [tube([(-length / 2, 0.045, 0), (length / 2, 0.045, 0)], 0.007, 8).of(style.metal)]
    for x in (-length / 2 + 0.03, length / 2 - 0.03):
        parts.append(tube([(x, 0, 0), (x, 0.045, 0)], 0.006, 6).of(style.metal))
    x = -length / 2 + 0.09
    while x < length / 2 - 0.07:
        metal = (style.metal, BLACK, palette.wood(rng))[int(rng.choice(3, p=[0.6, 0.2, 0.2]))]
        reach = float(rng.uniform(0.2, 0.3))
        kind = rng.random()
        parts.append(tube([(x, 0.04, 0.01), (x, 0.06, 0), (x, 0.055, -0.04)], 0.003, 5).of(style.metal))
        parts.append(tube([(x, 0.055, -0.03), (x, 0.055, -reach)], 0.005, 6).of(metal))
        if kind < 0.3:
            head = lathe([(0, 0), (0.03, 0.012), (0.042, 0.04), (0.04, 0.042), (0, 0.012)], 10)
            parts.append(head.moved(x, 0.055, -reach - 0.03).of(metal))
        elif kind < 0.55:
            parts.append(box(0.075, 0.005, 0.1, 0).moved(x, 0.052, -reach - 0.09).of(metal))
        elif kind < 0.75:
            head = lathe([(0, 0), (0.03, 0.03), (0.034, 0.06), (0.012, 0.1)], 8).scaled(1, 0.4, 1)
            parts.append(head.moved(x, 0.055, -reach - 0.09).of(metal))
        else:
            r = float(rng.uniform(0.07, 0.1))
            disc = lathe(
                [(0, 0), (0.85 * r, 0), (r, 0.04), (0.97 * r, 0.04), (0.8 * r, 0.005), (0, 0.005)], 14
            )
            parts.append(
                disc.turned(-90, "x").moved(x, 0.06, -0.16 - r).of(BLACK if rng.random() < 0.6 else COPPER)
            )
            x += r * 0.9
        x += float(rng.uniform(0.09, 0.14))
    mesh = join(parts)
    return mesh.moved(z=-float(mesh.low[2]))
