"""Washing machines."""

import math

import numpy as np

from placecat_homes import palette
from placecat_homes.furniture.towel import cloths
from placecat_homes.materials import Material
from placecat_homes.mesh import Mesh, join
from placecat_homes.parts.toiletries import bottle, folded_towels
from placecat_homes.shapes import box, cylinder, lathe, superellipsoid, tube
from placecat_homes.style import Style


def washing_machine(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a front-loading washing machine, perhaps with objects on top."""
    width, depth, height = 0.6, rng.uniform(0.5, 0.62), 0.85
    body = Material((0.9, 0.9, 0.9), gloss=0.04)
    if rng.random() < 0.25:
        grey = float(rng.choice((0.15, 0.5, 0.7)))
        body = Material((grey, grey, grey * 1.02), gloss=0.1, roughness=0.5)
    trim = palette.METALS[0] if rng.random() < 0.5 else Material((0.25, 0.26, 0.28), gloss=0.04)
    face = depth - 0.001
    parts = [
        box(width, depth, height - 0.03, bevel=0.012).of(body),
        box(width + 0.004, depth + 0.01, 0.03, bevel=0.008).moved(z=height - 0.03).of(body),
        box(width - 0.02, 0.006, 0.002, bevel=0.0).moved(0, face, height - 0.15).of(palette.RUBBER),
        box(width - 0.02, 0.004, 0.004, bevel=0.0).moved(0, face, 0.09).of(palette.RUBBER),
    ]
    radius = rng.uniform(0.16, 0.2)
    door = lathe(
        [
            (radius + 0.02, 0.0),
            (radius + 0.02, 0.02),
            (radius, 0.035),
            (radius - 0.03, 0.03),
            (radius - 0.04, 0.01),
        ],
        28,
    )
    glass = lathe([(radius - 0.035, 0.012), (radius * 0.6, 0.03), (0, 0.038)], 24)
    for piece, material in ((door, trim), (glass, palette.BLACK_GLASS)):
        parts.append(piece.turned(-90, "x").moved(0, face, 0.41).of(material))
    grip = [
        (radius - 0.015 + 0.01 * math.cos(a), face + 0.04, 0.41 + 0.06 * math.sin(a))
        for a in (-1.2, 0.0, 1.2)
    ]
    parts.append(tube(grip, 0.009, 6).of(trim))
    panel = height - 0.14
    parts += [
        box(0.18, 0.006, 0.08, bevel=0.002).moved(0.18, face, panel + 0.01).of(body),
        box(0.07, 0.012, 0.012, bevel=0.0).moved(0.18, face + 0.004, panel + 0.02).of(trim),
        cylinder(0.032, 0.025, 16).turned(-90, "x").moved(0.02, face, panel + 0.05).of(trim),
        box(0.1, 0.004, 0.045, bevel=0.0).moved(-0.13, face, panel + 0.03).of(palette.BLACK_GLASS),
    ]
    parts += [
        cylinder(0.008, 0.008, 8).turned(-90, "x").moved(-0.21 - 0.025 * k, face, panel + 0.05).of(trim)
        for k in range(3)
    ]
    top = []
    if rng.random() < 0.5:
        top.append(folded_towels(rng, cloths(rng, style, int(rng.integers(1, 4)))).moved(0.12, 0.12, height))
    if rng.random() < 0.6:
        for k in range(int(rng.integers(1, 4))):
            top.append(bottle(rng).scaled(1.3).moved(-0.24 + 0.1 * k, 0.12, height))
    if not top and rng.random() < 0.4:
        bundle = superellipsoid(0.4, 0.3, 0.14, 0.7, 0.8, 16).of(palette.plain_fabric(rng))
        top.append(bundle.moved(0, 0.28, height))
    return join(parts, top)
