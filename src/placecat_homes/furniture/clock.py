"""Wall clocks."""

import numpy as np

from placecat_homes import palette
from placecat_homes.furniture.blocks import between, block, chance, choose, ring
from placecat_homes.materials import Material
from placecat_homes.mesh import Mesh, join
from placecat_homes.shapes import cylinder, lathe
from placecat_homes.style import Style

BLACK = Material((0.05, 0.05, 0.05))


def clock(rng: np.random.Generator, style: Style) -> Mesh:
    """Draw a wall clock.

    Parameters
    ----------
    rng
        Random number generator.
    style
        Style of the home.

    Returns
    -------
    Mesh
        A mesh whose lowest point is at z = 0.
    """
    radius = between(rng, 0.11, 0.2)
    frame = choose(rng, (style.metal, style.wood, palette.paint(rng)))
    face, ink = choose(
        rng, ((palette.WHITE, BLACK), (palette.WHITE, BLACK), (palette.paint(rng), palette.WHITE))
    )
    parts = [cylinder(radius, 0.03, 28, 0.004).of(frame)]
    parts.append(lathe([(radius - 0.015, 0.032), (0, 0.032)], 28).of(face))
    for k, (x, y) in enumerate(ring(radius * 0.82, 12)):
        size = radius * (0.14 if k % 3 == 0 else 0.08)
        mark = block(ink, (size, 0.006, 0.002), (0, -0.003, 0.033)).turned(30 * k)
        parts.append(mark.moved(x * 0.95, y * 0.95))
    for length, width in ((0.5, 0.012), (0.75, 0.008)):
        hand = block(ink, (radius * length, width, 0.002), (radius * length / 2, -width / 2, 0.035))
        parts.append(hand.turned(between(rng, 0, 360)))
    round_clock = join(parts).turned(-90, "x").moved(0, 0, radius)
    if style.modern < 0.4 and chance(rng, 0.3):
        height = radius * 4
        case = block(style.wood, (radius * 2.3, 0.12, height), (0, 0, 0), 0.01)
        door = block(palette.BLACK_GLASS, (radius * 1.5, 0.004, height * 0.4), (0, 0.12, height * 0.08))
        bob = cylinder(radius * 0.35, 0.01, 16, 0).turned(-90, "x").of(style.metal)
        bob = bob.moved(0, 0.126, height * 0.22)
        rod = block(style.metal, (0.01, 0.006, height * 0.22), (0, 0.125, height * 0.24))
        return join(case, door, bob, rod, round_clock.moved(0, 0.11, height - radius * 2.3))
    return round_clock
