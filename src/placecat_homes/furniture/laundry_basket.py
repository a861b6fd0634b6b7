"""Laundry baskets and heaps of clothes."""

import math

import numpy as np
from numpy.typing import NDArray

from placecat_homes import palette
from placecat_homes.materials import Material, Texture
from placecat_homes.mesh import Mesh, join
from placecat_homes.parts.lofts import loft, plate, rounded
from placecat_homes.shapes import sheet, tube
from placecat_homes.style import Style


def laundry_basket(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a wicker, plastic or fabric basket, either closed or with clothes hanging out."""
    width, height = rng.uniform(0.36, 0.5), rng.uniform(0.45, 0.65)
    depth = width * rng.uniform(0.75, 1.0)
    kind = str(rng.choice(("wicker", "plastic", "cloth"), p=(0.5, 0.25, 0.25)))
    base = palette.WOODS[int(rng.integers(len(palette.WOODS)))]
    if kind == "wicker":
        weave = Texture("wicker", (base, palette.shade(base, 0.4)), (0.16, 0.16), int(rng.integers(1 << 30)))
        material = Material(texture=weave)
    else:
        material = palette.plastic(rng) if kind == "plastic" else style.any_fabric(rng)
    radius = width * rng.uniform(0.1, 0.5)
    taper = rng.uniform(0.8, 0.95)
    top = rounded(width, depth, radius, y=-depth / 2)
    inner = rounded(width - 0.03, depth - 0.03, radius, y=-depth / 2 + 0.015)
    closed = rng.random() < 0.45
    parts = [
        loft([(top * taper, 0.0), (top, height), (inner, height), (inner * 0.97, height - 0.12)]).of(
            material
        ),
        tube([(*point, height - 0.01) for point in [*top, top[0]]], 0.01, 6).of(material),
    ]
    if closed:
        parts.append(plate(top * 1.02, 0.03, 0.01).moved(z=height).of(material))
    else:
        for _ in range(int(rng.integers(1, 4))):
            clothes = heap(rng, style.any_fabric(rng), depth * 0.62, 0.14)
            spot = rng.uniform(-0.02, 0.02, 2)
            parts.append(clothes.moved(float(spot[0]), float(spot[1]), height - 0.11 + rng.uniform(0, 0.05)))
    mesh = join(parts)
    return mesh.moved(0, -float(mesh.low[1]))


def heap(rng: np.random.Generator, cloth: Material, width: float, height: float) -> Mesh:
    """Draw a crumpled piece of clothing lying on z = 0, centred on the origin."""
    waves = rng.uniform(0, 2 * math.pi, 6)
    stretch = rng.uniform(0.5, 0.85)

    def surface(s: NDArray[np.float64], t: NDArray[np.float64]) -> tuple[NDArray[np.float64], ...]:
        angle, out = 2 * math.pi * s, 1 - 0.999 * t
        edge = (
            1
            + 0.3 * np.sin(2 * angle + waves[5]) * np.sin(3 * angle + waves[0])
            + 0.14 * np.sin(5 * angle + waves[1])
        )
        bump = 1 + 0.6 * np.sin(4 * angle + 5 * out + waves[2]) * np.sin(math.pi * out)
        x = width / 2 * out * edge * np.cos(angle)
        y = width / 2 * stretch * out * edge * np.sin(angle)
        crease = 0.2 * np.sin(14 * x / width + waves[3]) * np.sin(12 * y / width + waves[4])
        z = height * np.maximum(1 - out**1.5, 0) ** 0.8 * np.clip(bump * 0.7 + 1.4 * crease, 0.15, 1.5)
        return x, y, z

    return sheet(surface, 18, 8, (width * 2, width)).of(cloth)


def laundry_heap(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a few items of clothing dropped on the floor."""
    parts = []
    for k in range(int(rng.integers(1, 4))):
        cloth = style.any_fabric(rng) if rng.random() < 0.5 else palette.plain_fabric(rng)
        piece = heap(rng, cloth, rng.uniform(0.3, 0.5), rng.uniform(0.05, 0.1))
        parts.append(piece.moved(rng.uniform(-0.15, 0.15), rng.uniform(-0.1, 0.1), 0.012 * k))
    mesh = join(parts)
    return mesh.moved(-float(mesh.low[0] + mesh.high[0]) / 2, -float(mesh.low[1]), 0)
