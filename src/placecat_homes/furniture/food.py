"""Fruit, bread, jars and packets."""

import math

import numpy as np

from placecat_homes import palette
from placecat_homes.materials import Colour, Material
from placecat_homes.mesh import Mesh, join
from placecat_homes.parts.arrange import grounded, in_a_row
from placecat_homes.shapes import box, cylinder, lathe, superellipsoid, tube
from placecat_homes.style import Style

FRUIT: tuple[Colour, ...] = (
    (0.8, 0.12, 0.08),
    (0.62, 0.75, 0.2),
    (0.95, 0.55, 0.08),
    (0.95, 0.85, 0.2),
    (0.45, 0.12, 0.3),
    (0.75, 0.3, 0.15),
)
CRUST = Material(colour=(0.68, 0.42, 0.18), gloss=0.02)
JAR = Material(colour=(0.92, 0.96, 0.95), gloss=0.08, roughness=0.05, opacity=0.25)
FILLINGS: tuple[Colour, ...] = (
    (0.85, 0.72, 0.45),
    (0.35, 0.18, 0.08),
    (0.92, 0.9, 0.84),
    (0.6, 0.15, 0.1),
    (0.75, 0.5, 0.15),
    (0.25, 0.32, 0.12),
)


def _banana(bend: float) -> Mesh:
    path = [(0.1 * math.sin(a), 0.0, 0.1 * (1 - math.cos(a))) for a in np.linspace(-0.9, 0.9, 7)]
    body = tube([(x, bend, z) for x, _, z in path], 0.017, 7)
    return body.of(Material(colour=(0.93, 0.8, 0.22), gloss=0.02))


def fruit_bowl(rng: np.random.Generator, style: Style, *, radius: float | None = None) -> Mesh:
    """Draw a bowl heaped with apples, oranges, lemons and bananas."""
    r = radius or float(rng.uniform(0.13, 0.18))
    height = r * float(rng.uniform(0.4, 0.6))
    vessel = (palette.ceramic, palette.wood, palette.plastic)[int(rng.integers(3))](rng)
    parts = [
        lathe(
            [
                (0, 0),
                (0.45 * r, 0),
                (0.5 * r, 0.08 * height),
                (0.85 * r, 0.5 * height),
                (r, height),
                (0.96 * r, height),
                (0.8 * r, 0.52 * height),
                (0, 0.15 * height),
            ],
            20,
        ).of(vessel)
    ]
    kinds = rng.choice(len(FRUIT), 3, replace=False)
    for level, count in ((0.6 * height, 6), (0.6 * height + 0.055, 3)):
        spread = 0.55 * r if count == 6 else 0.28 * r
        start = float(rng.uniform(0, 6))
        for k in range(count):
            size = float(rng.uniform(0.065, 0.085))
            angle = start + 2 * math.pi * k / count
            ball = superellipsoid(size, size, size * float(rng.uniform(0.85, 1.1)), 1, 1, 10)
            colour = FRUIT[int(kinds[int(rng.integers(3))])]
            parts.append(
                ball.of(Material(colour=colour, gloss=0.03)).moved(
                    spread * math.cos(angle), spread * math.sin(angle), level - 0.02
                )
            )
    if rng.random() < 0.5:
        turn = float(rng.uniform(0, 360))
        for k in range(3):
            fruit = _banana(0.03 * k - 0.03).turned(turn)
            parts.append(fruit.moved(z=0.6 * height + 0.09))
    return grounded(parts)


