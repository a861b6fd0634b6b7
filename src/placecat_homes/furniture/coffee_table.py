"""Coffee tables."""

import math

import numpy as np

from placecat_homes import palette
from placecat_homes.furniture import books
from placecat_homes.furniture.blocks import between, block, chance, choose, legs
from placecat_homes.furniture.box import storage_box
from placecat_homes.furniture.clutter import table_things
from placecat_homes.mesh import Mesh, join
from placecat_homes.parts.arrange import grounded
from placecat_homes.shapes import box, cylinder, extrude, tube
from placecat_homes.style import Style


def coffee_table(rng: np.random.Generator, style: Style, width: float | None = None) -> Mesh:
    """Draw a coffee table, a chest or a nest of two tables, with objects on top.

    Parameters
    ----------
    rng
        Random number generator.
    style
        Style of the home.
    width
        Width in metres; chosen at random if None.

    Returns
    -------
    Mesh
        A mesh with its base at z = 0.
    """
    width = between(rng, 0.75, 1.25) if width is None else width
    kind = choose(rng, (_rectangular, _round, _glass, _chest, _nest), (3, 2, 1.5, 0.8, 0.8))
    return grounded(kind(rng, style, width))


def _things(rng: np.random.Generator, style: Style, width: float, depth: float) -> Mesh:
    return table_things(rng, style, width, depth, int(rng.integers(1, 4 + round(4 * style.clutter))))


def _rectangular(rng: np.random.Generator, style: Style, width: float) -> Mesh:
    depth, height = width * between(rng, 0.5, 0.62), between(rng, 0.38, 0.48)
    wood = style.any_wood(rng)
    top = palette.stone(rng) if chance(rng, 0.12) else wood
    thick = between(rng, 0.02, 0.05)
    kind = choose(rng, ("square", "tapered", "splayed", "turned", "sled"))
    under = style.metal if kind == "sled" or chance(rng, 0.15) else wood
    parts = [
        block(top, (width, depth, thick), (0, 0, height - thick), 0.005),
        legs(kind, width - 0.08, depth - 0.08, height - thick, under, between(rng, 0.04, 0.07)).moved(
            0, 0.04, 0
        ),
    ]
    if chance(rng, 0.5):
        parts.append(block(wood, (width - 0.14, depth - 0.14, 0.018), (0, 0.07, height * 0.35)))
        for x in (-0.25, 0.22):
            if chance(rng, 0.7):
                lying = (
                    books.stack(rng, 3)
                    if chance(rng, 0.6)
                    else storage_box(rng, style, 0.28, 0.22, height * 0.4)
                )
                parts.append(lying.moved(x * width, depth / 2 - 0.11, height * 0.35 + 0.018))
    elif kind in ("square", "turned"):
        parts.append(block(wood, (width - 0.12, depth - 0.12, 0.07), (0, 0.06, height - thick - 0.07)))
    parts.append(_things(rng, style, width, depth).moved(0, depth / 2, height))
    return join(parts)


def _round(rng: np.random.Generator, style: Style, width: float) -> Mesh:
    radius, height = min(width, 1.0) / 2, between(rng, 0.38, 0.5)
    wood = palette.stone(rng) if chance(rng, 0.2) else style.any_wood(rng)
    thick = between(rng, 0.018, 0.04)
    parts = [cylinder(radius, thick, 32).moved(0, 0, height - thick).of(wood)]
    if chance(rng, 0.35):
        parts.append(cylinder(radius * between(rng, 0.5, 0.9), height - thick, 28).of(style.any_wood(rng)))
    else:
        skin = style.metal if chance(rng, 0.4) else style.any_wood(rng)
        for k in range(int(rng.integers(3, 5))):
            a = 0.5 + k * 2 * math.pi / 3
            x, y = radius * math.cos(a), radius * math.sin(a)
            parts.append(
                tube([(x * 0.85, y * 0.85, 0), (x * 0.6, y * 0.6, height - thick)], 0.016, 8).of(skin)
            )
    parts.append(_things(rng, style, radius * 1.4, radius * 1.4).moved(0, 0, height))
    return join(parts)


def _glass(rng: np.random.Generator, style: Style, width: float) -> Mesh:
    depth, height = width * between(rng, 0.55, 0.7), between(rng, 0.38, 0.45)
    frame = style.metal if chance(rng, 0.7) else style.any_wood(rng)
    bar = between(rng, 0.02, 0.035)
    parts = [block(palette.GLASS, (width, depth, 0.012), (0, 0, height - 0.012), 0.002)]
    for side in (-1, 1):
        x = side * (width / 2 - 0.05)
        for y in (0.05, depth - 0.05 - bar):
            parts.append(block(frame, (bar, bar, height - 0.012), (x, y, 0)))
        parts.append(block(frame, (bar, depth - 0.1, bar), (x, 0.05, height - 0.012 - bar)))
    for y in (0.05, depth - 0.05 - bar):
        parts.append(block(frame, (width - 0.1, bar, bar), (0, y, height - 0.012 - bar)))
    if chance(rng, 0.7):
        shelf = palette.GLASS if chance(rng, 0.4) else style.any_wood(rng)
        parts.append(block(shelf, (width - 0.1, depth - 0.1, 0.014), (0, 0.05, 0.13)))
        parts.append(books.stack(rng, 4).moved(between(rng, -0.2, 0.2) * width, depth / 2 - 0.1, 0.144))
    parts.append(_things(rng, style, width, depth).moved(0, depth / 2, height))
    return join(parts)


def _chest(rng: np.random.Generator, style: Style, width: float) -> Mesh:
    width = min(width, 1.0)
    depth, height = width * 0.58, between(rng, 0.38, 0.46)
    wood = style.any_wood(rng)
    parts = [
        box(width, depth, height * 0.76, 0.006).of(wood),
        box(width + 0.02, depth + 0.02, height * 0.22, 0.01).moved(0, -0.01, height * 0.78).of(wood),
    ]
    for x in (-0.35, 0.35):
        parts.append(block(style.metal, (0.04, depth + 0.03, height + 0.004), (x * width, -0.015, 0)))
    parts.append(block(style.metal, (0.07, 0.01, 0.09), (0, depth + 0.01, height * 0.68)))
    parts.append(_things(rng, style, width * 0.6, depth).moved(0, depth / 2, height + 0.004))
    return join(parts)


def _nest(rng: np.random.Generator, style: Style, width: float) -> Mesh:
    wood = style.any_wood(rng)
    under = style.metal if chance(rng, 0.5) else wood
    parts = []
    for k, (radius, height) in enumerate(((0.34, 0.46), (0.26, 0.36))):
        outline = [
            (radius * (1.25 if k == 0 else 1) * math.cos(a), radius * math.sin(a))
            for a in np.linspace(0, 2 * math.pi, 25)[:-1]
        ]
        top = extrude(outline, 0.022, smooth=False).moved(0, 0, height - 0.022).of(wood)
        feet = legs("splayed", radius * 1.6, radius * 1.4, height - 0.022, under, 0.034).moved(
            0, -radius * 0.7, 0
        )
        table = join(top, feet, _things(rng, style, radius * 1.2, radius * 1.2).moved(0, 0, height))
        parts.append(table.moved(*((0, 0, 0) if k == 0 else (0.42, 0.16, 0))))
    return join(parts)
