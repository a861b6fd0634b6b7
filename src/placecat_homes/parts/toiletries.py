"""Toiletries for washbasins and shelves, such as bottles, tubes, jars and soap."""

import math

import numpy as np

from placecat_homes.materials import Colour, Material
from placecat_homes.mesh import Mesh, join
from placecat_homes.parts.lofts import loft, rounded
from placecat_homes.shapes import box, cylinder, lathe, superellipsoid, tube

WHITE = Material((0.93, 0.93, 0.91), gloss=0.04)
GLASS = Material((0.85, 0.92, 0.93), gloss=0.06, roughness=0.0, opacity=0.35)
PAPER = Material((0.94, 0.93, 0.91))


def bright(rng: np.random.Generator) -> Colour:
    """Choose a typical packaging colour: white, pastel or bold."""
    if rng.random() < 0.3:
        return (0.93, 0.93, 0.9)
    hue, strength, value = rng.uniform(0, 6), rng.uniform(0.2, 0.85), rng.uniform(0.35, 0.95)
    parts = [float(np.clip(abs((hue + shift) % 6 - 3) - 1, 0, 1)) for shift in (0, 4, 2)]
    red, green, blue = (value * (1 - strength + strength * part) for part in parts)
    return (red, green, blue)


def _label(rng: np.random.Generator, width: float, height: float, y: float, z: float) -> Mesh:
    label = Material(bright(rng), gloss=0.02)
    return box(width, 0.002, height, bevel=0.0).moved(0, y, z).of(label)


def bottle(rng: np.random.Generator) -> Mesh:
    """Draw a shampoo, gel or lotion bottle, 12 to 25 cm tall, centred on the z axis, with a cap or pump."""
    height, width = rng.uniform(0.11, 0.2), rng.uniform(0.05, 0.08)
    body = Material(bright(rng), gloss=0.05, roughness=0.2)
    cap = Material(bright(rng), gloss=0.04)
    depth = width * rng.uniform(0.6, 1.0)
    radius = min(width, depth) * rng.uniform(0.25, 0.5)
    wide = rounded(width, depth, radius, y=-depth / 2, points=3)
    parts = [
        loft([(wide * 0.9, 0.0), (wide, 0.01), (wide, height * 0.85), (wide * 0.45, height)], top=True).of(
            body
        ),
        _label(rng, width * 0.7, height * 0.4, depth / 2 - 0.0005, height * 0.25),
    ]
    if rng.random() < 0.45:
        parts.append(cylinder(0.012, 0.02, 8).moved(z=height).of(cap))
        parts.append(
            tube([(0, 0, height), (0, 0, height + 0.05), (0, 0.04, height + 0.045)], 0.005, 5).of(cap)
        )
    else:
        parts.append(cylinder(width * 0.2, 0.025, 8).moved(z=height).of(cap))
    return join(parts)


def jar(rng: np.random.Generator) -> Mesh:
    """Draw a low jar of cream with a lid, centred on the z axis."""
    radius, height = rng.uniform(0.025, 0.04), rng.uniform(0.03, 0.06)
    return join(
        cylinder(radius, height, 10).of(Material(bright(rng), gloss=0.05)),
        cylinder(radius * 1.03, 0.018, 10).moved(z=height).of(Material(bright(rng), gloss=0.05)),
    )


def flacon(rng: np.random.Generator) -> Mesh:
    """Draw a perfume bottle centred on the z axis."""
    width, height = rng.uniform(0.04, 0.07), rng.uniform(0.06, 0.09)
    tint = Material(bright(rng), gloss=0.08, roughness=0.05)
    stopper = Material((0.8, 0.65, 0.35) if rng.random() < 0.5 else (0.75, 0.76, 0.78), gloss=0.5)
    return join(
        box(width, 0.03, height, bevel=0.006).moved(0, -0.015).of(tint),
        cylinder(0.01, 0.035, 8).moved(z=height).of(stopper),
    )


def squeeze_tube(rng: np.random.Generator) -> Mesh:
    """Draw a tube of toothpaste or cream standing on its cap."""
    wide, thin = (
        rounded(0.05, 0.006, 0.002, y=-0.003, points=3),
        rounded(0.036, 0.036, 0.018, y=-0.018, points=3),
    )
    return join(
        cylinder(0.016, 0.025, 8).of(Material(bright(rng), gloss=0.04)),
        loft([(thin, 0.02), (wide, 0.15)]).of(Material(bright(rng), gloss=0.05)),
    )


def soap_dispenser(rng: np.random.Generator, metal: Material) -> Mesh:
    """Draw a soap dispenser centred on the z axis, with its pump facing +y."""
    body = Material(bright(rng), gloss=0.06, roughness=0.1)
    height = rng.uniform(0.1, 0.14)
    shape = [(0, 0), (0.034, 0), (0.035, height * 0.8), (0.03, height * 0.93), (0.014, height), (0, height)]
    return join(
        lathe(shape, 12).of(body),
        tube([(0, 0, height), (0, 0, height + 0.055), (0, 0.055, height + 0.045)], 0.006, 6).of(metal),
        cylinder(0.015, 0.012, 8).moved(z=height).of(metal),
    )


