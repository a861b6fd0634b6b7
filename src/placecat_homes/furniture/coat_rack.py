"""Coat racks and hall units."""

import numpy as np

from placecat_homes import palette
from placecat_homes.furniture.blocks import between, block, chance, choose
from placecat_homes.furniture.coat_stand import bag, coat, hat
from placecat_homes.materials import Material
from placecat_homes.mesh import Mesh, join
from placecat_homes.shapes import box, superellipsoid, tube
from placecat_homes.style import Style


def coat_rack(rng: np.random.Generator, style: Style, width: float | None = None) -> Mesh:
    """Draw a wall-mounted board with coats and bags on its hooks. Its lowest point is at z = 0.

    Parameters
    ----------
    rng, style
        Random number generator and style of the home.
    width
        Width in metres; 0.6 to 1.3 if None.
    """
    width = width or between(rng, 0.6, 1.3)
    wood = choose(rng, (style.wood, style.any_wood(rng), palette.paint(rng)))
    tall = between(rng, 0.09, 0.16)
    parts = [box(width, 0.02, tall, 0.004).of(wood)]
    shelf = chance(rng, 0.5)
    if shelf:
        if chance(rng, 0.5):
            parts.append(block(wood, (width, 0.26, 0.022), (0, 0, tall + 0.06), 0.004))
        else:
            for k in range(5):
                y = 0.03 + 0.055 * k
                line = [(-width / 2 + 0.02, y, tall + 0.07), (width / 2 - 0.02, y, tall + 0.07)]
                parts.append(tube(line, 0.008, 6).of(style.metal))
        for side in (-1, 1):
            x = side * (width / 2 - 0.06)
            line = [(x, 0.012, tall * 0.3), (x, 0.24, tall + 0.06)]
            parts.append(tube(line, 0.009, 6).of(style.metal if chance(rng, 0.5) else wood))
            parts.append(block(wood, (0.02, 0.02, 0.1), (x, 0, tall - 0.02)))
        parts.append(_on_shelf(rng, style, width - 0.1).moved(0, 0.0, tall + 0.082))
    count = max(3, round(width / 0.19))
    for k in range(count):
        x = (k + 0.5) * width / count - width / 2
        z = tall * 0.5
        hook = [(x, 0.018, z + 0.02), (x, 0.06, z + 0.01), (x, 0.075, z + 0.035)]
        parts.append(tube(hook, 0.006, 6).of(style.metal))
        if chance(rng, 0.62):
            thing = coat(rng, style) if chance(rng, 0.75) else bag(rng, style)
            parts.append(thing.moved(x, 0.03, z))
    whole = join(parts)
    return whole.moved(0, -float(whole.low[1]), -float(whole.low[2]))


def hall_wardrobe(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a hall unit with coats on a hook panel, a shoe bench and a hat shelf."""
    width, high = between(rng, 0.8, 1.3), between(rng, 1.85, 2.05)
    wood = choose(rng, (style.wood, style.any_wood(rng)))
    deep = between(rng, 0.34, 0.4)
    seat = between(rng, 0.42, 0.48)
    parts: list[Mesh] = []
    slats = chance(rng, 0.5)
    if slats:
        count = max(4, round(width / 0.13))
        for k in range(count):
            x = (k + 0.5) * width / count - width / 2
            parts.append(block(wood, (width / count * 0.7, 0.02, high - seat), (x, 0, seat)))
    else:
        parts.append(block(wood, (width, 0.02, high - seat), (0, 0, seat)))
    parts.append(block(wood, (width, 0.28, 0.025), (0, 0, high - 0.025), 0.004))
    for z in (0.04, seat * 0.5, seat - 0.03):
        parts.append(block(wood, (width, deep, 0.025), (0, 0, z), 0.003))
    for side in (-1, 1):
        parts.append(block(wood, (0.025, deep, seat), (side * (width / 2 - 0.0125), 0, 0), 0.003))
    if chance(rng, 0.6):
        cover = style.any_fabric(rng)
        parts.append(
            superellipsoid(width - 0.02, deep, 0.06, 0.3, 0.2, 16).moved(0, deep / 2, seat).of(cover)
        )
    for z in (0.065, seat * 0.5 + 0.025):
        x = -width / 2 + 0.16
        while x < width / 2 - 0.12:
            if chance(rng, 0.75):
                parts.append(shoes(rng, style).moved(x, 0.04, z))
            x += 0.25
    count = max(3, round(width / 0.2))
    for k in range(count):
        x = (k + 0.5) * width / count - width / 2
        z = high - 0.32
        hook = [(x, 0.018, z + 0.02), (x, 0.06, z + 0.01), (x, 0.075, z + 0.035)]
        parts.append(tube(hook, 0.006, 6).of(style.metal))
        if chance(rng, 0.6):
            thing = coat(rng, style, between(rng, 0.6, 0.95)) if chance(rng, 0.7) else bag(rng, style)
            parts.append(thing.moved(x, 0.03, z))
    parts.append(_on_shelf(rng, style, width - 0.1).moved(0, 0, high))
    whole = join(parts)
    return whole.moved(0, -float(whole.low[1]))


def shoes(rng: np.random.Generator, style: Style, *, boots: bool | None = None) -> Mesh:
    """Draw a pair of shoes or boots with their toes pointing towards +y."""
    skin = choose(rng, (palette.leather(rng), palette.plastic(rng), palette.plain_fabric(rng)))
    sole = choose(
        rng, (Material((0.9, 0.9, 0.88)), Material((0.06, 0.06, 0.06)), Material((0.55, 0.4, 0.25)))
    )
    boots = chance(rng, 0.2) if boots is None else boots
    length = between(rng, 0.23, 0.29)
    one = [
        superellipsoid(0.09, length, 0.03, 0.3, 0.7, 8).moved(0, length / 2).of(sole),
        superellipsoid(0.085, length * 0.75, 0.075, 0.9, 0.7, 10).moved(0, length * 0.6, 0.015).of(skin),
        superellipsoid(0.075, length * 0.42, 0.3 if boots else 0.11, 0.5, 0.8, 8)
        .moved(0, length * 0.24, 0.015)
        .of(skin),
    ]
    foot = join(one)
    return join(
        foot.turned(between(rng, -6, 6)).moved(-0.055),
        foot.turned(between(rng, -6, 6)).moved(0.055, between(rng, -0.02, 0.02)),
    ).moved(0, 0.03)


def _on_shelf(rng: np.random.Generator, style: Style, width: float) -> Mesh:
    parts: list[Mesh] = []
    x = -width / 2 + 0.12
    while x < width / 2 - 0.1:
        kind = rng.random()
        if kind < 0.35:
            parts.append(hat(rng, style).scaled(0.8).moved(x, 0.13))
        elif kind < 0.6:
            skin = palette.plain_fabric(rng) if chance(rng, 0.5) else style.any_wood(rng)
            parts.append(block(skin, (0.24, 0.22, between(rng, 0.1, 0.2)), (x, 0.02, 0), 0.01))
        x += 0.3
    return join(parts)
