"""Benches and rows of waiting-room seats."""

import numpy as np

from placecat_homes import palette
from placecat_homes.furniture.blocks import backed, between, block, chance, choose
from placecat_homes.mesh import Mesh, join
from placecat_homes.parts.forming import bent
from placecat_homes.shapes import superellipsoid, tube
from placecat_homes.style import Style


def bench(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a slatted or cushioned bench, or a row of seats on a shared beam."""
    return _seats(rng, style) if chance(rng, 0.45) else _slats(rng, style)


def _slats(rng: np.random.Generator, style: Style) -> Mesh:
    width, deep = between(rng, 1.0, 1.8), between(rng, 0.36, 0.45)
    wood = style.any_wood(rng)
    frame = style.metal if chance(rng, 0.5) else wood
    parts: list[Mesh] = []
    if chance(rng, 0.3):
        parts.append(block(wood, (width, deep, 0.06), (0, 0, 0.36), 0.01))
        cushion = superellipsoid(width, deep, 0.08, 0.3, 0.15, 20).moved(0, deep / 2, 0.41)
        parts.append(cushion.of(style.any_fabric(rng)))
    else:
        count = int(rng.integers(4, 7))
        step = deep / count
        for k in range(count):
            parts.append(block(wood, (width, step * 0.82, 0.03), (0, k * step, 0.42), 0.004))
    for x in (-width / 2 + 0.15, width / 2 - 0.15):
        for y in (0.05, deep - 0.05):
            parts.append(tube([(x, y, 0), (x, y, 0.42)], 0.018, 8).of(frame))
        parts.append(block(frame, (0.035, deep - 0.04, 0.03), (x, 0.02, 0.385)))
    if chance(rng, 0.45):
        for k in range(3):
            parts.append(block(wood, (width, 0.025, 0.08), (0, 0.0, 0.55 + 0.11 * k), 0.004))
        for x in (-width / 2 + 0.15, width / 2 - 0.15):
            parts.append(tube([(x, 0.03, 0.38), (x, 0.03, 0.86)], 0.015, 6).of(frame))
    return backed(join(parts))


def _seats(rng: np.random.Generator, style: Style) -> Mesh:
    count = int(rng.integers(2, 5))
    shell = choose(rng, (palette.plastic(rng), palette.plain_fabric(rng), style.wood))
    frame = style.metal
    step = 0.56
    parts: list[Mesh] = []
    for k in range(count):
        x = (k - (count - 1) / 2) * step
        seat = superellipsoid(0.46, 0.44, 0.05, 0.35, 0.3, 16).moved(x, 0.3, 0.42)
        back = bent(superellipsoid(0.46, 0.04, 0.4, 0.35, 0.3, 16), 0.7).turned(12, "x").moved(x, 0.07, 0.48)
        parts.extend([seat.of(shell), back.of(shell)])
        line = [(x, 0.3, 0.4), (x, 0.12, 0.4), (x, 0.07, 0.5), (x, 0.02, 0.7)]
        parts.append(tube(line, 0.014, 6).of(frame))
    width = count * step
    parts.append(block(frame, (width - 0.2, 0.06, 0.05), (0, 0.27, 0.36)))
    for x in (-width / 2 + 0.25, width / 2 - 0.25):
        parts.append(tube([(x, 0.3, 0.37), (x, 0.3, 0.03)], 0.022, 8).of(frame))
        parts.append(block(frame, (0.05, 0.5, 0.025), (x, 0.05, 0), 0.006))
    return backed(join(parts))
