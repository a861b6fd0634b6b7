"""Console tables for hallways."""

import math

import numpy as np

from placecat_homes import palette
from placecat_homes.furniture.blocks import between, block, chance, choose, legs
from placecat_homes.furniture.desk_things import book_pile
from placecat_homes.materials import Material
from placecat_homes.mesh import Lamp, Mesh, join
from placecat_homes.parts.drawers import pull
from placecat_homes.parts.prints import leaf
from placecat_homes.shapes import box, cylinder, lathe, sheet, superellipsoid, tube
from placecat_homes.style import Style


def console_table(rng: np.random.Generator, style: Style, width: float | None = None) -> Mesh:
    """Draw a narrow table on legs, with keys, letters, a bowl, a telephone, flowers or a lamp on top.

    Parameters
    ----------
    rng, style
        Random number generator and style of the home.
    width
        Width in metres; 0.7 to 1.2 if None.
    """
    width = width or between(rng, 0.7, 1.2)
    deep, high = between(rng, 0.26, 0.36), between(rng, 0.76, 0.88)
    wood = style.any_wood(rng)
    parts = [block(wood, (width, deep, 0.028), (0, 0, high - 0.028), 0.005)]
    kind = choose(rng, ("drawer", "metal", "shelf"))
    frame = style.metal if kind == "metal" else wood
    shape = "square" if kind == "metal" else choose(rng, ("square", "tapered", "turned", "round"))
    parts.append(legs(shape, width - 0.04, deep - 0.03, high - 0.028, frame, 0.035).moved(0, 0.015))
    if kind == "drawer":
        parts.append(block(wood, (width - 0.1, deep - 0.04, 0.13), (0, 0.015, high - 0.158)))
        count = 2 if width > 0.85 else 1
        for k in range(count):
            x = (k + 0.5) * (width - 0.12) / count - (width - 0.12) / 2
            size = ((width - 0.12) / count - 0.01, 0.015, 0.11)
            parts.append(block(wood, size, (x, deep - 0.026, high - 0.148), 0.003))
            parts.append(pull(style, size[0], kind="knob").moved(x, deep - 0.012, high - 0.09))
    if kind != "drawer" or chance(rng, 0.3):
        parts.append(block(wood, (width - 0.08, deep - 0.04, 0.02), (0, 0.02, 0.16)))
        if chance(rng, 0.5):
            basket = Material(texture=palette.fabric(rng).texture)
            parts.append(
                block(basket, (0.3, deep - 0.08, 0.2), (between(rng, -0.15, 0.15), 0.04, 0.18), 0.02)
            )
    parts.append(_things(rng, style, width, deep).moved(z=high))
    return join(parts)


