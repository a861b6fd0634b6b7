"""Serving trolleys."""

import math

import numpy as np

from placecat_homes import palette
from placecat_homes.furniture.blocks import between, chance, choose
from placecat_homes.furniture.dishes import bottle, bowl, glass, jug, plates, wine_glass
from placecat_homes.materials import Material
from placecat_homes.mesh import Mesh, join
from placecat_homes.parts.arrange import scattered
from placecat_homes.shapes import box, cylinder, tube
from placecat_homes.style import Style


def bar_cart(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a serving trolley with bottles and glasses."""
    w, d, height = between(rng, 0.6, 0.8), between(rng, 0.38, 0.45), between(rng, 0.72, 0.85)
    metal = style.metal
    tray: Material = choose(
        rng,
        (
            Material((0.82, 0.9, 0.88), gloss=0.08, roughness=0.0, opacity=0.35),
            style.wood,
            palette.BLACK_GLASS,
        ),
    )
    parts = []
    for sx in (-1, 1):
        for y in (0.012, d - 0.012):
            parts.append(
                tube([(sx * (w / 2 - 0.012), y, 0.07), (sx * (w / 2 - 0.012), y, height)], 0.009, 8).of(metal)
            )
            wheel = cylinder(0.035, 0.02, 12).turned(90, "y").moved(sx * (w / 2 - 0.012) - 0.01, y, 0.035)
            parts.append(wheel.of(palette.RUBBER))
    for z in (0.18, height - 0.08):
        parts.append(box(w - 0.01, d - 0.01, 0.012, 0.002).moved(0, 0.005, z).of(tray))
        for y in (0.012, d - 0.012):
            parts.append(tube([(-w / 2, y, z + 0.05), (w / 2, y, z + 0.05)], 0.005, 6).of(metal))
        things = [bottle(rng, style) for _ in range(int(rng.integers(2, 6)))]
        things += [choose(rng, (glass, wine_glass))(rng, style) for _ in range(int(rng.integers(2, 6)))]
        if chance(rng, 0.5):
            things.append(jug(rng, style))
        if chance(rng, 0.4):
            things.append(plates(rng, style, radius=0.09) if chance(rng, 0.5) else bowl(rng, style))
        parts.append(scattered(rng, things, w - 0.06, d - 0.06).moved(0, d / 2, z + 0.012))
    for x in (-w / 2 + 0.012, w / 2 - 0.012):
        angles = np.linspace(0, math.pi, 5)
        middle = d / 2
        bow = [(x, middle - (middle - 0.012) * math.cos(a), height + 0.02 * math.sin(a)) for a in angles]
        parts.append(tube(bow, 0.009, 8).of(metal))
    return join(parts).moved(y=0.023)
