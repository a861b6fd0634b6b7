"""Emergency exit signs."""

import numpy as np

from placecat_homes.furniture.blocks import between, block, chance
from placecat_homes.materials import Material, Texture
from placecat_homes.mesh import Mesh, join
from placecat_homes.shapes import quad, tube
from placecat_homes.style import Style


def exit_sign(rng: np.random.Generator, style: Style, *, hanging: bool = False) -> Mesh:
    """Draw a green exit sign, usually lit, with its lower edge at z = 0.

    Parameters
    ----------
    rng, style
        Random number generator and style of the home.
    hanging
        Whether to hang a two-sided sign from the ceiling, which is then at z = 0.
    """
    width = between(rng, 0.3, 0.42)
    height = width / 2
    green = (0.0, between(rng, 0.45, 0.6), between(rng, 0.25, 0.4))
    texture = Texture("exit_sign", (green, (0.96, 1.0, 0.97)), (width, height), int(rng.integers(8)))
    face = Material(texture=texture, emission=between(rng, 0.4, 0.9) if chance(rng, 0.8) else 0.0)
    case = block(Material((0.88, 0.88, 0.87)), (width + 0.02, 0.04, height + 0.02), (0, 0, 0), 0.004)
    front = quad(width, height).moved(0, 0.0405, 0.01).of(face)
    if not hanging:
        return join(case, front)
    both = join(case, front, front.turned(180).moved(0, 0.04)).moved(0, -0.02, -height - 0.2)
    rods = [tube([(x, 0, 0), (x, 0, -0.19)], 0.005, 6) for x in (-width / 3, width / 3)]
    return join(both, join(rods).of(Material((0.75, 0.75, 0.75), gloss=0.3)))