def hall_lamp(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a small lamp with a shade."""
    cloth = Material((1.0, 0.9, 0.72), emission=0.9)
    foot = choose(rng, (palette.ceramic(rng), style.metal, style.wood))
    high, wide = between(rng, 0.22, 0.3), between(rng, 0.09, 0.13)
    body = lathe([(0, 0), (0.06, 0), (0.07, 0.05), (0.05, 0.12), (0.015, 0.17), (0.012, high), (0, high)], 14)
    shade = lathe([(wide, high - 0.02), (wide * 0.7, high + 0.15)], 18)
    return join(body.of(foot), shade.of(cloth)).lit(Lamp((0, 0, high + 0.22), (1, 0.85, 0.62), 0.3, 0.06))


def _things(rng: np.random.Generator, style: Style, width: float, deep: float) -> Mesh:
    makers = [_bowl, _letters, _flowers, hall_lamp, _telephone, book_pile, _candles]
    order = rng.permutation(len(makers))
    parts = []
    x = -width / 2 + 0.14
    for k in order:
        if x > width / 2 - 0.1:
            break
        thing = makers[k](rng, style)
        size = np.maximum(thing.size, 0.05)
        scale = min(1.0, (deep - 0.04) / float(size[1]))
        thing = thing.scaled(scale)
        parts.append(
            thing.moved(x - float(thing.low[0]) - 0.1, deep / 2 - float(thing.low[1] + thing.high[1]) / 2)
        )
        x += float(thing.size[0]) + between(rng, 0.06, 0.2)
    return join(parts)


def _bowl(rng: np.random.Generator, style: Style) -> Mesh:
    r = between(rng, 0.09, 0.13)
    line = [
        (0, 0),
        (r * 0.5, 0),
        (r * 0.85, 0.03),
        (r, 0.07),
        (r - 0.008, 0.07),
        (r * 0.8, 0.035),
        (0, 0.015),
    ]
    bowl = lathe(line, 18).of(choose(rng, (palette.ceramic(rng), style.wood)))
    ring = [(0.02 * math.cos(a), 0.02 * math.sin(a), 0.03) for a in np.linspace(0, 6.283, 9)]
    keys = [tube(ring, 0.002, 4), box(0.02, 0.06, 0.003, 0).moved(0, 0.01, 0.03)]
    return join(bowl, join(keys).of(Material((0.75, 0.75, 0.72), gloss=0.4)))


def _letters(rng: np.random.Generator, style: Style) -> Mesh:
    parts = []
    for k in range(int(rng.integers(2, 6))):
        envelope = box(0.22, 0.11, 0.004, 0).moved(y=-0.055).turned(between(rng, -20, 20))
        parts.append(envelope.moved(z=0.004 * k).of(leaf(rng)))
    return join(parts)


def _flowers(rng: np.random.Generator, style: Style) -> Mesh:
    line = [
        (0, 0),
        (0.045, 0),
        (0.06, 0.08),
        (0.035, 0.17),
        (0.045, 0.2),
        (0.038, 0.2),
        (0.03, 0.17),
        (0, 0.17),
    ]
    parts = [lathe(line, 16).of(palette.ceramic(rng))]
    petals = Material(palette.colour(rng, 0.9, 0.6, 1.0))
    leaves = palette.foliage(rng)
    for _ in range(int(rng.integers(5, 10))):
        angle, reach, up = between(rng, 0, 6.28), between(rng, 0.02, 0.14), between(rng, 0.28, 0.42)
        tip = (reach * math.cos(angle), reach * math.sin(angle), up)
        parts.append(tube([(0, 0, 0.17), (tip[0] * 0.4, tip[1] * 0.4, up * 0.75), tip], 0.003, 4).of(leaves))
        parts.append(superellipsoid(0.055, 0.055, 0.045, 1, 1, 8).moved(tip[0], tip[1], up - 0.02).of(petals))

        def blade(
            s: np.ndarray, t: np.ndarray, a: float = angle + 1.0, top: float = up
        ) -> tuple[np.ndarray, ...]:
            """Bend a leaf outwards."""
            out, side = 0.16 * t, (s - 0.5) * 0.035 * np.sin(math.pi * np.clip(t, 0.05, 0.95))
            x, y = out * math.cos(a) - side * math.sin(a), out * math.sin(a) + side * math.cos(a)
            return x, y, 0.18 + (top - 0.25) * t - 0.06 * t * t

        parts.append(sheet(blade, 1, 4).of(leaves))
    return join(parts)


def _telephone(rng: np.random.Generator, style: Style) -> Mesh:
    case = palette.plastic(rng)
    base = box(0.1, 0.1, 0.05, 0.015).of(case)
    handset = box(0.05, 0.03, 0.17, 0.01).turned(20, "x").moved(0, 0.06, 0.03).of(case)
    display = box(0.03, 0.002, 0.03, 0).turned(20, "x").moved(0, 0.045, 0.14)
    return join(base, handset, display.of(Material((0.5, 0.8, 0.6), emission=0.3)))


def _candles(rng: np.random.Generator, style: Style) -> Mesh:
    parts = []
    wax = Material(palette.colour(rng, 0.6, 0.5, 0.95))
    for k in range(int(rng.integers(1, 4))):
        parts.append(cylinder(0.032, between(rng, 0.07, 0.2), 12).moved(0.09 * k).of(wax))
    return join(parts)
