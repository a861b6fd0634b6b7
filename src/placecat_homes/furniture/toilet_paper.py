"""Toilet paper on wall holders, on stands and in piles of spare rolls."""

import numpy as np

from placecat_homes.mesh import Mesh, join
from placecat_homes.parts.toiletries import roll, standing_roll
from placecat_homes.shapes import box, cylinder, tube
from placecat_homes.style import Style


def toilet_paper(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a roll on a wall holder. Its lowest point, at z = 0, should be about 0.6 m above the floor."""
    metal = style.metal
    parts = [
        roll(rng, rng.uniform(0.06, 0.14)).moved(0, 0.07),
        tube([(-0.075, 0.0, 0.0), (-0.075, 0.07, 0.0), (0.065, 0.07, 0.0)], 0.007, 6).of(metal),
        cylinder(0.022, 0.01, 10).turned(-90, "x").moved(-0.075).of(metal),
    ]
    if rng.random() < 0.5:
        parts.append(box(0.14, 0.11, 0.006, bevel=0.002).turned(-20, "x").moved(0, 0.02, 0.09).of(metal))
    mesh = join(parts)
    return mesh.moved(-float(mesh.low[0] + mesh.high[0]) / 2, 0, -float(mesh.low[2]))


def toilet_paper_stand(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a stand with one to three spare rolls on its pole and a roll on its arm."""
    metal = style.metal
    parts = [
        cylinder(0.09, 0.015, 16).of(metal),
        tube([(0, 0, 0.01), (0, 0, 0.62), (0.14, 0, 0.62)], 0.009, 8).of(metal),
        roll(rng, 0.1).moved(0.08, 0, 0.59),
    ]
    parts += [standing_roll(rng).moved(0, 0, 0.016 + 0.102 * k) for k in range(int(rng.integers(1, 4)))]
    mesh = join(parts)
    return mesh.moved(-float(mesh.low[0] + mesh.high[0]) / 2, -float(mesh.low[1]))


def toilet_paper_pile(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw spare rolls piled on the floor in up to three layers."""
    parts = [
        standing_roll(rng).moved(0.125 * (k - (2 - row) / 2), 0.065, 0.1 * row)
        for row in range(int(rng.integers(1, 4)))
        for k in range(3 - row)
    ]
    return join(parts)
