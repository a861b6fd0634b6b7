"""Filing cabinets with drawers or doors."""

import numpy as np

from placecat_homes import palette
from placecat_homes.furniture.blocks import between, block, chance, choose
from placecat_homes.materials import Material
from placecat_homes.mesh import Mesh, join
from placecat_homes.parts.drawers import chest
from placecat_homes.parts.prints import leaf
from placecat_homes.shapes import quad
from placecat_homes.style import Style


def filing_cabinet(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a cabinet with two to four deep, labelled drawers."""
    skin = _skin(rng, style)
    front = skin if chance(rng, 0.7) else palette.paint(rng)
    count = int(rng.integers(2, 5))
    wide, deep = choose(rng, ((0.42, 0.6), (0.47, 0.62), (0.8, 0.45)), (2, 2, 1))
    high = 0.08 + 0.31 * count
    body = chest(
        style, wide, deep, high, (1.0,) * count, skin, front, plinth=0.05, handle=choose(rng, ("bar", "none"))
    )
    step = (high - 0.06) / count
    labels = [
        quad(0.09, 0.035).moved(0, deep + 0.001, 0.05 + step * (k + 0.6)).of(leaf(rng)) for k in range(count)
    ]
    return join(body, labels)


def steel_cabinet(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a tall or half-height cabinet with two doors or a roller shutter."""
    skin = _skin(rng, style)
    wide, deep = between(rng, 0.8, 1.0), between(rng, 0.4, 0.48)
    high = choose(rng, (between(rng, 1.75, 1.98), between(rng, 0.95, 1.2)), (0.6, 0.4))
    parts = [block(skin, (wide, deep - 0.02, high - 0.06), (0, 0, 0.06), 0.004)]
    parts.append(block(Material((0.1, 0.1, 0.1)), (wide - 0.02, deep - 0.05, 0.06)))
    front = skin if chance(rng, 0.6) else palette.paint(rng)
    if chance(rng, 0.3):
        count = 26
        step = (wide - 0.06) / count
        for k in range(count):
            x = -wide / 2 + 0.03 + (k + 0.5) * step
            parts.append(block(front, (step * 0.8, 0.012, high - 0.14), (x, deep - 0.02, 0.1)))
    else:
        for side in (-1, 1):
            door = (wide / 2 - 0.006, 0.018, high - 0.08)
            parts.append(block(front, door, (side * wide / 4, deep - 0.02, 0.07), 0.003))
    grip = (0.02, 0.025, 0.13)
    parts.append(block(style.metal, grip, (-0.035, deep - 0.008, high * 0.5)))
    if chance(rng, 0.4):
        parts.append(quad(0.15, 0.21).moved(wide / 4, deep + 0.001, high * 0.7).of(leaf(rng, white=0.5)))
    return join(parts)


def _skin(rng: np.random.Generator, style: Style) -> Material:
    kind = rng.random()
    if kind < 0.5:
        grey = between(rng, 0.35, 0.85)
        return Material((grey, grey, grey * between(rng, 0.92, 1.0)), gloss=0.03)
    return palette.paint(rng) if kind < 0.8 else style.wood
