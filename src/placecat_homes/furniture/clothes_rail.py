"""Clothes rails and coat hooks."""

import numpy as np

from placecat_homes.furniture.blocks import between, block, chance, choose
from placecat_homes.furniture.box import cardboard
from placecat_homes.furniture.clothes import bag, garment, hanging, hat, shoes
from placecat_homes.mesh import Mesh, join
from placecat_homes.parts.arrange import grounded
from placecat_homes.shapes import cylinder, tube
from placecat_homes.style import Style


def clothes_rail(rng: np.random.Generator, style: Style, width: float | None = None) -> Mesh:
    """Draw a free-standing rail full of clothes, with shoes or boxes below.

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
    width = between(rng, 0.8, 1.4) if width is None else width
    height, depth = between(rng, 1.5, 1.7), 0.48
    skin = style.metal if chance(rng, 0.65) else style.any_wood(rng)
    y = depth / 2
    parts = [tube([(-width / 2 - 0.03, y, height), (width / 2 + 0.03, y, height)], 0.013, 8).of(skin)]
    for side in (-1, 1):
        x = side * width / 2
        parts.append(tube([(x, y, 0.08), (x, y, height)], 0.013, 8).of(skin))
        parts.append(tube([(x, 0.0, 0.06), (x, depth, 0.06)], 0.013, 8).of(skin))
        for end in (0.02, depth - 0.02):
            parts.append(cylinder(0.025, 0.02, 10, 0).turned(90, "y").moved(x - 0.01, end, 0.025))
    for end in (0.1, depth - 0.1):
        parts.append(tube([(-width / 2, end, 0.1), (width / 2, end, 0.1)], 0.009, 6).of(skin))
    parts.append(hanging(rng, style, width - 0.06, height - 0.25).moved(0, y, height))
    if chance(rng, 0.6):
        for k in range(int(rng.integers(1, 4))):
            x = (k - 1) * width * 0.28
            thing = shoes(rng, style) if chance(rng, 0.7) else cardboard(rng, style, 0.24, 0.34, 0.14)
            parts.append(thing.moved(x, 0.08, 0.11))
    return grounded(join(parts))


def coat_hooks(rng: np.random.Generator, style: Style, width: float | None = None) -> Mesh:
    """Draw a wall-mounted board with coats, bags and hats on its hooks.

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
        A mesh whose lowest point is at z = 0, with the board up to 1.3 m above it.
    """
    width = between(rng, 0.5, 1.1) if width is None else width
    wood = style.any_wood(rng)
    parts = [block(wood, (width, 0.02, 0.1), (0, 0, 0), 0.003)]
    count = max(int(width / 0.16), 2)
    for k in range(count):
        x = (k + 0.5 - count / 2) * width / count
        parts.append(tube([(x, 0.02, 0.05), (x, 0.07, 0.04), (x, 0.08, 0.07)], 0.006, 6).of(style.metal))
        use = rng.random()
        if use < 0.55:
            coat = garment(rng, choose(rng, ("coat", "jacket", "jacket"))).turned(90 + rng.normal(0, 8))
            parts.append(coat.scaled(0.7, 1.0, 1.0).moved(x, 0.075, 0.04))
        elif use < 0.7:
            held = bag(rng, style)
            parts.append(held.moved(x, 0.03, 0.05 - float(held.size[2])))
        elif use < 0.8:
            worn = hat(rng, style).turned(-75, "x")
            worn = worn.moved(x, 0.03 - float(worn.low[1]), 0.03 - float(worn.high[2]) / 2)
            parts.append(worn)
    mesh = join(parts)
    return mesh.moved(0, -float(mesh.low[1]), -float(mesh.low[2]))
