"""Fireplaces and wood stoves."""

import numpy as np

from placecat_homes import palette
from placecat_homes.furniture.blocks import between, block, chance, choose, legs
from placecat_homes.furniture.clutter import small_thing
from placecat_homes.materials import Material
from placecat_homes.mesh import Lamp, Mesh, join
from placecat_homes.parts.arrange import grounded
from placecat_homes.shapes import cylinder, lathe, tube
from placecat_homes.style import Style

SOOT = Material((0.03, 0.03, 0.03))
IRON = Material((0.05, 0.05, 0.055), gloss=0.03, roughness=0.5)
BARK = Material((0.3, 0.22, 0.15))
FLAME = Material((1.0, 0.5, 0.12), emission=2.5)


def _fire(rng: np.random.Generator, width: float, lit: bool) -> Mesh:
    """Draw logs around the origin, sometimes burning."""
    parts = []
    for k in range(4):
        log = tube([(-width / 2, 0, 0), (width / 2, 0, 0)], 0.04, 8).turned(rng.normal(0, 12))
        parts.append(log.moved(0, (k % 3 - 1) * 0.08, 0.04 + 0.07 * (k // 3)).of(BARK))
    if lit:
        for k in range(5):
            height = between(rng, 0.12, 0.3)
            x = (k - 2) * width * 0.18
            profile = [(0, 0), (0.035, height * 0.2), (0.028, height * 0.5), (0, height)]
            flame = lathe(profile, 8).turned(rng.normal(0, 8), "y")
            parts.append(flame.moved(x, between(rng, -0.04, 0.08), 0.06).of(FLAME))
        mesh = join(parts)
        return mesh.lit(Lamp((0.0, 0.2, 0.25), (1.0, 0.55, 0.2), 0.25, 0.1))
    return join(parts)


def fireplace(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a fireplace with objects on its mantelpiece, or an iron stove.

    Parameters
    ----------
    rng
        Random number generator.
    style
        Style of the home.

    Returns
    -------
    Mesh
        A mesh with its base at z = 0.
    """
    return grounded(stove(rng, style) if chance(rng, 0.3) else mantel(rng, style))


def mantel(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a fireplace with a mantelpiece."""
    width, height, depth = between(rng, 1.2, 1.6), between(rng, 1.05, 1.25), between(rng, 0.3, 0.4)
    hole, tall = width * between(rng, 0.48, 0.58), height * between(rng, 0.55, 0.66)
    stone = choose(rng, (palette.stone(rng), palette.paint(rng), palette.tiles(rng), style.trim))
    frame = choose(rng, (stone, style.any_wood(rng), palette.WHITE))
    side = (width - hole) / 2
    parts = [block(palette.stone(rng), (width + 0.1, depth + 0.3, 0.03), (0, 0, 0), 0.004)]
    for s in (-1, 1):
        x = s * (hole + side) / 2
        parts.append(block(stone, (side, depth, height - 0.06), (x, 0, 0)))
        parts.append(block(frame, (side * 0.6, 0.04, height - 0.1), (x, depth, 0.03), 0.006))
        parts.append(block(frame, (side * 0.75, 0.06, 0.1), (x, depth, 0.03), 0.006))
    parts.append(block(stone, (hole, depth, height - 0.06 - tall), (0, 0, tall)))
    parts.append(block(frame, (width, 0.04, 0.12), (0, depth, height - 0.18), 0.006))
    shelf = depth + 0.12
    parts.append(block(frame, (width + 0.14, shelf, 0.06), (0, 0, height - 0.06), 0.008))
    parts.append(block(SOOT, (hole, 0.03, tall), (0, 0.0, 0.0)))
    for s in (-1, 1):
        parts.append(block(SOOT, (0.012, depth - 0.01, tall), (s * (hole / 2 - 0.006), 0, 0)))
    parts.append(block(SOOT, (hole, depth - 0.02, 0.04), (0, 0, 0)))
    parts.append(block(IRON, (hole * 0.8, 0.015, 0.12), (0, depth - 0.06, 0.04)))
    parts.append(_fire(rng, hole * 0.55, chance(rng, 0.45)).moved(0, depth * 0.5, 0.05))
    count = int(rng.integers(2, 6))
    for k in range(count):
        thing = small_thing(rng, style, 0.4)
        if float(thing.size[1]) < shelf and float(thing.size[0]) < width / count:
            parts.append(thing.moved((k + 0.5 - count / 2) * width / count, 0.03, height))
    return join(parts)


def stove(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw an iron stove with a glass door and a flue pipe."""
    width, depth, height, foot = (
        between(rng, 0.45, 0.6),
        between(rng, 0.38, 0.46),
        between(rng, 0.75, 1.0),
        0.12,
    )
    glow = Material((0.9, 0.4, 0.1), emission=1.2) if chance(rng, 0.5) else palette.BLACK_GLASS
    away = 0.15
    parts = [
        legs("tapered", width - 0.04, depth - 0.04, foot, IRON, 0.05).moved(0, away + 0.02, 0),
        block(IRON, (width, depth, height - foot), (0, away, foot), 0.01),
        block(IRON, (width + 0.05, depth + 0.04, 0.03), (0, away - 0.02, height), 0.006),
        block(
            IRON,
            (width * 0.8, 0.02, (height - foot) * 0.62),
            (0, away + depth, foot + (height - foot) * 0.3),
            0.008,
        ),
        block(
            glow,
            (width * 0.62, 0.006, (height - foot) * 0.46),
            (0, away + depth + 0.018, foot + (height - foot) * 0.38),
        ),
        tube(
            [
                (-width * 0.32, away + depth + 0.03, height * 0.6),
                (-width * 0.32, away + depth + 0.03, height * 0.75),
            ],
            0.01,
            6,
        ).of(style.metal),
        cylinder(0.07, 2.25 - height, 16, 0).moved(0, away + depth * 0.45, height).of(IRON),
        block(palette.stone(rng), (width + 0.4, depth + 0.5, 0.012), (0, 0, 0)),
    ]
    if chance(rng, 0.7):
        for k in range(9):
            x, z = width / 2 + 0.13, 0.05 + 0.085 * (k // 2)
            log = cylinder(0.042, 0.3, 8, 0).turned(-90, "x").of(BARK)
            parts.append(log.moved(x + (k % 2) * 0.086 + (0.03 if k // 2 % 2 else 0), away, z))
    return join(parts)
