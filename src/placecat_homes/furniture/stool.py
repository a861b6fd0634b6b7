"""Stools."""

import math
from itertools import pairwise

import numpy as np

from placecat_homes.furniture.blocks import between, chance, leg
from placecat_homes.furniture.chair import seat_cover
from placecat_homes.mesh import Mesh
from placecat_homes.parts.arrange import grounded
from placecat_homes.shapes import lathe, tube
from placecat_homes.style import Style


def stool(rng: np.random.Generator, style: Style, *, height: float = 0.46) -> Mesh:
    """Draw a stool. Stools for a breakfast bar should be 0.65 m high."""
    wood = style.any_wood(rng)
    r = between(rng, 0.16, 0.19)
    kind = rng.random()
    parts: list[Mesh] = []
    if kind < 0.65 or height < 0.55:
        metal = chance(rng, 0.35)
        material = style.metal if metal else wood
        thick = (0.011, 0.011) if metal else (0.018, 0.013)
        for k in range(4):
            a = math.pi / 4 + k * math.pi / 2
            top = (0.7 * r * math.cos(a), 0.7 * r * math.sin(a))
            foot = (1.05 * r * math.cos(a), 1.05 * r * math.sin(a))
            parts.append(leg(foot, top, height - 0.02, *thick, 8).of(material))
        level = height * 0.35
        reach = (1.05 - 0.35 * 0.35) * r
        angles = [math.pi / 4 + k * math.pi / 2 for k in range(5)]
        corners = [(reach * math.cos(a), reach * math.sin(a), level) for a in angles]

        for start, end in pairwise(corners):
            parts.append(tube([start, end], 0.008, 6).of(material))
    else:
        parts.append(lathe([(0, 0), (0.2, 0), (0.2, 0.01), (0.03, 0.03), (0.025, 0.05)], 18).of(style.metal))
        parts.append(tube([(0, 0, 0.03), (0, 0, height - 0.03)], 0.022, 10).of(style.metal))
        hoop = [(0.13 * math.cos(a), 0.13 * math.sin(a), 0.25) for a in np.linspace(0, 2 * math.pi, 15)]
        parts.append(tube(hoop, 0.008, 6).of(style.metal))
    if chance(rng, 0.5):
        seat = lathe([(0, 0), (r, 0), (r + 0.004, 0.015), (r, 0.03), (0, 0.032)], 20).of(wood)
    else:
        cloth = seat_cover(rng, style)
        seat = lathe([(0, 0), (r, 0), (r + 0.01, 0.03), (r * 0.9, 0.055), (0, 0.06)], 20).of(cloth)
    parts.append(seat.moved(z=height - 0.03))
    return grounded(parts)
