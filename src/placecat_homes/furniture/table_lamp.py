"""Table lamps."""

import numpy as np

from placecat_homes import palette
from placecat_homes.furniture.blocks import backed, between, chance, choose, shade
from placecat_homes.furniture.ceiling_lamp import BULB, GLOW, light_colour
from placecat_homes.mesh import Lamp, Mesh, join
from placecat_homes.shapes import cylinder, lathe, superellipsoid, tube
from placecat_homes.style import Style


def table_lamp(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a lamp for a bedside table, sideboard or desk.

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
    return backed(choose(rng, (_shaded, _shaded, _arm, _ball))(rng, style))


def _shaded(rng: np.random.Generator, style: Style) -> Mesh:
    foot = between(rng, 0.18, 0.3)
    r = between(rng, 0.04, 0.08)
    profile = choose(
        rng,
        (
            [(0, 0), (r, 0), (r, 0.015), (0.012, 0.02), (0.01, foot), (0, foot)],
            [
                (0, 0),
                (r * 0.6, 0),
                (r, foot * 0.35),
                (r * 0.7, foot * 0.7),
                (0.015, foot * 0.9),
                (0.01, foot),
                (0, foot),
            ],
            [
                (0, 0),
                (r, 0),
                (r * 0.4, foot * 0.3),
                (r * 0.7, foot * 0.5),
                (r * 0.25, foot * 0.8),
                (0.01, foot),
                (0, foot),
            ],
            [(0, 0), (r * 0.9, 0), (r * 0.9, foot * 0.7), (0.012, foot * 0.72), (0.01, foot), (0, foot)],
        ),
    )
    skin = choose(rng, (style.metal, palette.ceramic(rng), palette.wood(rng), palette.paint(rng)))
    low, tall = between(rng, 0.1, 0.16), between(rng, 0.14, 0.22)
    high = low * between(rng, 0.45, 1.0)
    cloth = GLOW if chance(rng, 0.6) else palette.fabric(rng)
    sleeve = shade(low, high, tall, cloth, 20).moved(0, 0, foot - 0.01)
    bulb = superellipsoid(0.05, 0.05, 0.08, 1, 1, 10).moved(0, 0, foot).of(BULB)
    colour = light_colour(rng)
    above = Lamp((0.0, 0.0, foot + tall + 0.03), colour, 0.3, 0.06)
    return join(lathe(profile, 16).of(skin), sleeve, bulb).lit(above)


def _arm(rng: np.random.Generator, style: Style) -> Mesh:
    skin = style.metal if chance(rng, 0.4) else palette.paint(rng)
    base = cylinder(0.09, 0.02, 18).of(skin)
    arm = tube([(0, 0, 0.02), (0, -0.08, 0.25), (0, 0.12, 0.46)], 0.007, 8).of(skin)
    head = join(
        lathe([(0.075, 0), (0.06, 0.06), (0.025, 0.11), (0, 0.11)], 16).of(skin),
        lathe([(0, 0), (0.06, 0)], 16).turned(180, "x").moved(0, 0, 0.02).of(BULB),
    )
    head = head.moved(0, 0, -0.06).turned(-25, "x").moved(0, 0.16, 0.43)
    return join(base, arm, head).lit(Lamp((0, 0.22, 0.3), light_colour(rng), 0.3, 0.05))


def _ball(rng: np.random.Generator, style: Style) -> Mesh:
    size = between(rng, 0.14, 0.24)
    base = cylinder(size * 0.35, 0.03, 18).of(choose(rng, (style.metal, style.wood)))
    ball = superellipsoid(size, size, size, 1, 1, 18).moved(0, 0, 0.02).of(GLOW)
    return join(base, ball).lit(Lamp((0, 0, size + 0.1), light_colour(rng), 0.3, 0.06))
