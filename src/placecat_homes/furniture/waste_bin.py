"""Waste bins."""

import math

import numpy as np

from placecat_homes import palette
from placecat_homes.furniture.blocks import between, block, chance
from placecat_homes.materials import Material
from placecat_homes.mesh import Mesh, join
from placecat_homes.parts.prints import leaf
from placecat_homes.shapes import box, lathe, superellipsoid, tube
from placecat_homes.style import Style


def waste_bin(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a waste-paper bin, wire basket or box with crumpled paper in it."""
    high, radius = between(rng, 0.26, 0.38), between(rng, 0.12, 0.16)
    kind = rng.random()
    if kind < 0.5:
        skin = palette.plastic(rng) if chance(rng, 0.7) else style.metal
        line = [
            (0, 0),
            (radius * 0.8, 0),
            (radius, high),
            (radius - 0.006, high),
            (radius * 0.78, 0.01),
            (0, 0.01),
        ]
        body = lathe(line, 20).of(skin)
    elif kind < 0.75:
        wire = Material((0.06, 0.06, 0.065), gloss=0.03)
        parts = [lathe([(0, 0), (radius * 0.8, 0), (radius * 0.8, 0.015)], 16).of(wire)]
        net = Material(wire.colour, opacity=0.55)
        parts.append(lathe([(radius * 0.8, 0.01), (radius, high)], 20).of(net))
        rim = [(radius * math.cos(a), radius * math.sin(a), high) for a in np.linspace(0, 2 * math.pi, 17)]
        parts.append(tube(rim, 0.006, 6).of(wire))
        body = join(parts)
    else:
        skin = palette.plastic(rng)
        wide = 2 * radius
        sides = [
            block(skin, (wide, 0.005, high), (0, -wide / 2, 0)),
            block(skin, (wide, 0.005, high), (0, wide / 2 - 0.005, 0)),
            block(skin, (0.005, wide, high), (wide / 2, -wide / 2, 0)),
            block(skin, (0.005, wide, high), (-wide / 2, -wide / 2, 0)),
        ]
        body = join(sides, box(wide, wide, 0.01, 0).moved(0, -wide / 2).of(skin))
    parts = [body]
    for _ in range(int(rng.integers(1, 7))):
        angle, away = between(rng, 0, 6.28), between(rng, 0, radius * 0.4)
        ball = superellipsoid(0.09, 0.08, 0.08, 1, 1, 8).of(leaf(rng))
        place = away * math.cos(angle), away * math.sin(angle), high * between(rng, 0.6, 0.9)
        parts.append(ball.turned(between(rng, 0, 90), "x").moved(*place))
    whole = join(parts)
    return whole.moved(y=-float(whole.low[1]))
