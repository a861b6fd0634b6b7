"""Curtains, net curtains and blinds."""

import math

import numpy as np

from placecat_homes import palette
from placecat_homes.furniture.blocks import between, block, chance, choose
from placecat_homes.materials import Material
from placecat_homes.mesh import Mesh, join
from placecat_homes.parts.hanging import curtain
from placecat_homes.shapes import quad, sheet, superellipsoid, tube
from placecat_homes.style import Style

NET = Material((0.95, 0.95, 0.93), opacity=0.5)
"""Thin white fabric that lets light through."""


def curtains(rng: np.random.Generator, style: Style, width: float = 1.3, height: float = 1.6) -> Mesh:
    """Draw a pair of open curtains on a rod.

    Parameters
    ----------
    rng
        Random number generator.
    style
        Style of the home.
    width
        Width of the window in metres; the rod extends beyond it.
    height
        Height of the rod above the hem in metres.

    Returns
    -------
    Mesh
        A mesh whose lowest point is at z = 0.
    """
    overhang = between(rng, 0.12, 0.28)
    cloth = palette.fabric(rng) if chance(rng, 0.5) else palette.plain_fabric(rng)
    rail = choose(rng, (style.metal, style.wood, palette.WHITE))
    share = between(rng, 0.14, 0.26)
    away = 0.05
    parts: list[Mesh] = []
    full = width + 2 * overhang
    tied = height > 1.4 and style.modern < 0.5 and chance(rng, 0.5)
    for side in (-1, 1):
        wide = full * share * between(rng, 0.9, 1.1)
        folds = max(3, round(wide / 0.085))
        at = side * (full - wide) / 2
        hanging = (
            curtain(wide, height, folds, between(rng, 0.05, 0.08))
            if not tied
            else _tied(wide, height, folds, side)
        )
        parts.append(hanging.moved(at, away, 0).of(cloth))
    if chance(rng, 0.35):
        net = curtain(full * 0.94, height * 0.97, max(6, round(full / 0.09)), 0.03, 0.002)
        parts.append(net.moved(0, 0.012, 0.02).of(NET))
    parts.append(_rod(rng, full, rail).moved(0, away + 0.035, height + 0.01))
    return join(parts)


def _rod(rng: np.random.Generator, width: float, material: Material) -> Mesh:
    if chance(rng, 0.3):
        return block(material, (width, 0.05, 0.04), (0, -0.025, -0.02), 0.003)
    parts = [tube([(-width / 2 - 0.04, 0, 0), (width / 2 + 0.04, 0, 0)], 0.012, 8)]
    for side in (-1, 1):
        ball = superellipsoid(0.045, 0.045, 0.045, 1, 1, 10)
        parts.append(ball.moved(side * (width / 2 + 0.05), 0, -0.0225))
        parts.append(tube([(side * width * 0.46, -0.085, 0), (side * width * 0.46, 0, 0)], 0.007, 6))
    return join(parts).of(material)


def _tied(width: float, height: float, folds: int, side: int) -> Mesh:
    """Draw a curtain tied back towards its outer side."""
    middle = 0.42

    def surface(s: np.ndarray, t: np.ndarray) -> tuple[np.ndarray, ...]:
        waist = np.exp(-(((t - middle) / 0.16) ** 2))
        wide = width * (1.25 - 0.85 * waist - 0.35 * np.clip(middle - t, 0, 1))
        outer = side * width / 2
        x = outer - side * wide * (s if side > 0 else 1 - s)
        y = 0.03 + 0.03 * np.sin(s * folds * 2 * math.pi) * (1 - 0.5 * waist)
        return x, y, t * height

    # s runs towards -x and t runs upwards, so the surface faces +y, into the room.
    return sheet(surface, folds * 6, 12, (width, height))


def blind(rng: np.random.Generator, style: Style, width: float = 1.2, height: float = 1.4) -> Mesh:
    """Draw a roller, Venetian or Roman blind, partly lowered.

    Parameters
    ----------
    rng
        Random number generator.
    style
        Style of the home.
    width, height
        Width and height of the window in metres.

    Returns
    -------
    Mesh
        A blind for a window whose bottom edge is at z = 0.
    """
    drop = height * (between(rng, 0.12, 0.55) if chance(rng, 0.75) else between(rng, 0.55, 0.95))
    kind = choose(rng, ("roller", "venetian", "roman"))
    skin = choose(rng, (palette.WHITE, palette.paint(rng), palette.plastic(rng)))
    parts = [block(skin, (width, 0.06, 0.06), (0, 0, height - 0.06), 0.005)]
    if kind == "venetian":
        drop = height * between(rng, 0.5, 1.0)
        count = max(int(drop / 0.045), 3)
        tilt = math.radians(between(rng, 10, 55))
        for k in range(count):
            z = height - 0.07 - k * 0.045
            if z < 0.02:
                break
            slat = block(skin, (width - 0.02, 0.046, 0.002), (0, -0.023, 0)).turned(math.degrees(tilt), "x")
            parts.append(slat.moved(0, 0.032, z))
        for x in (-0.35, 0.35):
            parts.append(block(skin, (0.004, 0.002, drop - 0.06), (x * width, 0.055, height - drop)))
        return join(parts)
    cloth = palette.fabric(rng) if chance(rng, 0.5) else palette.plain_fabric(rng)
    if kind == "roman":
        folds = max(int(drop / 0.18), 2)
        for k in range(folds):
            z = height - 0.05 - (k + 1) * drop / folds
            parts.append(
                block(
                    cloth, (width - 0.01, 0.012 + 0.012 * (k + 1) / folds, drop / folds), (0, 0.018, z), 0.006
                )
            )
        return join(parts)
    lower = height - drop
    parts.append(quad(width - 0.04, drop - 0.05).moved(0, 0.03, lower).of(cloth))
    parts.append(block(skin, (width - 0.04, 0.014, 0.025), (0, 0.023, lower - 0.01)))
    parts.append(
        tube(
            [(width / 2 - 0.03, 0.045, height - 0.05), (width / 2 - 0.03, 0.045, max(lower - 0.2, 0.02))],
            0.002,
            4,
        ).of(skin)
    )
    return join(parts)


def net(rng: np.random.Generator, style: Style, width: float = 1.2, height: float = 1.4) -> Mesh:
    """Draw a net curtain that covers a window.

    Parameters
    ----------
    rng
        Random number generator.
    style
        Style of the home.
    width, height
        Width and height of the window in metres.

    Returns
    -------
    Mesh
        A mesh whose lowest point is at z = 0.
    """
    drop = height if chance(rng, 0.6) else height * between(rng, 0.35, 0.6)
    low = 0.0 if drop < height else 0.02
    cloth = curtain(width * 1.04, drop - low, max(6, round(width / 0.08)), 0.035, 0.002)
    rod = tube([(-width * 0.54, 0.03, drop), (width * 0.54, 0.03, drop)], 0.006, 6)
    return join(cloth.moved(0, 0.01, low).of(NET), rod.of(choose(rng, (style.metal, palette.WHITE))))