def soap(rng: np.random.Generator) -> Mesh:
    """Draw a bar of soap on a dish, centred on the z axis."""
    dish = lathe([(0, 0), (0.03, 0), (0.065, 0.02), (0.06, 0.02), (0.03, 0.006), (0, 0.006)], 14).scaled(
        1, 0.75, 1
    )
    return join(
        dish.of(Material(bright(rng), gloss=0.06)),
        superellipsoid(0.08, 0.05, 0.025, 0.5, 0.6, 12).moved(z=0.008).of(Material(bright(rng), gloss=0.03)),
    )


def tooth_brushes(rng: np.random.Generator) -> Mesh:
    """Draw a glass or mug, centred on the z axis, with one to four toothbrushes and perhaps toothpaste."""
    mug = GLASS if rng.random() < 0.4 else Material(bright(rng), gloss=0.06)
    profile = [(0, 0), (0.03, 0), (0.036, 0.1), (0.033, 0.1), (0.028, 0.006), (0, 0.006)]
    parts = [lathe(profile, 12).of(mug)]
    for _ in range(rng.integers(1, 5)):
        turn, lean = rng.uniform(0, 360), rng.uniform(8, 17)
        brush = join(
            box(0.009, 0.006, 0.19, bevel=0.0).of(Material(bright(rng), gloss=0.03)),
            box(0.011, 0.014, 0.03, bevel=0.0).moved(0, 0.004, 0.16).of(WHITE),
        )
        parts.append(brush.turned(lean, "x").moved(0, 0.01, 0.008).turned(turn))
    if rng.random() < 0.5:
        parts.append(squeeze_tube(rng).turned(-10, "x").moved(0, -0.012, 0.02))
    return join(parts)


def roll(rng: np.random.Generator, tail: float = 0.0) -> Mesh:
    """Draw a roll of toilet paper around the x axis, with its loose end hanging down in front."""
    radius = rng.uniform(0.045, 0.06)
    body = lathe([(0.02, 0), (radius, 0), (radius, 0.1), (0.02, 0.1), (0.02, 0)], 16).moved(z=-0.05)
    parts = [body.turned(90, "y").of(PAPER)]
    if tail > 0:
        parts.append(box(0.098, 0.002, tail, bevel=0.0).moved(0, radius - 0.002, -tail).of(PAPER))
    return join(parts)


def standing_roll(rng: np.random.Generator) -> Mesh:
    """Draw a roll of toilet paper standing on end."""
    radius = rng.uniform(0.05, 0.06)
    return lathe([(0.02, 0), (radius, 0), (radius, 0.1), (0.02, 0.1), (0.02, 0.01)], 14).of(PAPER)


def cosmetic(rng: np.random.Generator) -> Mesh:
    """Draw a randomly chosen object for a bathroom shelf, centred on the z axis."""
    makers = (bottle, bottle, bottle, jar, squeeze_tube, flacon)
    return makers[int(rng.integers(len(makers)))](rng).turned(rng.uniform(-25, 25))


def row(rng: np.random.Generator, width: float, fill: float = 0.7) -> Mesh:
    """Draw a row of bottles, jars and tubes along the x axis, centred on x = 0.

    Parameters
    ----------
    rng
        Random number generator.
    width
        Width of the shelf in metres.
    fill
        Fraction of the slots to fill.

    Returns
    -------
    Mesh
        The row, which may be empty.
    """
    count = max(1, int(width / 0.095))
    things = []
    for k in range(count):
        if rng.random() < fill:
            x = (k + 0.5) / count * width - width / 2 + rng.uniform(-0.01, 0.01)
            things.append(cosmetic(rng).moved(x, rng.uniform(-0.015, 0.015)))
    return join(things)


def folded_towels(rng: np.random.Generator, cloths: list[Material], width: float = 0.34) -> Mesh:
    """Draw a stack of folded towels with its back at y = 0.

    Parameters
    ----------
    rng
        Random number generator.
    cloths
        Material of each towel, from the bottom up.
    width
        Width in metres. The depth is three quarters of the width.

    Returns
    -------
    Mesh
        The stack. Each towel consists of two rounded layers, with the fold at the front.
    """
    parts = []
    z = 0.0
    for cloth in cloths:
        height, turn = rng.uniform(0.045, 0.07), rng.uniform(-3, 3)
        layer = superellipsoid(width, width * 0.75, height / 2, 0.35, 0.15, 16)
        fold = join(layer, layer.scaled(0.985, 0.98, 1).moved(z=height / 2 - 0.002)).turned(turn)
        parts.append(fold.moved(0, width * 0.375, z).of(cloth))
        z += height - 0.004
    return join(parts)


def rolled_towel(cloth: Material, length: float = 0.3, radius: float = 0.05) -> Mesh:
    """Draw a rolled-up towel lying on z = 0 parallel to the y axis, with its back at y = 0."""
    turns = [(radius * f, length + 0.004 * math.sin(9 * f)) for f in (1.0, 0.8, 0.6, 0.4, 0.2)]
    body = lathe([(0, 0), (radius, 0), *turns, (0, length)], 14)
    return body.turned(-90, "x").moved(z=radius).of(cloth)
