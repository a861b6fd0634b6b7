"""Cushions, pillows and blankets on seats."""

import math
from collections.abc import Sequence

import numpy as np

from placecat_homes.furniture.blocks import between, choose
from placecat_homes.materials import Material
from placecat_homes.mesh import Mesh, join
from placecat_homes.parts.lofts import pillow
from placecat_homes.shapes import sheet, superellipsoid
from placecat_homes.style import Style


def seat(width: float, depth: float, thickness: float, softness: float = 0.25) -> Mesh:
    """Draw a seat cushion lying on z = 0 with its back at y = 0."""
    return superellipsoid(width, depth, thickness, softness * 1.6, softness * 0.6, 20).moved(0, depth / 2, 0)


def upright(width: float, thickness: float, height: float, softness: float = 0.3) -> Mesh:
    """Draw a back cushion standing on z = 0 with its back at y = 0."""
    lying = superellipsoid(width, height, thickness, softness * 1.6, softness * 0.8, 20)
    return lying.moved(0, height / 2, -thickness).turned(90, "x")


def scatter(rng: np.random.Generator, style: Style, width: float, count: int | None = None) -> Mesh:
    """Draw loose pillows leaning against a backrest.

    Parameters
    ----------
    rng
        Random number generator.
    style
        Style of the home.
    width
        Width of the seat in metres.
    count
        Number of pillows; chosen at random if None.

    Returns
    -------
    Mesh
        Pillows on a seat at z = 0, with the backrest at y = 0.
    """
    count = int(rng.integers(0, 2 + round(width / 0.45))) if count is None else count
    first, second = style.any_fabric(rng), style.any_fabric(rng)
    parts = []
    for k in range(count):
        size = between(rng, 0.36, 0.48)
        edge = width / 2 - size / 2
        if edge < 0:
            break
        x = (edge, -edge, edge * 0.55, -edge * 0.55)[k] if k < 4 else between(rng, -edge, edge)
        one = pillow(size, size * choose(rng, (1.0, 1.0, 0.65)), 0.14, 8)
        lean = one.turned(90 + between(rng, -32, -12), "x").turned(between(rng, -15, 15))
        lean = lean.moved(0, -float(lean.low[1]) + 0.01, -float(lean.low[2]) - 0.01)
        parts.append(lean.moved(x, 0.1 if k > 1 else 0.0, 0).of(choose(rng, (first, second))))
    return join(parts)


def thrown(
    path: Sequence[tuple[float, float]], width: float, material: Material, away: float = 0.012
) -> Mesh:
    """Draw a blanket draped over a surface.

    Parameters
    ----------
    path
        Points (y, z) along the surface, from one end of the blanket to the other, with the outside on the
        left.
    width
        Width along x in metres.
    material
        Material of the blanket.
    away
        Distance from the surface in metres.

    Returns
    -------
    Mesh
        A thin sheet, centred on x = 0.
    """
    points = np.asarray(path, float)
    steps = np.diff(points, axis=0)
    length = np.r_[0.0, np.cumsum(np.hypot(*steps.T))]

    def surface(s: np.ndarray, t: np.ndarray) -> tuple[np.ndarray, ...]:
        run = t * length[-1]
        y = np.interp(run, length, points[:, 0])
        z = np.interp(run, length, points[:, 1])
        ahead = np.clip(run + 0.03, 0, length[-1]), np.clip(run - 0.03, 0, length[-1])
        dy = np.interp(ahead[0], length, points[:, 0]) - np.interp(ahead[1], length, points[:, 0])
        dz = np.interp(ahead[0], length, points[:, 1]) - np.interp(ahead[1], length, points[:, 1])
        norm = np.maximum(np.hypot(dy, dz), 1e-9)
        fold = away + 0.006 * (1 + np.sin(s * math.pi * 2 * max(2, round(width / 0.14)) + 2 * t))
        x = (s - 0.5) * width * (1 + 0.04 * np.sin(5 * t))
        return x, y - dz / norm * fold, z + dy / norm * fold

    return sheet(surface, 24, 22, (width, float(length[-1]))).of(material)
