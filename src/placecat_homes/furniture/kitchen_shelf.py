"""Small shelves for kitchen walls."""

import numpy as np

from placecat_homes.furniture.blocks import between, chance, choose
from placecat_homes.furniture.cookware import pot
from placecat_homes.furniture.dishes import cup, shelf_of_dishes
from placecat_homes.furniture.food import jar, packets
from placecat_homes.mesh import Mesh, join
from placecat_homes.parts.arrange import in_a_row
from placecat_homes.shapes import box, tube
from placecat_homes.style import Style


def kitchen_shelf(rng: np.random.Generator, style: Style, *, width: float | None = None) -> Mesh:
    """Draw one or two wall shelves with dishes and jars, and sometimes cups on hooks underneath.

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
        A wall shelf with its lowest point at z = 0.
    """
    w, depth = width or between(rng, 0.6, 1.3), between(rng, 0.16, 0.22)
    wood = style.any_wood(rng)
    board = choose(rng, (0.02, 0.03))
    parts: list[Mesh] = []
    low = 0.14
    for k in range(choose(rng, (1, 2, 2))):
        z = low + 0.33 * k
        parts.append(box(w, depth, board, 0.003).moved(z=z).of(wood))
        for x in (-w / 2 + 0.1, w / 2 - 0.1):
            bracket = tube([(x, 0.006, z - 0.1), (x, 0.02, z - 0.02), (x, depth - 0.03, z - 0.005)], 0.006, 6)
            parts.append(bracket.of(style.metal))
        if chance(rng, 0.6):
            row = shelf_of_dishes(rng, style, width=w - 0.04, depth=depth, height=0.28)
        else:
            things = [
                packets(rng, style, count=2)
                if chance(rng, 0.25)
                else (pot if chance(rng, 0.2) else jar)(rng, style)
                for _ in range(int(w / 0.12))
            ]
            fitting = [thing for thing in things if float(thing.size[1]) < depth + 0.03]
            row = in_a_row(rng, fitting, w - 0.04, depth=depth, gap=0.015)
        parts.append(row.moved(0, 0.004, z + board))
    if chance(rng, 0.5):
        mug = cup(rng, style)
        for x in np.arange(-w / 2 + 0.17, w / 2 - 0.15, 0.12):
            hung = mug.turned(100, "x").turned(float(rng.uniform(-15, 15)))
            parts.append(hung.moved(float(x), 0.1, low - 0.03 - float(hung.high[2])))
            parts.append(tube([(x, 0.1, low), (x, 0.1, low - 0.035)], 0.003, 5).of(style.metal))
    mesh = join(parts)
    return mesh.moved(0.0, max(-float(mesh.low[1]), 0.0), -float(mesh.low[2]))
