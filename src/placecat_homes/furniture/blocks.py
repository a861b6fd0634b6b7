"""Parts shared by many pieces of furniture, such as boards, legs and handles."""

import math
from collections.abc import Sequence
from dataclasses import replace
from typing import TypeVar

import numpy as np

from placecat_homes.materials import Material
from placecat_homes.mesh import Mesh, empty, join
from placecat_homes.shapes import box, lathe, tube

T = TypeVar("T")


def choose(rng: np.random.Generator, options: Sequence[T], weights: Sequence[float] | None = None) -> T:
    """Choose one of the options at random."""
    p = None if weights is None else np.asarray(weights, float) / sum(weights)
    return options[int(rng.choice(len(options), p=p))]


def between(rng: np.random.Generator, low: float, high: float) -> float:
    """Draw a random number between two limits."""
    return float(rng.uniform(low, high))


def chance(rng: np.random.Generator, probability: float) -> bool:
    """Return True with the given probability."""
    return bool(rng.random() < probability)


def block(
    material: Material,
    size: tuple[float, float, float],
    at: tuple[float, float, float] = (0.0, 0.0, 0.0),
    bevel: float = 0.0,
) -> Mesh:
    """Draw a box made of one material.

    Parameters
    ----------
    material
        Material of the box.
    size
        Width, depth and height in metres.
    at
        Midpoint of the lower back edge.
    bevel
        Width of the bevels in metres.

    Returns
    -------
    Mesh
        The box.
    """
    return box(*size, bevel=bevel).moved(*at).of(material)


def backed(mesh: Mesh) -> Mesh:
    """Centre a piece on x = 0 and move its back to y = 0, leaving its z coordinates unchanged."""
    low, high = mesh.low, mesh.high
    return mesh.moved(-float(low[0] + high[0]) / 2, -float(low[1]), 0.0)


def leg(
    foot: tuple[float, float],
    top: tuple[float, float],
    height: float,
    thick: float,
    thin: float,
    segments: int = 10,
) -> Mesh:
    """Draw a round leg that tapers towards its foot.

    Parameters
    ----------
    foot, top
        Position (x, y) of the axis at the lower and upper ends, in metres.
    height
        Height in metres.
    thick, thin
        Radius at the top and at the foot, in metres.
    segments
        Number of segments around the axis.

    Returns
    -------
    Mesh
        A mesh with its base at z = 0.
    """
    straight = lathe([(0, 0), (thin, 0), (thick, height), (0, height)], segments)
    up = straight.vertices[:, 2:3] / height
    shift = (1 - up) * np.array([foot]) + up * np.array([top])
    vertices = straight.vertices.copy()
    vertices[:, :2] += shift.astype(np.float32)
    return replace(straight, vertices=vertices)


def legs(
    kind: str, width: float, depth: float, height: float, material: Material, thickness: float = 0.04
) -> Mesh:
    """Draw the legs of a table, sofa or cabinet.

    Parameters
    ----------
    kind
        "square", "round", "tapered", "splayed", "turned" or "sled".
    width, depth
        Outer size of the rectangle formed by the legs, in metres.
    height
        Height in metres.
    material
        Material of the legs.
    thickness
        Thickness in metres.

    Returns
    -------
    Mesh
        The legs, centred on x = 0, with the back of the rectangle at y = 0.
    """
    t = thickness
    parts: list[Mesh] = []
    if kind == "sled":
        for side in (-1, 1):
            x = side * (width / 2 - t)
            parts.append(
                tube([(x, t, height), (x, t, t / 3), (x, depth - t, t / 3), (x, depth - t, height)], t / 3, 8)
            )
        return join(parts).of(material)
    for side in (-1, 1):
        for y in (t / 2, depth - t / 2):
            x = side * (width / 2 - t / 2)
            inwards = -side * t * 0.8, (t if y < depth / 2 else -t) * 0.8
            if kind == "square":
                parts.append(box(t, t, height, 0).moved(x, y - t / 2, 0))
            elif kind == "round":
                parts.append(leg((x, y), (x, y), height, t / 2, t / 2))
            elif kind == "tapered":
                parts.append(leg((x, y), (x, y), height, t / 2, t / 4))
            elif kind == "turned":
                h = height
                profile = [
                    (0, 0),
                    (t * 0.25, 0),
                    (t * 0.4, h * 0.12),
                    (t * 0.28, h * 0.2),
                    (t * 0.45, h * 0.5),
                    (t * 0.3, h * 0.72),
                    (t * 0.5, h * 0.76),
                    (t * 0.5, h),
                    (0, h),
                ]
                parts.append(lathe(profile, 10).moved(x, y))
            else:
                parts.append(leg((x, y), (x + inwards[0], y + inwards[1]), height, t / 2, t / 3.5))
    return join(parts).of(material)


def open_box(
    material: Material,
    size: tuple[float, float, float],
    board: float = 0.018,
    *,
    back: bool = True,
    bottom: bool = True,
    top: bool = True,
) -> Mesh:
    """Draw an open-fronted case made of boards, for shelves and cupboards.

    Parameters
    ----------
    material
        Material of the boards.
    size
        Width, depth and height in metres.
    board
        Thickness of the boards in metres.
    back, bottom, top
        Whether to include each of these boards.

    Returns
    -------
    Mesh
        A case with its back at y = 0.
    """
    width, depth, height = size
    parts = [block(material, (board, depth, height), (side * (width - board) / 2, 0, 0)) for side in (-1, 1)]
    inner = width - 2 * board
    if back:
        parts.append(block(material, (inner, 0.006, height)))
    if bottom:
        parts.append(block(material, (inner, depth, board)))
    if top:
        parts.append(block(material, (inner, depth, board), (0, 0, height - board)))
    return join(parts)


def handle(kind: str, material: Material, length: float = 0.14) -> Mesh:
    """Draw the handle of a drawer or door: a horizontal bar, a knob, or nothing for "none".

    Parameters
    ----------
    kind
        Kind of handle (see `Style.handle`).
    material
        Material of the handle.
    length
        Length of a bar in metres.

    Returns
    -------
    Mesh
        A handle in front of the plane y = 0, centred on the origin.
    """
    if kind == "bar":
        h = length / 2
        return tube([(-h, 0, 0), (-h, 0.025, 0), (h, 0.025, 0), (h, 0, 0)], 0.005, 6).of(material)
    if kind == "knob":
        profile = [(0, 0), (0.006, 0), (0.006, 0.012), (0.014, 0.02), (0.01, 0.028), (0, 0.029)]
        return lathe(profile, 10).turned(-90, "x").of(material)
    return empty()


def ring(radius: float, count: int, start: float = 0.0) -> list[tuple[float, float]]:
    """Return points on a circle in counter-clockwise order."""
    return [
        (
            radius * math.cos(start + 2 * math.pi * k / count),
            radius * math.sin(start + 2 * math.pi * k / count),
        )
        for k in range(count)
    ]


def shade(low: float, high: float, height: float, material: Material, segments: int = 22) -> Mesh:
    """Draw a lampshade that is open at the top and bottom.

    Parameters
    ----------
    low, high
        Radii of the lower and upper rims, in metres.
    height
        Height in metres.
    material
        Material of both the inside and the outside.
    segments
        Number of segments around the axis.

    Returns
    -------
    Mesh
        A shade around the z axis, with its lower rim at z = 0.
    """
    t = 0.003
    return lathe([(low - t, 0), (low, 0), (high, height), (high - t, height), (low - t, 0)], segments).of(
        material
    )
