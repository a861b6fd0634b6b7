"""Refrigerators."""

from itertools import pairwise

import numpy as np

from placecat_homes import palette
from placecat_homes.furniture.blocks import between, block, chance, choose
from placecat_homes.materials import Material
from placecat_homes.mesh import Mesh, join
from placecat_homes.parts.kitchens.design import BLACK, SHADOW, STEEL, WHITE
from placecat_homes.parts.outlines import frontal, rectangle
from placecat_homes.shapes import box, cylinder, quad, superellipsoid, tube
from placecat_homes.style import Style


def fridge(
    rng: np.random.Generator, style: Style, *, design: str | None = None, width: float | None = None
) -> Mesh:
    """Draw a refrigerator, often with magnets and notes on its door.

    Parameters
    ----------
    rng
        Random number generator.
    style
        Style of the home.
    design
        "single", "two" (freezer above or below), "double" (side by side) or "retro"; random if None.
    width
        Width in metres; chosen at random if None.

    Returns
    -------
    Mesh
        A refrigerator 1.4 to 2 m high.
    """
    weights = (0.2, 0.5, 0.12, 0.18) if width is None or width < 0.8 else (0, 0.1, 0.9, 0)
    kind = design or choose(rng, ("single", "two", "double", "retro"), weights)
    shell = choose(rng, (STEEL, WHITE, BLACK), (0.4, 0.45, 0.15))
    w = width or (between(rng, 0.85, 0.95) if kind == "double" else between(rng, 0.56, 0.7))
    if kind == "retro":
        shell = Material(palette.colour(rng, 0.8, 0.45, 0.95), gloss=0.06, roughness=0.08)
        return _retro(rng, shell, w)
    height = between(rng, 1.45, 1.75) if kind == "single" else between(rng, 1.7, 1.95)
    depth, skin = between(rng, 0.6, 0.66), 0.055
    parts = [
        box(w, depth - skin - 0.01, height - 0.03, 0.006).moved(z=0.03).of(shell),
        block(SHADOW, (w - 0.03, depth - skin, height - 0.08), (0, 0, 0.05)),
        block(SHADOW, (w - 0.06, depth - 0.1, 0.04)),
    ]
    back = depth - skin
    bottom = 0.045
    full = height - bottom - 0.002
    if kind == "double":
        for side in (-1, 1):
            leaf = box(w / 2 - 0.004, skin, full, 0.01).of(shell).moved(side * w / 4, back, bottom)
            grip = _bar(0.55 * full).moved(side * 0.04, depth, bottom + 0.25 * full)
            parts += [leaf, grip]
        if chance(rng, 0.7):
            parts.append(block(BLACK, (0.2, 0.004, 0.32), (w / 4, depth, 1.0)))
            parts.append(block(SHADOW, (0.15, 0.003, 0.18), (w / 4, depth + 0.002, 1.02)))
            parts.append(
                block(
                    Material((0.3, 0.7, 0.9), emission=0.6), (0.08, 0.002, 0.03), (w / 4, depth + 0.003, 1.25)
                )
            )
        parts.append(_notes(rng, -w / 2 + 0.04, -0.09, 0.9, height - 0.15, depth))
        return join(parts)
    hinge = choose(rng, (-1, 1))
    between_doors = [] if kind == "single" else [choose(rng, (0.38, 0.72)) * height]
    splits = [bottom, *between_doors, height]
    for k, (low, high) in enumerate(pairwise(splits)):
        leaf = box(w, skin, high - low - 0.008, 0.012).of(shell).moved(0, back, low)
        length = min(0.45, 0.55 * (high - low))
        z = low + 0.08 if k == 1 or (len(splits) == 2 and chance(rng, 0.3)) else high - length - 0.08
        parts += [leaf, _bar(length).moved(-hinge * (w / 2 - 0.05), depth, z)]
    parts.append(
        block(STEEL if shell != STEEL else BLACK, (0.09, 0.003, 0.016), (hinge * 0.1, depth, height - 0.09))
    )
    large = (splits[-2], splits[-1]) if splits[-1] - splits[-2] > 0.6 else (splits[0], splits[1])
    parts.append(_notes(rng, -w / 2 + 0.1, w / 2 - 0.1, max(large[0] + 0.1, 0.75), large[1] - 0.14, depth))
    if chance(rng, 0.35):
        parts.append(_on_top(rng, style, w).moved(0, 0.12, height))
    return join(parts)


