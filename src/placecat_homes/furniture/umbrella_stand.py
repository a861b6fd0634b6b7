"""Umbrella stands."""

import math

import numpy as np

from placecat_homes import palette
from placecat_homes.furniture.blocks import between, chance, choose
from placecat_homes.mesh import Mesh, join
from placecat_homes.shapes import lathe, tube
from placecat_homes.style import Style


def umbrella_stand(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a pot or tube with umbrellas in it."""
    radius, high = between(rng, 0.1, 0.14), between(rng, 0.42, 0.55)
    skin = choose(rng, (palette.ceramic(rng), style.metal, palette.plastic(rng), style.wood))
    bulge = between(rng, 1.0, 1.15)
    line = [(0, 0), (radius * 0.9, 0), (radius * bulge, high * 0.5), (radius, high), (radius - 0.008, high),
            (radius * 0.85, 0.02), (0, 0.02)]  # fmt: skip
    parts = [lathe(line, 18).of(skin)]
    for _ in range(int(rng.integers(1, 5))):
        angle = between(rng, 0, 6.28)
        c, s = math.cos(angle) * radius * 0.75, math.sin(angle) * radius * 0.75
        cloth = palette.plain_fabric(rng) if chance(rng, 0.7) else palette.fabric(rng)
        umbrella = lathe([(0, 0), (0.012, 0.02), (0.035, 0.4), (0.02, 0.6), (0, 0.62)], 8).of(cloth)
        hook = [(0, 0, 0.6), (0, 0, 0.8), (0.02, 0, 0.84), (0.06, 0, 0.84), (0.08, 0, 0.79)]
        handle = tube(hook, 0.009, 6).of(style.wood)
        tilted = join(umbrella, handle).turned(between(rng, 6, 11), "y").turned(math.degrees(angle))
        parts.append(tilted.moved(-0.2 * c, -0.2 * s, 0.03))
    whole = join(parts)
    return whole.moved(y=-float(whole.low[1]))
