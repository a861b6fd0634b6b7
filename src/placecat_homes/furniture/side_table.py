"""Small tables that stand beside a sofa or bed."""

import numpy as np

from placecat_homes.furniture.blocks import between, block, chance, choose, handle, legs
from placecat_homes.furniture.clutter import mug, small_thing
from placecat_homes.furniture.table_lamp import table_lamp
from placecat_homes.mesh import Mesh, join
from placecat_homes.parts.arrange import grounded
from placecat_homes.shapes import cylinder, lathe
from placecat_homes.style import Style


def side_table(
    rng: np.random.Generator, style: Style, height: float | None = None, lamp: bool | None = None
) -> Mesh:
    """Draw a small table with a lamp, a plant or other small objects on top.

    Parameters
    ----------
    rng
        Random number generator.
    style
        Style of the home.
    height
        Height in metres; chosen at random if None.
    lamp
        Whether a lamp stands on it; chosen at random if None.

    Returns
    -------
    Mesh
        A mesh with its base at z = 0.
    """
    height = between(rng, 0.45, 0.62) if height is None else height
    size = between(rng, 0.36, 0.52)
    wood = style.any_wood(rng)
    kind = choose(rng, ("round", "square", "drawer", "stem"))
    if kind == "round":
        table = join(
            cylinder(size / 2, 0.022, 24).moved(0, 0, height - 0.022).of(wood),
            legs(
                choose(rng, ("splayed", "round")),
                size * 0.75,
                size * 0.75,
                height - 0.02,
                style.metal if chance(rng, 0.4) else wood,
                0.035,
            ).moved(0, -size * 0.375, 0),
        )
    elif kind == "stem":
        profile = [
            (0, 0),
            (size * 0.3, 0),
            (size * 0.3, 0.015),
            (0.02, 0.05),
            (0.025, height * 0.5),
            (0.016, height - 0.03),
            (0.05, height - 0.02),
            (0, height - 0.02),
        ]
        table = join(
            cylinder(size / 2, 0.022, 24).moved(0, 0, height - 0.022).of(wood),
            lathe(profile, 14).of(style.metal if chance(rng, 0.4) else wood),
        )
    else:
        table = join(
            block(wood, (size, size, 0.025), (0, -size / 2, height - 0.025), 0.004),
            legs(
                choose(rng, ("square", "tapered")), size - 0.03, size - 0.03, height - 0.025, wood, 0.04
            ).moved(0, 0.015 - size / 2, 0),
        )
        if kind == "drawer":
            table = join(
                table,
                block(wood, (size - 0.06, size - 0.06, 0.12), (0, 0.03 - size / 2, height - 0.145)),
                block(wood, (size - 0.09, 0.012, 0.1), (0, size / 2 - 0.035, height - 0.135), 0.003),
                handle(style.handle, style.metal, 0.1).moved(0, size / 2 - 0.023, height - 0.085),
            )
        elif chance(rng, 0.5):
            table = join(
                table, block(wood, (size - 0.05, size - 0.05, 0.018), (0, 0.025 - size / 2, height * 0.35))
            )
    with_lamp = chance(rng, 0.5) if lamp is None else lamp
    thing = table_lamp(rng, style) if with_lamp else small_thing(rng, style)
    parts = [table, thing.moved(0, -float(thing.size[1]) / 2, height)]
    if chance(rng, 0.4):
        parts.append(mug(rng, style).moved(size * 0.28, size * 0.15, height))
    return grounded(join(parts))
