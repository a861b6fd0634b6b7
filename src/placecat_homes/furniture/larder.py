"""Tall oven cabinets and open larder shelves for kitchens."""

import numpy as np

from placecat_homes.furniture.blocks import between, block, chance, choose
from placecat_homes.furniture.cookware import pan, pot
from placecat_homes.furniture.dishes import bottle, bowls, plates, shelf_of_dishes
from placecat_homes.furniture.food import bread_box, jar, packets
from placecat_homes.furniture.microwave import microwave
from placecat_homes.furniture.small_appliances import kettle, mixer, toaster
from placecat_homes.mesh import Mesh, join
from placecat_homes.parts.arrange import in_a_row
from placecat_homes.parts.kitchens.cooker import oven_front
from placecat_homes.parts.kitchens.design import SHADOW, Design
from placecat_homes.parts.kitchens.fronts import doors, drawer
from placecat_homes.parts.outlines import textured
from placecat_homes.shapes import box
from placecat_homes.style import Style


def oven_tower(rng: np.random.Generator, style: Style, *, design: Design | None = None) -> Mesh:
    """Draw a tall cabinet with doors, drawers, an oven, and usually a microwave oven above it.

    Parameters
    ----------
    rng
        Random number generator.
    style
        Style of the home.
    design
        Design of the kitchen; chosen at random if None.

    Returns
    -------
    Mesh
        A cabinet about 2 m high.
    """
    looks = design or Design.draw(rng, style)
    w, depth = 0.6, looks.depth
    height = min(max(looks.top, 1.95), 2.25)
    face = depth - 0.022
    parts = [
        block(looks.plinth, (w, depth - 0.05, 0.1)),
        textured(block(looks.side, (w - 0.002, face, height - 0.1), (0, 0, 0.1)), quarter=True),
        block(SHADOW, (w - 0.012, 0.003, height - 0.112), (0, face, 0.106)),
    ]
    z = 0.1
    for tall in (0.3, 0.3):
        parts.append(drawer(looks, w, tall).moved(0, face, z))
        z += tall
    parts.append(oven_front(rng, style, looks.appliance, w, 0.595).moved(0, face, z))
    z += 0.6
    if chance(rng, 0.7):
        machine = microwave(rng, style, width=w - 0.05)
        tall = float(machine.size[2]) + 0.03
        parts.append(machine.moved(0, face - 0.33, z + 0.01))
        z += tall
    parts.append(doors(looks, w, height - z, hinge=choose(rng, (-1, 1)), upper=True).moved(0, face, z))
    return join(parts)


def larder(rng: np.random.Generator, style: Style, *, width: float | None = None) -> Mesh:
    """Draw open shelves full of food, pots and small appliances.

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
        Shelves 1.5 m to 1.9 m high.
    """
    w, depth, height = width or between(rng, 0.6, 1.0), between(rng, 0.34, 0.42), between(rng, 1.5, 1.9)
    wood = style.any_wood(rng) if chance(rng, 0.7) else style.metal
    board = 0.022
    side = textured(box(0.03, depth, height, 0.003), quarter=True).of(wood)
    parts = [side.moved(-w / 2 + 0.015), side.moved(w / 2 - 0.015)]
    levels = np.linspace(0.12, height - board - 0.02, 5)
    pitch = float(levels[1] - levels[0])
    makers = (jar, jar, packets, pot, pan, bottle, plates, bowls, bread_box, kettle, toaster, mixer)
    for k, z in enumerate(levels):
        parts.append(block(wood, (w - 0.06, depth, board), (0, 0, float(z))))
        room = pitch - board - 0.01 if k < len(levels) - 1 else 0.3
        if chance(rng, 0.25):
            row = shelf_of_dishes(rng, style, width=w - 0.1, depth=depth - 0.04, height=room)
        else:
            things = [makers[int(rng.integers(len(makers)))](rng, style) for _ in range(int(w / 0.09))]
            fitting = [t for t in things if float(t.size[2]) < room and float(t.size[1]) < depth - 0.02]
            row = in_a_row(rng, fitting, w - 0.1, depth=depth - 0.03, gap=0.015)
        parts.append(row.moved(0, 0.015, float(z) + board))
    return join(parts)
