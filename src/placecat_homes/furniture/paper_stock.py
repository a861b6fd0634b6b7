"""Reams and boxes of paper."""

import numpy as np

from placecat_homes.furniture.blocks import between, block, chance, choose
from placecat_homes.materials import Material
from placecat_homes.mesh import Mesh, join
from placecat_homes.parts.prints import ink, leaf, lying
from placecat_homes.shapes import box
from placecat_homes.style import Style


def reams(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a pile of wrapped reams of paper. The top ream may be open."""
    brand, ground = Material(ink(rng), gloss=0.03), Material((0.93, 0.93, 0.92), gloss=0.03)
    parts = []
    z = 0.0
    for _ in range(int(rng.integers(1, 7))):
        turn, shift = float(rng.normal(0, 3)), rng.normal(0, 0.006, 2)
        ream = join(
            box(0.21, 0.297, 0.052, 0.002).of(ground),
            box(0.212, 0.12, 0.053, 0).moved(0, 0.03, 0.0003).of(brand),
        )
        parts.append(ream.moved(y=-0.15).turned(turn).moved(float(shift[0]), float(shift[1]) + 0.15, z))
        z += 0.053
    if chance(rng, 0.4):
        parts.append(box(0.205, 0.29, 0.02, 0).of(leaf(rng, white=0.9)).moved(0, 0.005, z))
        parts.append(lying(rng).turned(20).moved(0, 0.15, z + 0.021))
    whole = join(parts)
    return whole.moved(y=-float(whole.low[1]))


def paper_boxes(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw one or two piles of cardboard boxes full of paper."""
    card = Material(choose(rng, ((0.66, 0.52, 0.36), (0.9, 0.89, 0.86), (0.55, 0.43, 0.3))))
    lid = card if chance(rng, 0.5) else Material((0.92, 0.92, 0.9))
    brand = Material(ink(rng))
    wide, deep, high = 0.45, 0.31, 0.26
    parts: list[Mesh] = []
    columns = int(rng.integers(1, 3))
    for column in range(columns):
        x = (column - (columns - 1) / 2) * (wide + 0.03)
        z = 0.0
        count = int(rng.integers(1, 4))
        for k in range(count):
            opened = k == count - 1 and chance(rng, 0.3)
            body = [block(card, (wide, deep, high))]
            body.append(block(brand, (wide * 0.5, 0.002, high * 0.35), (0, deep, high * 0.15)))
            if opened:
                body.append(block(leaf(rng, white=1), (wide - 0.02, deep - 0.02, 0.004), (0, 0.01, high)))
            else:
                body.append(block(lid, (wide + 0.012, deep + 0.012, 0.08), (0, -0.006, high - 0.078)))
            turn = float(rng.normal(0, 3))
            parts.append(join(body).moved(y=-deep / 2).turned(turn).moved(x, deep / 2 + 0.03, z))
            z += high
    whole = join(parts)
    return whole.moved(-float(whole.low[0] + whole.high[0]) / 2, -float(whole.low[1]))


def paper_pallet(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw an open steel shelf stocked with reams of paper."""
    wide, deep, high = between(rng, 0.8, 1.0), 0.36, between(rng, 1.1, 1.9)
    grey = between(rng, 0.25, 0.8)
    steel = Material((grey, grey, grey), gloss=0.03)
    parts = []
    for x in (-wide / 2 + 0.015, wide / 2 - 0.015):
        for y in (0.0, deep - 0.03):
            parts.append(block(steel, (0.03, 0.03, high), (x, y, 0)))
    levels = round(high / 0.36)
    for level in range(levels):
        z = 0.08 + level * (high - 0.1) / max(1, levels - 1) * 0.95
        parts.append(block(steel, (wide - 0.01, deep, 0.025), (0, 0, z)))
        if level == levels - 1 and chance(rng, 0.5):
            continue
        x = -wide / 2 + 0.15
        while x < wide / 2 - 0.12:
            if chance(rng, 0.88):
                brand, up = ink(rng), z + 0.025
                for _ in range(int(rng.integers(2, 6))):
                    parts.append(block(Material((0.93, 0.93, 0.92)), (0.21, 0.297, 0.05), (x, 0.03, up)))
                    parts.append(block(Material(brand), (0.212, 0.2975, 0.022), (x, 0.03, up + 0.012)))
                    up += 0.052
            x += 0.235
    return join(parts)