def bread(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a loaf of bread on a board, either whole or sliced."""
    board = box(0.36, 0.22, 0.02, 0.004).of(palette.wood(rng))
    length = float(rng.uniform(0.2, 0.28))
    loaf = superellipsoid(length, 0.12, 0.1, 0.7, 0.5, 14).of(CRUST).moved(-0.03, 0.11, 0.018)
    parts = [board, loaf]
    if rng.random() < 0.5:
        crumb = Material(colour=(0.93, 0.85, 0.66))
        parts.append(
            box(0.012, 0.11, 0.085, 0.002).of(crumb).turned(8, "y").moved(length / 2 - 0.01, 0.055, 0.02)
        )
    return grounded(join(parts).turned(float(rng.uniform(-15, 15))))


def bread_box(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a bread box with a rounded lid."""
    width = float(rng.uniform(0.34, 0.44))
    material = (
        style.metal if rng.random() < 0.4 else (palette.plastic(rng) if rng.random() < 0.6 else style.wood)
    )
    body = superellipsoid(0.4, 0.28, 0.21, 0.35, 0.2, 24).scaled(width / 0.4, 1, 1)
    knob = cylinder(0.014, 0.03, 8).turned(-90, "x").moved(0, 0.14, 0.11)
    return grounded(body.of(material), knob.of(style.metal))


def jar(rng: np.random.Generator, style: Style, *, height: float | None = None) -> Mesh:
    """Draw a full storage jar with a lid."""
    tall = height or float(rng.uniform(0.12, 0.26))
    r = float(rng.uniform(0.042, 0.058))
    lid = (palette.wood, palette.metal, palette.plastic)[int(rng.integers(3))](rng)
    top = cylinder(0.92 * r, 0.022, 14, 0.004).moved(z=tall - 0.012).of(lid)
    if rng.random() < 0.35:
        pot = palette.ceramic(rng) if rng.random() < 0.6 else palette.plastic(rng)
        return grounded(cylinder(r, tall, 14, 0.006).of(pot), top)
    filling = Material(colour=FILLINGS[int(rng.integers(len(FILLINGS)))])
    level = tall * float(rng.uniform(0.4, 0.85))
    inner = cylinder(r - 0.005, level, 14, 0.002).moved(z=0.004).of(filling)
    return grounded(cylinder(r, tall, 14, 0.006).of(JAR), inner, top)


def jars(rng: np.random.Generator, style: Style, *, count: int | None = None) -> Mesh:
    """Draw a row of storage jars, from tallest to shortest."""
    number = count or int(rng.integers(3, 6))
    seed = int(rng.integers(2**31))
    things = []
    for k in range(number):
        thing = jar(
            np.random.default_rng(seed + (k if rng.random() < 0.3 else 0)), style, height=0.24 - 0.028 * k
        )
        things.append(thing)
    width = sum(float(thing.size[0]) + 0.02 for thing in things)
    return grounded(in_a_row(rng, things, width, gap=0.012))


def spice_rack(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a small rack with two rows of spice jars."""
    width = float(rng.uniform(0.32, 0.46))
    wooden = style.wood if rng.random() < 0.6 else palette.paint(rng)
    parts = [
        box(0.014, 0.085, 0.3, 0.0).moved(x=-width / 2).of(wooden),
        box(0.014, 0.085, 0.3, 0.0).moved(x=width / 2).of(wooden),
    ]
    for z in (0.01, 0.155):
        parts.append(box(width, 0.08, 0.012, 0.0).moved(z=z).of(wooden))
        parts.append(box(width, 0.006, 0.03, 0.0).moved(y=0.078, z=z + 0.01).of(wooden))
        x = -width / 2 + 0.035
        while x < width / 2 - 0.025:
            filling = Material(colour=FILLINGS[int(rng.integers(len(FILLINGS)))], gloss=0.04)
            body = cylinder(0.019, 0.075, 8, 0.002).of(filling)
            lid = cylinder(0.02, 0.02, 8, 0.002).moved(z=0.075).of(Material(colour=(0.08, 0.08, 0.08)))
            parts.append(join(body, lid).moved(x, 0.042, z + 0.012))
            x += float(rng.uniform(0.043, 0.05))
    return grounded(parts)


def packets(rng: np.random.Generator, style: Style, *, count: int | None = None) -> Mesh:
    """Draw packets of cereal, flour and tea standing together."""
    things = []
    for _ in range(count or int(rng.integers(2, 5))):
        width, height = float(rng.uniform(0.08, 0.19)), float(rng.uniform(0.14, 0.3))
        paper = Material(palette.colour(rng, 0.95, 0.3, 0.95), gloss=0.02)
        packet = box(width, 0.06, height, 0.0).of(paper)
        band = Material(palette.colour(rng, 0.95, 0.3, 1.0), gloss=0.02)
        label = box(width * 0.8, 0.003, height * 0.35, 0.0).of(band).moved(0, 0.06, height * 0.4)
        things.append(join(packet, label).turned(float(rng.uniform(-10, 10))))
    width = sum(float(thing.size[0]) + 0.02 for thing in things)
    return grounded(in_a_row(rng, things, width, gap=0.008))


def paper_roll(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a roll of kitchen paper on a stand."""
    foot = cylinder(0.075, 0.012, 16, 0.003).of(style.metal)
    pole = cylinder(0.007, 0.32, 8, 0.002).of(style.metal)
    roll = cylinder(float(rng.uniform(0.045, 0.065)), 0.23, 16, 0.004).moved(z=0.014)
    return grounded(foot, pole, roll.of(Material(colour=(0.95, 0.95, 0.94))))
