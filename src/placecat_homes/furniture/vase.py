"""Vases, candles, bowls and other ornaments."""

import math

import numpy as np

from placecat_homes import palette
from placecat_homes.furniture.blocks import backed, between, chance, choose
from placecat_homes.furniture.picture import picture
from placecat_homes.furniture.plant import blossom, leaves
from placecat_homes.materials import Material
from placecat_homes.mesh import Mesh, join
from placecat_homes.shapes import cylinder, lathe, superellipsoid, tube
from placecat_homes.style import Style

FRUIT = ((0.8, 0.15, 0.1), (0.9, 0.55, 0.1), (0.85, 0.75, 0.15), (0.45, 0.6, 0.15))


def vase(rng: np.random.Generator, style: Style, flowers: bool | None = None) -> Mesh:
    """Draw a vase, either empty or with flowers.

    Parameters
    ----------
    rng
        Random number generator.
    style
        Style of the home.
    flowers
        Whether there are flowers in the vase; chosen at random if None.

    Returns
    -------
    Mesh
        A mesh with its base at z = 0.
    """
    h, r = between(rng, 0.14, 0.3), between(rng, 0.04, 0.08)
    profile = choose(
        rng,
        (
            [
                (0, 0),
                (r * 0.6, 0),
                (r, h * 0.35),
                (r * 0.8, h * 0.65),
                (r * 0.4, h * 0.85),
                (r * 0.55, h),
                (r * 0.45, h),
                (r * 0.3, h * 0.85),
            ],
            [(0, 0), (r * 0.8, 0), (r * 0.9, h), (r * 0.82, h), (r * 0.7, 0.02)],
            [(0, 0), (r * 0.5, 0), (r * 0.55, h * 0.1), (r * 0.9, h), (r * 0.82, h), (r * 0.4, h * 0.1)],
            [
                (0, 0),
                (r * 0.5, 0),
                (r * 1.1, h * 0.4),
                (r * 0.9, h * 0.7),
                (r * 0.6, h * 0.8),
                (r * 0.6, h),
                (r * 0.5, h),
            ],
        ),
    )
    skin = (
        palette.GLASS
        if chance(rng, 0.2)
        else choose(rng, (palette.ceramic(rng), palette.paint(rng), style.metal))
    )
    parts = [lathe(profile, 16).of(skin)]
    if chance(rng, 0.65) if flowers is None else flowers:
        parts.append(bouquet(rng, h * between(rng, 0.7, 1.3), r * 0.4).moved(0, 0, h * 0.9))
    return backed(join(parts))


def bouquet(rng: np.random.Generator, height: float, radius: float) -> Mesh:
    """Draw cut flowers.

    Parameters
    ----------
    rng
        Random number generator.
    height, radius
        Height above the rim and radius at the rim, in metres.

    Returns
    -------
    Mesh
        Flowers around the z axis, extending upwards from z = 0.
    """
    count = int(rng.integers(5, 12))
    green = palette.foliage(rng)
    petals = [Material(palette.colour(rng, 0.95, 0.6, 1.0)) for _ in range(int(rng.integers(1, 4)))]
    parts: list[Mesh] = []
    feet, ways = [], []
    for k in range(count):
        turn, spread = k * 2.4, 0.6 * math.sqrt((k + 0.3) / count)
        way = np.array([math.cos(turn) * spread, math.sin(turn) * spread, 1.0])
        tip = way * height * between(rng, 0.75, 1.0)
        parts.append(tube([(0, 0, -height * 0.2), tuple(tip.tolist())], 0.0025, 4).of(green))
        size = max(height * 0.28, 0.045) * between(rng, 0.8, 1.2)
        flower = blossom(rng, size, choose(rng, petals)).turned(40 * spread, "y").turned(math.degrees(turn))
        parts.append(flower.moved(*tip.tolist()))
        for _ in range(2):
            feet.append(tip * between(rng, 0.2, 0.7))
            ways.append(way + rng.normal(0, 0.8, 3))
    n = len(feet)
    length = height * rng.uniform(0.25, 0.45, n)
    parts.append(leaves(np.array(feet), np.array(ways), length, length * 0.35, np.full(n, 0.6)).of(green))
    return join(parts)


