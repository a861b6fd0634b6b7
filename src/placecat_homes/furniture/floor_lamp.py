"""Floor lamps."""

import math

import numpy as np

from placecat_homes import palette
from placecat_homes.furniture.blocks import backed, between, chance, choose, leg, ring, shade
from placecat_homes.furniture.ceiling_lamp import BULB, GLOW, light_colour
from placecat_homes.materials import Material
from placecat_homes.mesh import Lamp, Mesh, join
from placecat_homes.shapes import cylinder, lathe, superellipsoid, tube
from placecat_homes.style import Style


def floor_lamp(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a shaded lamp, a tripod lamp, an arc lamp or an uplighter.

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
    return backed(choose(rng, (_shaded, _tripod, _arc, _uplighter))(rng, style))


def _shade(rng: np.random.Generator, height: float) -> Mesh:
    low, tall = between(rng, 0.18, 0.26), between(rng, 0.22, 0.34)
    high = low * between(rng, 0.5, 1.0)
    cloth = GLOW if chance(rng, 0.6) else palette.fabric(rng)
    colour = light_colour(rng)
    bulb = superellipsoid(0.06, 0.06, 0.1, 1, 1, 10).moved(0, 0, tall * 0.3).of(BULB)
    sleeve = join(shade(low, high, tall, cloth), bulb)
    return sleeve.lit(Lamp((0, 0, tall + 0.04), colour, 0.5), Lamp((0, 0, -0.05), colour, 0.3)).moved(
        0, 0, height
    )


def _shaded(rng: np.random.Generator, style: Style) -> Mesh:
    height = between(rng, 1.2, 1.45)
    skin = choose(rng, (style.metal, style.wood, palette.metal(rng)))
    foot = lathe([(0, 0), (0.15, 0), (0.15, 0.015), (0.02, 0.04), (0.012, 0.06), (0, 0.06)], 20)
    pole = cylinder(0.012, height, 8, 0)
    return join(join(foot, pole).of(skin), _shade(rng, height - 0.04))


def _tripod(rng: np.random.Generator, style: Style) -> Mesh:
    height = between(rng, 1.1, 1.3)
    skin = choose(rng, (style.wood, style.second_wood, palette.metal(rng)))
    feet = [leg(p, (p[0] * 0.08, p[1] * 0.08), height, 0.016, 0.012, 8) for p in ring(0.26, 3, math.pi / 6)]
    return join(join(feet).of(skin), _shade(rng, height))


def _arc(rng: np.random.Generator, style: Style) -> Mesh:
    reach, height = between(rng, 0.5, 0.8), between(rng, 1.7, 1.9)
    skin: Material = style.metal
    base = cylinder(0.15, 0.04, 24).of(choose(rng, (palette.stone(rng), skin)))
    path = [(0.0, 0.0, 0.03), (0.0, 0.0, height * 0.55)]
    for a in np.linspace(0, math.pi * 0.8, 9)[1:]:
        x = reach * (1 - math.cos(a)) / (1 - math.cos(math.pi * 0.8))
        path.append((x, 0.0, height * (0.55 + 0.45 * math.sin(a) ** 0.9)))
    end = path[-1]
    arm = tube(path, 0.01, 8).of(skin)
    radius = between(rng, 0.12, 0.18)
    outline = [(radius * math.cos(a), radius * math.sin(a)) for a in np.linspace(0, math.pi / 2, 7)]
    inside = [(max(r - 0.004, 0.0), z - 0.004) for r, z in outline[::-1]]
    dome = lathe([*inside, *outline], 18).of(choose(rng, (skin, palette.paint(rng))))
    glow = lathe([(0, 0), (radius * 0.92, 0)], 18).turned(180, "x").moved(0, 0, 0.02).of(BULB)
    head = join(dome, glow).moved(end[0], 0, end[2] - radius * 0.95)
    lamp = Lamp((end[0], 0.0, end[2] - radius - 0.1), light_colour(rng), 0.6)
    return join(base, arm, head).lit(lamp)


def _uplighter(rng: np.random.Generator, style: Style) -> Mesh:
    height = between(rng, 1.65, 1.85)
    skin = choose(rng, (style.metal, palette.metal(rng)))
    base = cylinder(0.14, 0.025, 22).of(skin)
    pole = cylinder(0.012, height, 8, 0).of(skin)
    bowl = lathe([(0.0, 0.0), (0.08, 0.02), (0.15, 0.09), (0.145, 0.09), (0.0, 0.01)], 20).of(
        skin if chance(rng, 0.5) else GLOW
    )
    glow = lathe([(0.135, 0.075), (0, 0.075)], 20).of(BULB)
    lamp = Lamp((0.0, 0.0, height + 0.15), light_colour(rng), 0.7, 0.08)
    return join(base, pole, join(bowl, glow).moved(0, 0, height)).lit(lamp)
