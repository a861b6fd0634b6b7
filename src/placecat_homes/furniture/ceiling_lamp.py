"""Ceiling lamps and pendant lamps."""

import math

import numpy as np

from placecat_homes import palette
from placecat_homes.furniture.blocks import between, block, chance, choose, ring, shade
from placecat_homes.materials import Colour, Material
from placecat_homes.mesh import Lamp, Mesh, join
from placecat_homes.shapes import box, cylinder, lathe, superellipsoid, tube
from placecat_homes.style import Style

GLOW = Material((1.0, 0.93, 0.82), emission=1.6)
"""Backlit glass or fabric."""

BULB = Material((1.0, 0.95, 0.85), emission=4.0)
"""A bulb."""


def light_colour(rng: np.random.Generator) -> Colour:
    """Choose a light colour from warm white to neutral white."""
    warm = rng.random()
    return (1.0, 0.8 + 0.15 * warm, 0.58 + 0.34 * warm)


def ceiling_lamp(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a lamp mounted close to the ceiling.

    Parameters
    ----------
    rng
        Random number generator.
    style
        Style of the home.

    Returns
    -------
    Mesh
        A lamp centred on the z axis, with the ceiling at z = 0.
    """
    designs = (_globe, _drum, _spots, _strip, _bare, _panel)
    modern = style.modern
    return choose(rng, designs, (3, 2, 0.5 + 1.5 * modern, 0.7, 0.7, 2 * modern))(rng, style)


def _globe(rng: np.random.Generator, style: Style) -> Mesh:
    radius, depth = between(rng, 0.14, 0.22), between(rng, 0.08, 0.14)
    angles = np.linspace(-math.pi / 2, 0, 8)
    bowl = lathe([(radius * math.cos(a), depth * math.sin(a) - 0.02) for a in angles], 20).of(GLOW)
    rim = cylinder(radius + 0.012, 0.022, 20).moved(0, 0, -0.022).of(style.metal)
    return join(bowl, rim).lit(Lamp((0, 0, -depth - 0.1), light_colour(rng), 1.0, 0.1))


def _drum(rng: np.random.Generator, style: Style) -> Mesh:
    radius, depth = between(rng, 0.17, 0.26), between(rng, 0.1, 0.18)
    cloth = palette.fabric(rng) if chance(rng, 0.4) else GLOW
    side = shade(radius, radius, depth, cloth, 24)
    glow = lathe([(0, 0.01), (radius - 0.002, 0.01)], 24).turned(180, "x").moved(0, 0, 0.02).of(GLOW)
    body = join(side, glow).moved(0, 0, -depth - 0.015)
    plate = cylinder(0.05, 0.02, 12, 0).moved(0, 0, -0.02).of(style.metal)
    return join(body, plate).lit(Lamp((0, 0, -depth - 0.12), light_colour(rng), 1.0, 0.12))


def _spots(rng: np.random.Generator, style: Style) -> Mesh:
    count, length = int(rng.integers(3, 6)), between(rng, 0.6, 1.3)
    parts = [box(length, 0.05, 0.025, 0.003).moved(0, -0.025, -0.025).of(style.metal)]
    colour = light_colour(rng)
    lamps = []
    for x in np.linspace(-length / 2 + 0.08, length / 2 - 0.08, count):
        head = join(
            lathe([(0, 0.09), (0.02, 0.085), (0.035, 0)][::-1], 12).of(style.metal),
            lathe([(0, 0.012), (0.033, 0.012)], 12).turned(180, "x").moved(0, 0, 0.02).of(BULB),
        )
        tilt, turn = between(rng, 10, 40), between(rng, 0, 360)
        head = head.moved(0, 0, -0.07).turned(tilt, "x").turned(turn).moved(float(x), 0, -0.06)
        parts += [head, tube([(x, 0, -0.02), (x, 0, -0.07)], 0.006, 6).of(style.metal)]
        lamps.append(Lamp((float(x), 0.0, -0.2), colour, 1.1 / count, 0.04))
    return join(parts).lit(*lamps)


def _strip(rng: np.random.Generator, style: Style) -> Mesh:
    length = between(rng, 0.6, 1.25)
    tray = block(palette.WHITE, (length, 0.09, 0.03), (0, -0.045, -0.03))
    cover = superellipsoid(0.07, length, 0.06, 1, 0.15, 12).turned(90).moved(0, 0, -0.065).of(GLOW)
    lamps = [Lamp((x * length, 0.0, -0.14), (1.0, 0.95, 0.88), 0.55, 0.06) for x in (-0.28, 0.28)]
    return join(tray, cover).lit(*lamps)


def _bare(rng: np.random.Generator, style: Style) -> Mesh:
    drop = between(rng, 0.15, 0.5)
    cord = tube([(0, 0, 0), (0, 0, -drop)], 0.004, 6).of(palette.RUBBER)
    socket = cylinder(0.02, 0.06, 10, 0).moved(0, 0, -drop - 0.05).of(palette.RUBBER)
    rose = lathe([(0, 0), (0.02, 0.0), (0.05, 0.03)], 12).moved(0, 0, -0.03).of(palette.WHITE)
    bulb = superellipsoid(0.065, 0.065, 0.1, 1, 1, 12).moved(0, 0, -drop - 0.14).of(BULB)
    return join(cord, socket, rose, bulb).lit(Lamp((0, 0, -drop - 0.2), light_colour(rng), 0.8, 0.03))


def _panel(rng: np.random.Generator, style: Style) -> Mesh:
    width = between(rng, 0.28, 0.5)
    if chance(rng, 0.5):
        rim = cylinder(width / 2, 0.05, 28).moved(0, 0, -0.05).of(style.metal)
        glow = lathe([(0, 0), (width / 2 - 0.015, 0)], 28).turned(180, "x").moved(0, 0, -0.0515).of(GLOW)
    else:
        depth = width * choose(rng, (1.0, 1.0, 0.4))
        rim = block(style.metal, (width, depth, 0.05), (0, -depth / 2, -0.05), 0.004)
        glow = block(GLOW, (width - 0.03, depth - 0.03, 0.004), (0, 0.015 - depth / 2, -0.053))
    return join(rim, glow).lit(Lamp((0, 0, -0.18), light_colour(rng), 1.0, 0.14))


def pendant(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a pendant lamp of the kind used above dining tables.

    Parameters
    ----------
    rng
        Random number generator.
    style
        Style of the home.

    Returns
    -------
    Mesh
        A lamp centred on the z axis, with the ceiling at z = 0.
    """
    drop = between(rng, 0.7, 1.0)
    designs = (_shade, _dome, _ball, _several, _chandelier)
    weights = (2, 2, 1.5, 1 + style.modern, 2 * (1 - style.modern))
    return choose(rng, designs, weights)(rng, style, drop)


def _hung(drop: float, style: Style) -> Mesh:
    cord = tube([(0, 0, 0), (0, 0, -drop)], 0.004, 6).of(palette.RUBBER)
    rose = lathe([(0, 0), (0.03, 0.0), (0.05, 0.03)], 12).moved(0, 0, -0.03).of(style.metal)
    return join(cord, rose)


def _shade(rng: np.random.Generator, style: Style, drop: float) -> Mesh:
    low, depth = between(rng, 0.18, 0.28), between(rng, 0.16, 0.26)
    high = low * between(rng, 0.5, 1.0)
    cloth = palette.fabric(rng) if chance(rng, 0.5) else GLOW
    sleeve = shade(low, high, depth, cloth, 24)
    glow = lathe([(0, 0), (low - 0.004, 0)], 24).turned(180, "x").moved(0, 0, 0.03).of(GLOW)
    lamp = Lamp((0.0, 0.0, -drop - 0.06), light_colour(rng), 0.9, 0.08)
    above = Lamp((0.0, 0.0, -drop + depth + 0.05), lamp.colour, 0.3, 0.08)
    return join(_hung(drop - depth, style), join(sleeve, glow).moved(0, 0, -drop)).lit(lamp, above)


def _dome(rng: np.random.Generator, style: Style, drop: float) -> Mesh:
    radius, depth = between(rng, 0.14, 0.26), between(rng, 0.12, 0.24)
    skin = style.metal if chance(rng, 0.4) else palette.paint(rng)
    power = between(rng, 0.5, 1.2)
    angles = np.linspace(0, math.pi / 2 - 0.12, 8)
    outline = [(radius * math.cos(a) ** power, depth * math.sin(a)) for a in angles]
    inside = [(max(r - 0.004, 0.0), z - 0.004) for r, z in outline[::-1]]
    shell = [*inside, *outline, (0.02, depth + 0.03), (0, depth + 0.03)]
    dome = lathe(shell, 24).of(skin)
    glow = lathe([(0, 0), (radius * 0.9, 0)], 24).turned(180, "x").moved(0, 0, 0.025).of(GLOW)
    lamp = Lamp((0.0, 0.0, -drop - 0.06), light_colour(rng), 1.0, 0.08)
    return join(_hung(drop - depth, style), join(dome, glow).moved(0, 0, -drop)).lit(lamp)


def _ball(rng: np.random.Generator, style: Style, drop: float) -> Mesh:
    size = between(rng, 0.25, 0.45)
    ball = superellipsoid(size, size, size * choose(rng, (1.0, 0.8, 1.0)), 1, 1, 20).of(GLOW)
    lamp = Lamp((0.0, 0.0, -drop - 0.1), light_colour(rng), 1.0, 0.1)
    return join(_hung(drop - size * 0.7, style), ball.moved(0, 0, -drop)).lit(lamp)


def _several(rng: np.random.Generator, style: Style, drop: float) -> Mesh:
    count, pitch = int(rng.integers(2, 4)), between(rng, 0.28, 0.4)
    skin = choose(rng, (style.metal, palette.paint(rng), GLOW))
    low = between(rng, 0.06, 0.11)
    profile = choose(
        rng,
        (
            [(low, 0), (low * 0.9, 0.1), (0.02, 0.2), (0, 0.2)],
            [(low * 0.7, 0), (low * 0.7, 0.22), (0, 0.22)],
            [(low, 0), (0.025, 0.14), (0.025, 0.2), (0, 0.2)],
        ),
    )
    parts = [box((count - 1) * pitch + 0.2, 0.05, 0.025, 0.003).moved(0, -0.025, -0.025).of(style.metal)]
    colour, lamps = light_colour(rng), []
    for k in range(count):
        x = (k - (count - 1) / 2) * pitch
        parts += [
            tube([(x, 0, 0), (x, 0, -drop + 0.18)], 0.003, 6).of(palette.RUBBER),
            lathe(profile, 16).moved(x, 0, -drop).of(skin),
            superellipsoid(0.06, 0.06, 0.06, 1, 1, 10).moved(x, 0, -drop + 0.005).of(BULB),
        ]
        lamps.append(Lamp((x, 0.0, -drop - 0.06), colour, 1.0 / count, 0.05))
    return join(parts).lit(*lamps)


def _chandelier(rng: np.random.Generator, style: Style, drop: float) -> Mesh:
    drop = min(drop, 0.75)
    arms, radius = int(rng.integers(3, 7)), between(rng, 0.2, 0.3)
    shaded = chance(rng, 0.5)
    parts = [_hung(drop - 0.2, style)]
    profile = [(0, 0), (0.02, 0.01), (0.04, 0.06), (0.015, 0.1), (0.03, 0.16), (0.012, 0.22), (0, 0.25)]
    parts.append(lathe(profile, 12).moved(0, 0, -drop).of(style.metal))
    for x, y in ring(radius, arms, between(rng, 0, 3)):
        path = [(x * s, y * s, -drop + z) for s, z in ((0, 0.08), (0.4, 0.0), (0.8, 0.0), (1.0, 0.07))]
        parts.append(tube(path, 0.007, 6).of(style.metal))
        parts.append(cylinder(0.012, 0.06, 8, 0).moved(x, y, -drop + 0.06).of(palette.WHITE))
        if shaded:
            parts.append(shade(0.06, 0.035, 0.1, GLOW, 12).moved(x, y, -drop + 0.1))
        else:
            parts.append(superellipsoid(0.035, 0.035, 0.06, 1, 1, 8).moved(x, y, -drop + 0.12).of(BULB))
    return join(parts).lit(Lamp((0, 0, -drop - 0.08), light_colour(rng), 1.0, 0.15))