def candle(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw one to three candles on a holder or plate.

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
    wax = Material(palette.colour(rng, 0.5, 0.7, 0.97))
    parts = []
    for k in range(int(rng.integers(1, 4))):
        x, height = k * 0.075, between(rng, 0.07, 0.2)
        if chance(rng, 0.5):
            parts.append(cylinder(0.03, height, 14).moved(x).of(wax))
        else:
            stick = lathe(
                [(0, 0), (0.035, 0), (0.03, 0.01), (0.01, 0.02), (0.008, height), (0.016, height)], 12
            )
            parts.append(stick.moved(x).of(style.metal))
            parts.append(cylinder(0.011, 0.16, 8, 0).moved(x, 0, height).of(wax))
    return backed(join(parts))


def bowl(rng: np.random.Generator, style: Style, fruit: bool | None = None) -> Mesh:
    """Draw a bowl, often with fruit.

    Parameters
    ----------
    rng
        Random number generator.
    style
        Style of the home.
    fruit
        Whether there is fruit in the bowl; chosen at random if None.

    Returns
    -------
    Mesh
        A mesh with its base at z = 0.
    """
    r, h = between(rng, 0.1, 0.17), between(rng, 0.06, 0.1)
    skin = choose(rng, (palette.ceramic(rng), palette.wood(rng), palette.paint(rng), style.metal))
    profile = [
        (0, 0),
        (r * 0.45, 0),
        (r * 0.8, h * 0.5),
        (r, h),
        (r * 0.95, h),
        (r * 0.7, h * 0.4),
        (0, h * 0.15),
    ]
    parts = [lathe(profile, 18).of(skin)]
    if chance(rng, 0.6) if fruit is None else fruit:
        kinds = [Material(FRUIT[int(rng.integers(4))], gloss=0.03) for _ in range(2)]
        for k in range(int(rng.integers(4, 8))):
            a = k * 1.3
            out = r * (0.45 if k < 5 else 0.1)
            ball = superellipsoid(0.075, 0.075, 0.07, 1, 1, 10)
            z = h * 0.35 if k < 5 else h * 0.35 + 0.05
            parts.append(ball.moved(out * math.cos(a), out * math.sin(a), z).of(choose(rng, kinds)))
    return backed(join(parts))


def figure(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw an ornament: a framed photograph, a globe, a turned figure or a stone.

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
    kind = choose(rng, ("photo", "photo", "globe", "turned", "stone"))
    if kind == "photo":
        width = between(rng, 0.1, 0.2)
        photo = picture(rng, style, width, width * choose(rng, (0.75, 1.35)))
        return backed(photo.turned(10, "x"))
    skin = choose(rng, (palette.ceramic(rng), palette.wood(rng), style.metal, palette.stone(rng)))
    r = between(rng, 0.05, 0.1)
    if kind == "globe":
        ball = superellipsoid(2 * r, 2 * r, 2 * r, 1, 1, 14).moved(0, 0, 0.05).of(palette.paint(rng))
        foot = lathe([(0, 0), (r * 0.7, 0), (r * 0.6, 0.015), (0.008, 0.02), (0.008, 0.06)], 12)
        return backed(join(ball, foot.of(skin)))
    if kind == "stone":
        return backed(superellipsoid(2.4 * r, 1.4 * r, 1.6 * r, 0.8, 0.9, 12).of(skin))
    h = between(rng, 0.12, 0.28)
    profile = [
        (0, 0),
        (r * 0.8, 0),
        (r * 0.3, h * 0.15),
        (r * 0.7, h * 0.4),
        (r * 0.25, h * 0.6),
        (r * 0.4, h * 0.85),
        (0, h),
    ]
    return backed(lathe(profile, 12).of(skin))
