"""Fire extinguishers."""

import numpy as np

from placecat_homes.furniture.blocks import between, block, chance
from placecat_homes.materials import Material
from placecat_homes.mesh import Mesh, join
from placecat_homes.shapes import box, lathe, tube
from placecat_homes.style import Style

RED = Material((0.72, 0.06, 0.05), gloss=0.05, roughness=0.15)
DARK = Material((0.04, 0.04, 0.045), gloss=0.03)
WHITE = Material((0.93, 0.93, 0.92))


def fire_extinguisher(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a fire extinguisher on a wall, often below a sign. It should hang about 0.5 m above the floor."""
    radius, high = between(rng, 0.075, 0.095), between(rng, 0.42, 0.52)
    line = [(0, 0), (radius * 0.95, 0), (radius, 0.02), (radius, high * 0.78), (radius * 0.75, high * 0.9),
            (0.025, high * 0.96), (0.022, high), (0, high)]  # fmt: skip
    y = radius + 0.03
    label = lathe([(radius + 0.001, high * 0.3), (radius + 0.001, high * 0.6)], 18).moved(0, y)
    hose = [(0.02, y, high + 0.02), (0.09, y, high - 0.03), (0.105, y, high * 0.5), (radius + 0.02, y, 0.06)]
    parts = [
        lathe(line, 18).moved(0, y).of(RED),
        box(0.05, 0.05, 0.05, 0.005).moved(0, y - 0.025, high - 0.01).of(DARK),
        box(0.02, 0.13, 0.015, 0.003).turned(12, "x").moved(0, y - 0.03, high + 0.03).of(DARK),
        box(0.02, 0.11, 0.012, 0.003).moved(0, y - 0.03, high + 0.015).of(DARK),
        tube(hose, 0.011, 6).of(DARK),
        label.of(WHITE),
        block(DARK, (0.035, 0.04, high * 0.7), (0, 0, high * 0.1)),
    ]
    if chance(rng, 0.7):
        up = high + between(rng, 0.5, 0.8)
        parts.append(block(RED, (0.15, 0.004, 0.15), (0, 0, up)))
        sign = [block(WHITE, (0.035, 0.002, 0.085), (0.02, 0.004, up + 0.02))]
        sign.append(block(WHITE, (0.02, 0.002, 0.02), (0.02, 0.004, up + 0.108)))
        sign.append(block(WHITE, (0.035, 0.002, 0.07), (-0.03, 0.004, up + 0.04)))
        parts.extend(sign)
    return join(parts)
