"""Bathroom shelves and cabinets with bottles and towels."""

import numpy as np

from placecat_homes import palette
from placecat_homes.furniture.towel import cloths
from placecat_homes.mesh import Mesh, join
from placecat_homes.parts.fittings import FRONTS, fronts
from placecat_homes.parts.toiletries import folded_towels, rolled_towel, row, standing_roll
from placecat_homes.shapes import box, tube
from placecat_homes.style import Style


def _load(rng: np.random.Generator, style: Style, width: float, fill: float) -> Mesh:
    """Fill one shelf with bottles, folded or rolled towels, or toilet paper."""
    choice = rng.random()
    if choice < 0.55 or width < 0.25:
        return row(rng, width - 0.04, fill).moved(0, 0.11)
    if choice < 0.75:
        return folded_towels(rng, cloths(rng, style, int(rng.integers(1, 4))), min(width * 0.8, 0.3))
    if choice < 0.88:
        count = int((width - 0.02) / 0.11)
        towels = cloths(rng, style, count)
        return join(
            rolled_towel(towels[k], 0.2).moved((k - (count - 1) / 2) * 0.108, 0.01) for k in range(count)
        )
    count = max(1, int((width - 0.05) / 0.13))
    return join(standing_roll(rng).moved((k - (count - 1) / 2) * 0.125, 0.09) for k in range(count))


def bathroom_shelf(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw an open floor-standing rack, made of wood or metal and full of bottles and towels."""
    width, height, depth = rng.uniform(0.35, 0.6), rng.uniform(0.9, 1.75), rng.uniform(0.24, 0.3)
    wood = style.any_wood(rng)
    boards = max(3, round(height / 0.38))
    steel = rng.random() < 0.4
    parts = []
    for k in range(boards):
        z = 0.1 + (height - 0.12) * k / (boards - 1)
        parts.append(box(width, depth, 0.02, bevel=0.0).moved(z=z).of(wood))
        if rng.random() < 0.9:
            parts.append(_load(rng, style, width, 0.5 + 0.5 * style.clutter).moved(z=z + 0.02))
    corners = [(x, y) for x in (-width / 2 + 0.012, width / 2 - 0.012) for y in (0.012, depth - 0.012)]
    if steel:
        parts += [tube([(x, y, 0), (x, y, height + 0.06)], 0.011, 6).of(style.metal) for x, y in corners]
    else:
        parts += [box(0.03, 0.03, height + 0.02, bevel=0.0).moved(x, y - 0.015).of(wood) for x, y in corners]
    mesh = join(parts)
    return mesh.moved(0, -min(0.0, float(mesh.low[1])))


def bathroom_wall_shelf(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw one to three wall shelves with bottles and jars. Their lowest point is at z = 0."""
    width, depth = rng.uniform(0.4, 0.7), rng.uniform(0.14, 0.2)
    material = palette.GLASS if rng.random() < 0.3 else style.any_wood(rng)
    parts = []
    for k in range(int(rng.integers(1, 4))):
        z = 0.32 * k
        parts.append(box(width, depth, 0.018, bevel=0.0).moved(z=z).of(material))
        parts.append(row(rng, width - 0.04, 0.55 + 0.45 * style.clutter).moved(0, depth / 2, z + 0.018))
        parts += [
            box(0.015, depth * 0.7, 0.03, bevel=0.0).moved(x, 0, z - 0.03).of(style.metal)
            for x in (-width * 0.38, width * 0.38)
        ]
    mesh = join(parts)
    return mesh.moved(z=-float(mesh.low[2]))


def bathroom_cabinet(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a tall, narrow cabinet with doors, drawers and an open compartment for towels."""
    width, depth, height = rng.uniform(0.3, 0.45), rng.uniform(0.28, 0.36), rng.uniform(1.5, 1.9)
    material = style.fronts if rng.random() < 0.5 else style.any_wood(rng)
    design = "flat" if style.modern > 0.55 else str(rng.choice(FRONTS))
    low, middle, gap = 0.1, 0.62, 0.34
    parts = [
        box(width, depth, middle - low, bevel=0.0).moved(z=low).of(material),
        box(width, 0.012, gap, bevel=0.0).moved(z=middle).of(material),
        box(width, depth, height - middle - gap, bevel=0.0).moved(z=middle + gap).of(material),
        box(width - 0.02, depth - 0.04, low, bevel=0.0).of(material),
    ]
    parts += [
        box(0.016, depth, gap, bevel=0.0).moved(x, 0, middle).of(material)
        for x in (-width / 2 + 0.008, width / 2 - 0.008)
    ]
    drawers = int(rng.integers(1, 4))
    parts.append(
        fronts(
            width,
            middle - low,
            material,
            style.metal,
            rows=drawers,
            design=design,
            grip=style.handle,
            doors=drawers == 1,
        ).moved(0, depth, low)
    )
    parts.append(
        fronts(
            width, height - middle - gap, material, style.metal, design=design, grip=style.handle, doors=True
        ).moved(0, depth, middle + gap)
    )
    towels = folded_towels(rng, cloths(rng, style, int(rng.integers(2, 5))), min(width - 0.06, 0.3))
    parts.append(towels.moved(0, 0.03, middle + 0.002))
    return join(parts)
