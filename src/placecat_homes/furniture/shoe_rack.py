"""Racks and cabinets for shoes."""

import numpy as np

from placecat_homes.furniture.blocks import between, block, chance, choose
from placecat_homes.furniture.coat_rack import shoes
from placecat_homes.mesh import Mesh, join
from placecat_homes.parts.drawers import pull
from placecat_homes.shapes import tube
from placecat_homes.style import Style


def shoe_rack(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a rack with pairs of shoes on two or three shelves."""
    width, deep = between(rng, 0.55, 0.95), between(rng, 0.28, 0.32)
    levels = int(rng.integers(2, 4))
    step = between(rng, 0.17, 0.21)
    high = step * levels
    wood = style.any_wood(rng)
    metal = chance(rng, 0.45)
    parts: list[Mesh] = []
    for side in (-1, 1):
        x = side * (width / 2 - 0.012)
        if metal:
            for y in (0.012, deep - 0.012):
                parts.append(tube([(x, y, 0), (x, y, high)], 0.01, 6).of(style.metal))
        else:
            parts.append(block(wood, (0.022, deep, high), (x, 0, 0), 0.003))
    for level in range(levels):
        z = 0.06 + level * step
        if metal:
            for y in (0.05, 0.12, 0.19, 0.26):
                line = [(-width / 2, y, z), (width / 2, y, z)]
                parts.append(tube(line, 0.006, 5).of(style.metal))
        else:
            parts.append(block(wood, (width - 0.03, deep, 0.018), (0, 0, z - 0.012)))
        x = -width / 2 + 0.14
        while x < width / 2 - 0.11:
            if chance(rng, 0.8):
                tall = level == levels - 1
                parts.append(shoes(rng, style, boots=None if tall else False).moved(x, 0.0, z + 0.006))
            x += 0.235
    return join(parts)


def shoe_cabinet(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a shallow shoe cabinet with tilt-out fronts."""
    width, deep = between(rng, 0.6, 1.0), between(rng, 0.18, 0.26)
    levels = int(rng.integers(2, 4))
    tall = between(rng, 0.36, 0.42)
    high = 0.06 + levels * tall + 0.02
    case = style.any_wood(rng)
    front = case if chance(rng, 0.5) else style.any_wood(rng)
    parts = [
        block(case, (width, deep - 0.02, high - 0.02), (0, 0, 0), 0.003),
        block(case, (width + 0.02, deep + 0.01, 0.022), (0, 0, high - 0.02), 0.004),
    ]
    columns = choose(rng, (1, 2)) if width > 0.75 else 1
    for level in range(levels):
        for column in range(columns):
            x = (column + 0.5) * width / columns - width / 2
            size = (width / columns - 0.008, 0.018, tall - 0.01)
            leaning = block(front, size, bevel=0.003).turned(-2, "x")
            parts.append(leaning.moved(x, deep - 0.022, 0.06 + level * tall))
            grip = pull(style, width / columns).moved(x, deep + 0.004, 0.06 + (level + 0.85) * tall)
            parts.append(grip)
    return join(parts)


def shoes_on_floor(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a few pairs of shoes left side by side on the floor."""
    count = int(rng.integers(1, 4))
    pairs = [
        shoes(rng, style)
        .turned(between(rng, -15, 15))
        .moved(0.26 * (k - (count - 1) / 2), between(rng, 0.05, 0.12))
        for k in range(count)
    ]
    whole = join(pairs)
    return whole.moved(0, -float(whole.low[1]))