def _bar(length: float) -> Mesh:
    feet = [tube([(0, 0, z), (0, 0.045, z)], 0.007, 6) for z in (0.05, length - 0.05)]
    return join(tube([(0, 0.045, 0), (0, 0.045, length)], 0.009, 8), feet).of(STEEL)


def _retro(rng: np.random.Generator, shell: Material, w: float) -> Mesh:
    height, depth, radius = between(rng, 1.35, 1.6), 0.62, 0.09
    outline = [(x, z + height / 2 + 0.03) for x, z in rectangle(w, height - 0.03, radius, 5)]
    body = frontal(outline, depth - 0.1).of(shell)
    split = height * between(rng, 0.66, 0.72)
    parts = [body, block(SHADOW, (w - 0.08, depth - 0.1, 0.05))]
    lower = superellipsoid(w, 0.3, split - 0.06, 0.16, 0.22, 28).of(shell)
    upper = superellipsoid(w, 0.3, height - split - 0.01, 0.22, 0.22, 28).of(shell)
    parts.append(lower.moved(0, depth - 0.16, 0.055))
    parts.append(upper.moved(0, depth - 0.16, split + 0.005))
    for z in (split - 0.28, split + 0.1):
        grip = tube(
            [
                (w / 2 - 0.09, depth - 0.02, z),
                (w / 2 - 0.09, depth + 0.04, z + 0.03),
                (w / 2 - 0.09, depth + 0.04, z + 0.12),
                (w / 2 - 0.09, depth - 0.02, z + 0.15),
            ],
            0.012,
            8,
        )
        parts.append(grip.of(STEEL))
    parts.append(block(STEEL, (0.22, 0.006, 0.03), (-0.06, depth - 0.013, height - 0.2)))
    parts.append(_notes(rng, -w / 2 + 0.12, w / 2 - 0.14, 0.7, split - 0.35, depth - 0.01))
    return join(parts)


def _notes(rng: np.random.Generator, left: float, right: float, low: float, high: float, y: float) -> Mesh:
    parts: list[Mesh] = []
    taken: list[tuple[float, float, float]] = []
    for _ in range(int(rng.integers(0, 9))):
        paper = chance(rng, 0.55)
        width = between(rng, 0.07, 0.16) if paper else between(rng, 0.025, 0.05)
        height = width * between(rng, 0.8, 1.4)
        if right - left <= width or high - low <= height:
            continue
        x, z = between(rng, left + width / 2, right - width / 2), between(rng, low, high - height)
        reach = max(width, height) / 2
        if any(abs(x - a) < reach + c and abs(z + height / 2 - b) < reach + c for a, b, c in taken):
            continue
        taken.append((x, z + height / 2, reach))
        colour = Material(palette.colour(rng, 0.95, 0.5, 1.0), gloss=0.02)
        if paper:
            sheet = quad(width, height).of(
                palette.art(rng, width, height) if chance(rng, 0.5) else palette.poster(rng, width, height)
            )
            note = sheet.turned(between(rng, -6, 6), "y").moved(x, y + 0.003, z)
            magnet = cylinder(0.012, 0.008, 8, 0.002).turned(-90, "x").moved(x, y + 0.003, z + height - 0.012)
            parts += [note, magnet.of(colour)]
        elif chance(rng, 0.5):
            parts.append(cylinder(width / 2, 0.01, 10, 0.003).turned(-90, "x").moved(x, y, z).of(colour))
        else:
            parts.append(box(width, 0.008, height, 0.002).moved(x, y, z).of(colour))
    return join(parts)


def _on_top(rng: np.random.Generator, style: Style, w: float) -> Mesh:
    parts = []
    x = -w / 2 + 0.16
    while x < w / 2 - 0.1:
        size, height = between(rng, 0.14, 0.24), between(rng, 0.1, 0.26)
        if chance(rng, 0.5):
            body = box(size, 0.26, height, 0.006).of(palette.paint(rng))
        else:
            body = cylinder(size / 2, height, 14).moved(y=0.14).of(palette.plastic(rng))
        parts.append(body.moved(x))
        x += size + between(rng, 0.05, 0.2)
    return join(parts)
